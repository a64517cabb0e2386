// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkShadedSurface.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <numeric>

vtkStandardNewMacro(vtkShadedSurface);

namespace
{
constexpr double SharpAngle = 60.0;
constexpr const char* Number = "vtkShadedSurfaceNumber";

/// What the points and cells of a surface are made of.
std::array<vtkObject*, 7> PartsOf(vtkPolyData* surface)
{
  return { surface->GetPoints(), surface->GetVerts(), surface->GetLines(), surface->GetPolys(),
    surface->GetStrips(), surface->GetPointGhostArray(), surface->GetCellGhostArray() };
}

void NumberAll(vtkIdType count, vtkDataSetAttributes* data)
{
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName(Number);
  numbers->SetNumberOfValues(count);
  std::iota(numbers->GetPointer(0), numbers->GetPointer(0) + count, 0);
  data->AddArray(numbers);
}

/// For each place of an output the number in the input that it has; null where all have their own.
vtkSmartPointer<vtkIdList> TakeNumbers(vtkIdType count, vtkDataSetAttributes* data)
{
  auto* const numbers = vtkIdTypeArray::SafeDownCast(data->GetAbstractArray(Number));
  bool isSame = numbers && numbers->GetNumberOfValues() == count;
  vtkSmartPointer<vtkIdList> list = vtkSmartPointer<vtkIdList>::New();
  for (vtkIdType i = 0; numbers && i < numbers->GetNumberOfValues(); ++i)
  {
    isSame = isSame && numbers->GetValue(i) == i;
    list->InsertNextId(numbers->GetValue(i));
  }
  data->RemoveArray(Number);
  return isSame ? nullptr : list;
}

/// Whether a list has each of so many numbers.
bool HasAll(vtkIdList* numbers, vtkIdType count)
{
  std::vector<char> isThere(static_cast<std::size_t>(count), 0);
  for (vtkIdType i = 0; i < numbers->GetNumberOfIds(); ++i)
  {
    isThere[static_cast<std::size_t>(numbers->GetId(i))] = 1;
  }
  return std::count(isThere.begin(), isThere.end(), 1) == count;
}

/// An array of the same values as another one, some of them several times, has its ranges, too.
void CopyRanges(vtkDataArray* from, vtkDataArray* to)
{
  vtkInformation* const known = from->GetInformation();
  vtkInformation* const information = to->GetInformation();
  for (vtkInformationDoubleVectorKey* const key :
    { vtkDataArray::L2_NORM_RANGE(), vtkDataArray::L2_NORM_FINITE_RANGE() })
  {
    if (known->Has(key))
    {
      information->CopyEntry(known, key);
    }
  }
  for (vtkInformationInformationVectorKey* const key :
    { vtkAbstractArray::PER_COMPONENT(), vtkAbstractArray::PER_FINITE_COMPONENT() })
  {
    if (known->Has(key))
    {
      information->CopyEntry(known, key, 1);
    }
  }
}

/// Passes arrays on, or copies the values with the numbers of a list.
/// @param isComplete whether the list has all numbers
void PassOn(
  vtkDataSetAttributes* from, vtkIdList* numbers, bool isComplete, vtkDataSetAttributes* to)
{
  if (!numbers)
  {
    to->PassData(from);
    return;
  }
  vtkNew<vtkIdList> places;
  places->SetNumberOfIds(numbers->GetNumberOfIds());
  std::iota(places->GetPointer(0), places->GetPointer(0) + places->GetNumberOfIds(), 0);
  to->CopyAllOn();
  to->CopyAllocate(from, numbers->GetNumberOfIds());
  to->CopyData(from, numbers, places);
  for (int k = 0; isComplete && k < to->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* const array = to->GetArray(k);
    vtkDataArray* const source = array ? from->GetArray(array->GetName()) : nullptr;
    if (source)
    {
      CopyRanges(source, array);
    }
  }
}

}

/// An input's points and cells, and what was made of them.
class vtkShadedSurface::Shape
{
public:
  Shape(vtkPolyData* input, double angle, bool hasGhosts)
    : Angle(angle)
    , HasGhosts(hasGhosts)
  {
    for (vtkObject* const part : PartsOf(input))
    {
      this->Parts.emplace_back(part);
      this->Times.push_back(part ? part->GetMTime() : 0);
    }
    vtkNew<vtkPolyData> bare;
    bare->CopyStructure(input);
    bare->GetPointData()->AddArray(input->GetPointGhostArray());
    bare->GetCellData()->AddArray(input->GetCellGhostArray());
    NumberAll(input->GetNumberOfPoints(), bare->GetPointData());
    NumberAll(input->GetNumberOfCells(), bare->GetCellData());
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(bare);
    normals->SetFeatureAngle(angle);
    normals->ConsistencyOff();
    normals->Update();
    this->Surface->ShallowCopy(normals->GetOutput());
    if (hasGhosts)
    {
      this->Surface->RemoveGhostCells();
    }
    this->OfPoints = TakeNumbers(input->GetNumberOfPoints(), this->Surface->GetPointData());
    this->OfCells = TakeNumbers(input->GetNumberOfCells(), this->Surface->GetCellData());
    this->HasAllPoints = this->OfPoints && HasAll(this->OfPoints, input->GetNumberOfPoints());
    this->HasAllCells = this->OfCells && HasAll(this->OfCells, input->GetNumberOfCells());
  }

