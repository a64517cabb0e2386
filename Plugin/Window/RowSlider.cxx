// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "RowSlider.h"

#include "pqDoubleLineEdit.h"

#include <QDoubleValidator>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace
{
constexpr int POSITIONS = 1000;

/// 1, 2 or 5 times a power of ten, so that values of the slider have few digits; at least `value`.
double RoundStep(double value)
{
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : { 1.0, 2.0, 5.0 })
  {
    if (factor * power >= value * (1.0 - 1e-9))
    {
      return factor * power;
    }
  }
  return 10.0 * power;
}

double ThreeDigits(double value)
{
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  return unit < 1.0 ? std::round(value / unit) / std::round(1.0 / unit)
                    : std::round(value / unit) * unit;
}
}

//------------------------------------------------------------------------------
RowSlider::RowSlider(const Scale& scale, QWidget* parent)
  : pqDoubleSliderWidget(parent)
  , Range(scale)
  , Last(POSITIONS)
{
  if (!scale.IsLogarithmic)
  {
    this->Step = RoundStep((scale.High - scale.Low) / POSITIONS);
    this->Last = static_cast<int>(std::round((scale.High - scale.Low) / this->Step));
  }
  this->setSliderRange(0, this->Last);
  this->setValidator(new QDoubleValidator(scale.Minimum, scale.Maximum, 100, this));
  auto* const number = this->findChild<pqDoubleLineEdit*>();
  // The slider has the rest of the panel's width.
  number->setMaximumWidth(number->fontMetrics().horizontalAdvance("00000000000"));
  auto* const slider = this->findChild<QSlider*>();
  // Behind the slots of the base class, which set the value.
  this->connect(slider, &QSlider::valueChanged, this, &RowSlider::moved);
  this->connect(this, &pqDoubleSliderWidget::valueEdited, this, &RowSlider::edited);
}

//------------------------------------------------------------------------------
int RowSlider::valueToSliderPos(double value)
{
  // The base class asks for this where the value comes from somewhere else.
  this->IsFromSlider = false;
  if (!this->Range.IsLogarithmic)
  {
    return static_cast<int>(std::round(
      (std::clamp(value, this->Range.Low, this->Range.High) - this->Range.Low) / this->Step));
  }
  if (value <= 0.0)
  {
    return 0;
  }
  const double part =
    std::log(std::clamp(value, this->Range.Low, this->Range.High) / this->Range.Low) /
    std::log(this->Range.High / this->Range.Low);
  const int first = this->Range.HasZero ? 1 : 0;
  return first + static_cast<int>(std::round(part * (this->Last - first)));
}

//------------------------------------------------------------------------------
double RowSlider::sliderPosToValue(int position)
{
  this->IsFromSlider = true;
  if (!this->Range.IsLogarithmic)
  {
    // A quotient of whole numbers has the digits that the step has.
    const double steps = std::round(this->Range.Low / this->Step) + position;
    const double value =
      this->Step < 1.0 ? steps / std::round(1.0 / this->Step) : steps * this->Step;
    return std::clamp(value, this->Range.Low, this->Range.High);
  }
  const int first = this->Range.HasZero ? 1 : 0;
  if (position < first)
  {
    return 0.0;
  }
  const double part = static_cast<double>(position - first) / (this->Last - first);
  const double value =
    ThreeDigits(this->Range.Low * std::pow(this->Range.High / this->Range.Low, part));
  return this->Range.IsInteger ? std::round(value) : value;
}

//------------------------------------------------------------------------------
void RowSlider::moved()
{
  const bool isHeld = this->findChild<QSlider*>()->isSliderDown();
  if (this->IsFromSlider && isHeld)
  {
    emit this->slid(this->value(), true);
  }
}

//------------------------------------------------------------------------------
void RowSlider::edited(double value)
{
  if (this->IsFromSlider)
  {
    emit this->slid(value, false);
  }
  else
  {
    emit this->valueTyped(value);
  }
}
