// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionFieldRow.h"

#include "LiveProperty.h"
#include "RowSlider.h"
#include "pqLineEdit.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMBooleanDomain.h"
#include "vtkSMDoubleRangeDomain.h"
#include "vtkSMIntRangeDomain.h"
#include "vtkSMIntVectorProperty.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

#include <QCheckBox>
#include <QDoubleValidator>
#include <QHBoxLayout>
#include <QIntValidator>
#include <QLabel>
#include <QVBoxLayout>

#include <cmath>
#include <cstring>

namespace
{
/// The diagonal of the box around the input of a filter, or 1 where that is not known.
double DiagonalOfInput(vtkSMProxy* proxy)
{
  vtkSMProperty* const property = proxy->GetProperty("Input");
  if (!property || vtkSMPropertyHelper(property).GetNumberOfElements() == 0)
  {
    return 1.0;
  }
  const vtkSMPropertyHelper input(property);
  auto* const source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  double bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  if (source)
  {
    source->GetDataInformation(input.GetOutputPort())->GetBounds(bounds);
  }
  const double length =
    std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  return bounds[0] <= bounds[1] && length > 0.0 && std::isfinite(length) ? length : 1.0;
}

/// What the hints of a row and the range of its property say of a slider.
RowSlider::Scale ScaleOf(vtkSMProxy* proxy, vtkSMProperty* property, vtkPVXMLElement* row)
{
  RowSlider::Scale scale;
  int exists = 0;
  if (auto* integers = property->FindDomain<vtkSMIntRangeDomain>())
  {
    scale.IsInteger = true;
    scale.Minimum = integers->GetMinimum(0, exists);
    scale.Maximum = integers->GetMaximum(0, exists);
  }
  else if (auto* numbers = property->FindDomain<vtkSMDoubleRangeDomain>())
  {
    scale.Minimum = numbers->GetMinimum(0, exists);
    scale.Maximum = numbers->GetMaximumExists(0) ? numbers->GetMaximum(0, exists) : 1e300;
  }
  scale.Low = scale.Minimum;
  scale.High = scale.Maximum;
  if (row->GetScalarAttribute("from", &scale.Low) && row->GetScalarAttribute("to", &scale.High))
  {
    scale.IsLogarithmic = true;
    if (strcmp(row->GetAttributeOrEmpty("unit"), "diagonal") == 0)
    {
      const double diagonal = DiagonalOfInput(proxy);
      scale.Low *= diagonal;
      scale.High *= diagonal;
      int zero = 0;
      scale.HasZero = row->GetScalarAttribute("zero", &zero) && zero;
    }
  }
  return scale;
}
}

//------------------------------------------------------------------------------
DirectionFieldRow::DirectionFieldRow(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
  : pqPropertyWidget(proxy, parent)
{
  vtkPVXMLElement* hints = property->GetHints();
  vtkPVXMLElement* row = hints ? hints->FindNestedElementByName("Row") : nullptr;
  const auto words = [row](const char* name)
  { return row ? QString::fromUtf8(row->GetAttributeOrEmpty(name)) : QString(); };
  const QString label = words("label");
  const QString before = label.isEmpty() ? QString(property->GetXMLLabel()) : label;
  const bool isInteger = vtkSMIntVectorProperty::SafeDownCast(property) != nullptr;
  const bool isSwitch = property->FindDomain<vtkSMBooleanDomain>() != nullptr;

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  const bool isSlider = words("slider") == "1";
  // The panel's own label stands in a column, where all editors begin at the same place. A slider
  // stands below its label, as wide as the panel.
  this->setShowLabel(!isSwitch && !isSlider && label.isEmpty());
  auto* line = new QHBoxLayout();
  if (isSlider)
  {
    column->addWidget(new QLabel(before, this));
  }
  else if (!isSwitch && !label.isEmpty())
  {
    line->addWidget(new QLabel(before, this));
  }
  column->addLayout(line);
  QWidget* editor = isSwitch ? this->newSwitch(property, before)
    : isSlider               ? this->newSlider(property, row)
                             : this->newNumber(property, isInteger);
  line->addWidget(editor, 1);
  if (!words("note").isEmpty())
  {
    line->addWidget(new QLabel(words("note"), this));
  }
  if (!words("below").isEmpty())
  {
    auto* below = new QLabel(words("below"), this);
    below->setWordWrap(true);
    below->setEnabled(false);
    column->addWidget(below);
  }
}

//------------------------------------------------------------------------------
QWidget* DirectionFieldRow::newSwitch(vtkSMProperty* property, const QString& text)
{
  auto* box = new QCheckBox(text, this);
  box->setObjectName("CheckBox");
  this->addPropertyLink(box, "checked", SIGNAL(toggled(bool)), property);
  return box;
}

//------------------------------------------------------------------------------
QWidget* DirectionFieldRow::newNumber(vtkSMProperty* property, bool isInteger)
{
  auto* edit = new pqLineEdit(this);
  edit->setObjectName("LineEdit");
  if (isInteger)
  {
    edit->setValidator(new QIntValidator(edit));
  }
  else
  {
    edit->setValidator(new QDoubleValidator(edit));
  }
  this->addPropertyLink(edit, "text2", SIGNAL(textChangedAndEditingFinished()), property);
  return edit;
}

//------------------------------------------------------------------------------
QWidget* DirectionFieldRow::newSlider(vtkSMProperty* property, vtkPVXMLElement* row)
{
  auto* slider = new RowSlider(ScaleOf(this->proxy(), property, row), this);
  slider->setObjectName("DoubleRangeWidget");
  this->addPropertyLink(slider, "value", SIGNAL(valueTyped(double)), property);
  int isSlow = 0;
  row->GetScalarAttribute("slow", &isSlow);
  auto* live = new LiveProperty(this->proxy(), property, isSlow != 0, this);
  this->connect(slider, &RowSlider::slid, live,
    [slider, live](double value, bool isHeld)
    {
      if (live->canChange())
      {
        live->change(value, isHeld);
      }
      else if (!isHeld)
      {
        emit slider->valueTyped(value);
      }
    });
  return slider;
}