  bool IsOf(vtkPolyData* input, double angle, bool hasGhosts) const
  {
    const auto parts = PartsOf(input);
    bool isSame = this->Angle == angle && this->HasGhosts == hasGhosts;
    for (std::size_t k = 0; k < parts.size(); ++k)
    {
      isSame = isSame && this->Parts[k] == parts[k] &&
        this->Times[k] == (parts[k] ? parts[k]->GetMTime() : 0);
    }
    return isSame;
  }

  void Fill(vtkPolyData* input, vtkPolyData* output) const
  {
    output->CopyStructure(this->Surface);
    PassOn(input->GetPointData(), this->OfPoints, this->HasAllPoints, output->GetPointData());
    PassOn(input->GetCellData(), this->OfCells, this->HasAllCells, output->GetCellData());
    if (vtkDataArray* const normals = this->Surface->GetPointData()->GetNormals())
    {
      output->GetPointData()->SetNormals(normals);
    }
  }

  bool IsUsed = true;

private:
  double Angle;
  bool HasGhosts;
  /// Held, so that no new object has the address of an old one.
  std::vector<vtkSmartPointer<vtkObject>> Parts;
  std::vector<vtkMTimeType> Times;
  vtkNew<vtkPolyData> Surface;
  vtkSmartPointer<vtkIdList> OfPoints;
  vtkSmartPointer<vtkIdList> OfCells;
  bool HasAllPoints;
  bool HasAllCells;
};

//------------------------------------------------------------------------------
vtkShadedSurface::vtkShadedSurface()
  : FeatureAngle(SharpAngle)
  , Pass(0)
  , PassTime(0.0)
{
}

//------------------------------------------------------------------------------
vtkShadedSurface::~vtkShadedSurface() = default;

//------------------------------------------------------------------------------
void vtkShadedSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
}

//------------------------------------------------------------------------------
int vtkShadedSurface::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* const output = outputVector->GetInformationObject(0);
  const int levels = output->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
  const int more = output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1 ? 1 : 0;
  inputVector[0]->GetInformationObject(0)->Set(
    Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), levels + more);
  return 1;
}

//------------------------------------------------------------------------------
vtkShadedSurface::Shape& vtkShadedSurface::ShapeOf(vtkPolyData* input, bool hasGhosts, double time)
{
  auto* const pipeline = vtkDemandDrivenPipeline::SafeDownCast(this->GetExecutive());
  const vtkMTimeType pass = pipeline ? pipeline->GetPipelineMTime() : 0;
  if (pass != this->Pass || time != this->PassTime)
  {
    // What the blocks of the last input have not had is of former ones.
    this->Shapes.erase(std::remove_if(this->Shapes.begin(), this->Shapes.end(),
                         [](const auto& shape) { return !shape->IsUsed; }),
      this->Shapes.end());
    for (const auto& shape : this->Shapes)
    {
      shape->IsUsed = false;
    }
    this->Pass = pass;
    this->PassTime = time;
  }
  const auto known = std::find_if(this->Shapes.begin(), this->Shapes.end(),
    [&](const auto& shape) { return shape->IsOf(input, this->FeatureAngle, hasGhosts); });
  if (known == this->Shapes.end())
  {
    this->Shapes.push_back(std::make_unique<Shape>(input, this->FeatureAngle, hasGhosts));
    return *this->Shapes.back();
  }
  (*known)->IsUsed = true;
  return **known;
}

//------------------------------------------------------------------------------
int vtkShadedSurface::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkPolyData* const input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* const output = vtkPolyData::GetData(outputVector);
  if (!input || !output)
  {
    return 0;
  }
  vtkInformation* const info = outputVector->GetInformationObject(0);
  const double time =
    info->Has(Pipeline::UPDATE_TIME_STEP()) ? info->Get(Pipeline::UPDATE_TIME_STEP()) : 0.0;
  const bool hasGhosts = info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1;
  this->ShapeOf(input, hasGhosts, time).Fill(input, output);
  return 1;
}
