// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionFieldRow.h"

#include "pqDoubleRangeWidget.h"
#include "pqIntRangeWidget.h"
#include "pqLineEdit.h"
#include "vtkPVXMLElement.h"
#include "vtkSMBooleanDomain.h"
#include "vtkSMDoubleRangeDomain.h"
#include "vtkSMIntRangeDomain.h"
#include "vtkSMIntVectorProperty.h"
#include "vtkSMProperty.h"

#include <QCheckBox>
#include <QDoubleValidator>
#include <QHBoxLayout>
#include <QIntValidator>
#include <QLabel>
#include <QVBoxLayout>

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
  auto* line = new QHBoxLayout();
  column->addLayout(line);
  // The panel's own label stands in a column, where all editors begin at the same place.
  this->setShowLabel(!isSwitch && label.isEmpty());
  if (!isSwitch && !label.isEmpty())
  {
    line->addWidget(new QLabel(before, this));
  }
  QWidget* editor = isSwitch ? this->newSwitch(property, before)
    : words("slider") == "1" ? this->newSlider(property, isInteger)
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
QWidget* DirectionFieldRow::newSlider(vtkSMProperty* property, bool isInteger)
{
  int exists = 0;
  if (isInteger)
  {
    auto* range = property->FindDomain<vtkSMIntRangeDomain>();
    auto* slider = new pqIntRangeWidget(this);
    slider->setObjectName("IntRangeWidget");
    slider->setMinimum(range->GetMinimum(0, exists));
    slider->setMaximum(range->GetMaximum(0, exists));
    this->addPropertyLink(slider, "value", SIGNAL(valueEdited(int)), property);
    return slider;
  }
  auto* range = property->FindDomain<vtkSMDoubleRangeDomain>();
  auto* slider = new pqDoubleRangeWidget(this);
  slider->setObjectName("DoubleRangeWidget");
  slider->setMinimum(range->GetMinimum(0, exists));
  slider->setMaximum(range->GetMaximum(0, exists));
  this->addPropertyLink(slider, "value", SIGNAL(valueEdited(double)), property);
  return slider;
}
