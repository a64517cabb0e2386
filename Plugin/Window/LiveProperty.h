// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Changes one property of a filter at once, without Apply and without what else waits for Apply,
 * and shows the views again: while a slider is held, at each move where that takes less than a
 * fifth of a second, or else at each pause. All changes until the slider is let go are one step to
 * undo, and one line of a trace.
 */

#ifndef LiveProperty_h
#define LiveProperty_h

#include "vtkSMProperty.h"
#include "vtkSMProxy.h"
#include "vtkWeakPointer.h"

#include <QObject>
#include <QTimer>

class LiveProperty : public QObject
{
  Q_OBJECT

public:
  /// `isSlow` says that a change is to wait for a pause until it is known how long one takes.
  LiveProperty(vtkSMProxy* proxy, vtkSMProperty* property, bool isSlow, QObject* parent);
  ~LiveProperty() override;

  /// Whether the filter has been applied.
  bool canChange() const;

  /// A value of the slider, which may still be held.
  void change(double value, bool isHeld);

private:
  void apply();
  void finish();

  vtkWeakPointer<vtkSMProxy> Proxy;
  vtkWeakPointer<vtkSMProperty> Property;
  QTimer Timer;
  double Value = 0.0;
  bool IsSlow;
  bool HasBegun = false;
};

#endif
