// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A slider with a number beside it whose changes are not to wait for Apply: `slid` comes while the
 * slider is held and once it is let go, `valueTyped` where the number has been edited. Numbers go
 * evenly from one end to the other, or, for counts and lengths, so that each step is the same part
 * of the value.
 */

#ifndef RowSlider_h
#define RowSlider_h

#include "pqDoubleSliderWidget.h"

class RowSlider : public pqDoubleSliderWidget
{
  Q_OBJECT

public:
  struct Scale
  {
    /// The values at the ends; above 0 where the scale is logarithmic.
    double Low = 0.0;
    double High = 1.0;
    bool IsLogarithmic = false;
    bool IsInteger = false;
    /// Whether the left end of a logarithmic scale is 0, which filters take for automatic.
    bool HasZero = false;
    /// The least and the largest number that can be typed.
    double Minimum = 0.0;
    double Maximum = 1.0;
  };

  RowSlider(const Scale& scale, QWidget* parent);

  int valueToSliderPos(double value) override;
  double sliderPosToValue(int position) override;

signals:
  /// A value of the slider, which may still be held.
  void slid(double value, bool isHeld);

  /// A number that was typed.
  void valueTyped(double value);

private:
  void moved();
  void edited(double value);

  Scale Range;
  double Step = 1.0;
  int Last = 0;
  bool IsFromSlider = false;
};

#endif
