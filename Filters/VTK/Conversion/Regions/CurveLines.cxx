// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Regions/CurveLines.h"

#include "Conversion/Input/PolyDataCheck.h"

#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace DirectionFields
{
namespace
{
/// Appends the lines of polydata.
void AddLines(vtkPolyData* polyData, Curves& curves)
{
  CheckPolyData(polyData);
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < polyData->GetNumberOfLines(); ++i)
  {
    polyData->GetLines()->GetCellAtId(i, ids);
    std::vector<Vector3> curve(static_cast<std::size_t>(ids->GetNumberOfIds()));
    for (std::size_t k = 0; k < curve.size(); ++k)
    {
      polyData->GetPoints()->GetPoint(ids->GetId(static_cast<vtkIdType>(k)), curve[k].data());
      if (!curve[k].allFinite())
      {
        throw std::invalid_argument("Point " +
          std::to_string(ids->GetId(static_cast<vtkIdType>(k))) +
          " of the second input, the curves, has a coordinate that is NaN or infinite. Remove it "
          "with its line.");
      }
    }
    curves.push_back(std::move(curve));
  }
}
}

Curves LinesOf(vtkDataObject* data)
{
  Curves curves;
  if (auto* const polyData = vtkPolyData::SafeDownCast(data))
  {
    AddLines(polyData, curves);
  }
  else if (auto* const composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkSmartPointer<vtkCompositeDataIterator> blocks;
    blocks.TakeReference(composite->NewIterator());
    for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
    {
      if (auto* const block = vtkPolyData::SafeDownCast(blocks->GetCurrentDataObject()))
      {
        AddLines(block, curves);
      }
    }
  }
  return curves;
}
}
