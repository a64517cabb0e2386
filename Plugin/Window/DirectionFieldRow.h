// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A row of the panel for one number or switch, with words of its own. ParaView names properties in
 * scripts by their labels, so that a label cannot say more than the name; the hints of the property
 * can:
 *
 *   <IntVectorProperty name="Degree" panel_widget="direction_field_row" ...>
 *     <Hints>
 *       <Row label="Directions per point" note="0 = automatic" below="..." slider="1" />
 *     </Hints>
 *   </IntVectorProperty>
 *
 * label   the words before the editor, or those of a switch, in place of the property's label
 * note    the words behind the editor, such as a unit
 * below   the words below the editor
 * slider  1 for a slider below the label, whose changes are shown while it is held (RowSlider,
 *         LiveProperty); over the range of the property, or else
 * from    and `to`: the ends of a logarithmic slider
 * unit    "diagonal" where these are parts of the diagonal of the input's box, as for lengths
 * zero    1 where the left end of such a slider is 0, for automatic
 * slow    1 where a change is to wait for a pause, until it is known how long one takes
 */

#ifndef DirectionFieldRow_h
#define DirectionFieldRow_h

#include "pqPropertyWidget.h"

class vtkPVXMLElement;

class DirectionFieldRow : public pqPropertyWidget
{
  Q_OBJECT

public:
  DirectionFieldRow(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);

private:
  QWidget* newSwitch(vtkSMProperty* property, const QString& text);
  QWidget* newNumber(vtkSMProperty* property, bool isInteger);
  QWidget* newSlider(vtkSMProperty* property, vtkPVXMLElement* row);
};

#endif
