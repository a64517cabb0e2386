// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FuzzedPolyData.h"

#include "Bytes.h"

#include "vtkCompareDirectionFields.h"
#include "vtkDirectionField.h"
#include "vtkDirectionFieldGlyphs.h"
#include "vtkDirectionFieldSingularities.h"
#include "vtkGuidanceCurves.h"
#include "vtkStripePattern.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <string>
#include <vector>

namespace
{
/// Counts errors and warnings, and keeps them from the screen.
class Listener : public vtkCommand
{
public:
  static Listener* New() { return new Listener; }

  void Listen(vtkAlgorithm* algorithm)
  {
    algorithm->AddObserver(vtkCommand::ErrorEvent, this);
    algorithm->AddObserver(vtkCommand::WarningEvent, this);
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Silence);
  }
  void Execute(vtkObject*, unsigned long event, void*) override
  {
    this->Errors += event == vtkCommand::ErrorEvent ? 1 : 0;
  }

  int Errors = 0;

private:
  class Nothing : public vtkCommand
  {
  public:
    static Nothing* New() { return new Nothing; }
    void Execute(vtkObject*, unsigned long, void*) override {}
  };
  vtkNew<Nothing> Silence;
};

/// Integers of which the last values of a byte make absurd ones.
long long ReadInteger(Bytes& bytes)
{
  constexpr long long absurd[] = { -1, -2, 1000000, 2147483647, -2147483648LL, 4294967296LL };
  const unsigned byte = bytes.Take();
  return byte < 250 ? static_cast<long long>(byte) : absurd[byte - 250];
}

template <typename ArrayT>
vtkSmartPointer<vtkCellArray> ReadCells(Bytes& bytes, unsigned kind, vtkIdType points)
{
  vtkNew<ArrayT> offsets, corners;
  const unsigned cells = bytes.Take() % 40;
  if (kind % 8 == 7)
  {
    // Anything.
    for (unsigned k = 0; k < cells; ++k)
    {
      offsets->InsertNextValue(static_cast<typename ArrayT::ValueType>(ReadInteger(bytes)));
    }
    for (unsigned k = bytes.Take(); k > 0 && !bytes.AtEnd(); --k)
    {
      corners->InsertNextValue(static_cast<typename ArrayT::ValueType>(ReadInteger(bytes)));
    }
  }
  else
  {
    offsets->InsertNextValue(0);
    for (unsigned k = 0; k < cells && !bytes.AtEnd(); ++k)
    {
      const unsigned size = bytes.Take();
      for (unsigned c = size < 200 ? 3 + size % 2 : size % 50; c > 0; --c)
      {
        const long long id = ReadInteger(bytes);
        corners->InsertNextValue(static_cast<typename ArrayT::ValueType>(
          id >= 0 && id < 250 && points > 0 ? id % points : id));
      }
      offsets->InsertNextValue(
        static_cast<typename ArrayT::ValueType>(corners->GetNumberOfTuples()));
    }
  }
  auto array = vtkSmartPointer<vtkCellArray>::New();
  array->SetData(offsets, corners);
  return array;
}

vtkSmartPointer<vtkCellArray> ReadCells(Bytes& bytes, vtkIdType points)
{
  const unsigned kind = bytes.Take();
  if (kind == 0)
  {
    return vtkSmartPointer<vtkCellArray>::New();
  }
  return kind < 128 ? ReadCells<vtkTypeInt64Array>(bytes, kind, points)
                    : ReadCells<vtkTypeInt32Array>(bytes, kind, points);
}

vtkSmartPointer<vtkAbstractArray> NewArray(unsigned type)
{
  switch (type % 8)
  {
    case 1:
      return vtkSmartPointer<vtkFloatArray>::New();
    case 2:
      return vtkSmartPointer<vtkUnsignedCharArray>::New();
    case 3:
      return vtkSmartPointer<vtkIntArray>::New();
    case 4:
      return vtkSmartPointer<vtkStringArray>::New();
    default:
      return vtkSmartPointer<vtkDoubleArray>::New();
  }
}

/// Adds an array to the points, the cells or the whole.
void ReadArray(Bytes& bytes, vtkPolyData* mesh)
{
  constexpr const char* names[] = { "Direction0", "Direction1", "Direction2", "Direction3",
    "RepresentationMagnitude", "vtkGhostType", "SingularityIndex", "OriginalPointIds", "Repairs",
    "Warnings", "IndexSum", "mine", "guidance", "weights", "ConstraintKind" };
  const unsigned place = bytes.Take() % 3;
  auto array = NewArray(bytes.Take());
  const unsigned name = bytes.Take() % 16;
  array->SetName(name < 15 ? names[name] : nullptr);
  const unsigned components = bytes.Take();
  array->SetNumberOfComponents(
    components == 0 ? (name < 4 || name == 12 ? 3 : 1) : static_cast<int>(components % 5));
  const vtkIdType wanted =
    place == 0 ? mesh->GetNumberOfPoints() : (place == 1 ? mesh->GetNumberOfCells() : 1);
  const unsigned tuples = bytes.Take();
  // Cells whose offsets are nothing have no number.
  array->SetNumberOfTuples(std::min<vtkIdType>(
    1000, std::max<vtkIdType>(0, tuples < 200 ? wanted : wanted + tuples - 210)));
  auto* const numbers = vtkDataArray::SafeDownCast(array);
  for (vtkIdType i = 0; numbers && i < numbers->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < numbers->GetNumberOfComponents(); ++c)
    {
      const double number = bytes.AtEnd() ? 0.0 : ReadNumber(bytes);
      // Numbers out of the range of an integer have none.
      const bool fits = numbers->GetDataType() == VTK_DOUBLE ||
        numbers->GetDataType() == VTK_FLOAT || std::abs(number) < 120.0;
      numbers->SetComponent(i, c, fits ? number : 1.0);
    }
  }
  vtkFieldData* const data[] = { mesh->GetPointData(), mesh->GetCellData(), mesh->GetFieldData() };
  data[place]->AddArray(array);
}

vtkSmartPointer<vtkPolyData> ReadMesh(Bytes& bytes)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  const unsigned precision = bytes.Take();
  const unsigned number = bytes.Take() % 100;
  if (precision != 255)
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(
      precision % 4 == 0 ? VTK_FLOAT : (precision % 4 == 1 ? VTK_INT : VTK_DOUBLE));
    for (unsigned i = 0; i < number && !bytes.AtEnd(); ++i)
    {
      DirectionFields::Vector3 point = ReadVector(bytes);
      if (precision % 4 == 1)
      {
        point = point.unaryExpr([](double x) { return std::abs(x) < 1e6 ? 16.0 * x : 0.0; });
      }
      else if (precision % 4 == 0)
      {
        point = point.unaryExpr(
          [](double x) { return std::abs(x) < 1e38 || !std::isfinite(x) ? x : 1e38; });
      }
      points->InsertNextPoint(point.data());
    }
    mesh->SetPoints(points);
  }
  const vtkIdType points = mesh->GetNumberOfPoints();
  mesh->SetPolys(ReadCells(bytes, points));
  mesh->SetStrips(ReadCells(bytes, points));
  mesh->SetLines(ReadCells(bytes, points));
  mesh->SetVerts(ReadCells(bytes, points));
  for (unsigned arrays = bytes.Take() % 8; arrays > 0; --arrays)
  {
    ReadArray(bytes, mesh);
  }
  return mesh;
}

bool IsEmpty(vtkPolyData* output)
{
  return output->GetNumberOfPoints() == 0 && output->GetNumberOfCells() == 0 &&
    output->GetPointData()->GetNumberOfArrays() == 0 &&
    output->GetCellData()->GetNumberOfArrays() == 0;
}

/// The directions of unit length, or zero.
std::string DirectionFlaw(vtkPolyData* field, int degree)
{
  for (int k = 0; k < degree; ++k)
  {
    vtkDataArray* array =
      field->GetPointData()->GetArray(("Direction" + std::to_string(k)).c_str());
    if (!array || array->GetNumberOfTuples() != field->GetNumberOfPoints() ||
      array->GetNumberOfComponents() != 3)
    {
      return "no directions " + std::to_string(k);
    }
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      const double length = vtkMath::Norm(array->GetTuple3(i));
      if (!(length == 0.0 || std::abs(length - 1.0) < 1e-5))
      {
        return "a direction of length " + std::to_string(length);
      }
    }
  }
  return {};
}

std::string FieldFlaw(vtkDirectionField* filter, vtkPolyData* mesh, int errors)
{
  vtkPolyData* field = filter->GetOutput();
  vtkPolyData* singularities = filter->GetOutput(1);
  if (errors > 0)
  {
    return errors == 1 && IsEmpty(field) && IsEmpty(singularities) ? "" : "an error, and a field";
  }
  vtkDataArray* index = field->GetCellData()->GetArray("SingularityIndex");
  if (field->GetNumberOfCells() != mesh->GetNumberOfCells() ||
    field->GetNumberOfPoints() < mesh->GetNumberOfPoints() || !index ||
    index->GetNumberOfTuples() != field->GetNumberOfCells())
  {
    return "a field with other cells or points";
  }
  double sum = 0.0;
  for (vtkIdType i = 0; i < index->GetNumberOfTuples(); ++i)
  {
    sum += index->GetComponent(i, 0);
  }
  vtkDataArray* sums = field->GetFieldData()->GetArray("IndexSum");
  bool ghosts = mesh->GetCellData()->HasArray("vtkGhostType") != 0;
  for (vtkIdType i = 0; sums && i < sums->GetNumberOfTuples() && !ghosts; ++i)
  {
    sum -= sums->GetComponent(i, 0);
  }
  return !ghosts && sum != 0.0 ? "another index sum" : DirectionFlaw(field, filter->GetDegree());
}

/// The first fault of the filters that use a field: an error leaves nothing, and a field is like itself.
std::string UseFlaw(vtkPolyData* mesh)
{
  vtkNew<vtkGuidanceCurves> curves;
  vtkNew<Listener> curvesListener;
  curvesListener->Listen(curves);
  curves->SetInputData(mesh);
  curves->SetCurvesData(mesh);
  curves->SetRadius(0.5);
  curves->Update();
  if (curvesListener->Errors > 1 || (curvesListener->Errors == 1 && !IsEmpty(curves->GetOutput())))
  {
    return "an error, and guidance";
  }
  vtkNew<vtkCompareDirectionFields> comparison;
  vtkNew<Listener> listener;
  listener->Listen(comparison);
  comparison->SetInputData(mesh);
  comparison->SetOtherData(mesh);
  comparison->Update();
  if (listener->Errors > 0)
  {
    return listener->Errors > 1 || !IsEmpty(comparison->GetOutput()) ? "an error, and a comparison"
                                                                     : "";
  }
  vtkDataArray* most = comparison->GetOutput()->GetFieldData()->GetArray("MaximumAngleDifference");
  return most && !(most->GetComponent(0, 0) < 1e-3) ? "a field that is not like itself" : "";
}

/// Whether all points of all cells are somewhere. Points without cells are those of the input.
bool IsSomewhere(vtkPolyData* output)
{
  vtkNew<vtkIdList> ids;
  output->BuildCells();
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    output->GetCellPoints(cell, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      double place[3];
      output->GetPoint(ids->GetId(k), place);
      if (!std::isfinite(place[0]) || !std::isfinite(place[1]) || !std::isfinite(place[2]))
      {
        return false;
      }
    }
  }
  return true;
}

/// The first fault of stripes: an error leaves nothing, and all points are somewhere.
std::string StripesFlaw(vtkPolyData* mesh, unsigned number)
{
  vtkNew<vtkStripePattern> filter;
  vtkNew<Listener> listener;
  listener->Listen(filter);
  filter->SetInputData(mesh);
  filter->SetStripeDirection(static_cast<int>(number % 2));
  filter->SetTextureCoordinates(number / 2 % 2 != 0);
  // Few lines whatever the size, or as many as the number says.
  filter->SetSpacing(number < 128 ? 0.0 : Special(number));
  filter->SetSpacingArray(number % 16 == 3 ? "weights" : nullptr);
  filter->Update();
  for (int port = 0; port < 3; ++port)
  {
    vtkPolyData* output = filter->GetOutput(port);
    if (listener->Errors > 0)
    {
      if (listener->Errors > 1 || !IsEmpty(output))
      {
        return "an error, and stripes";
      }
      continue;
    }
    // Lines and vertices of the input are handed on as they are.
    if (!IsSomewhere(output) && IsSomewhere(mesh))
    {
      return "a stripe that is nowhere";
    }
  }
  return "";
}

/// The first fault of edits of singularities: an error leaves nothing, and balanced indices are those of the surface.
std::string EditFlaw(vtkPolyData* mesh, unsigned kind)
{
  vtkNew<vtkDirectionFieldSingularities> edit;
  vtkNew<Listener> listener;
  listener->Listen(edit);
  edit->SetInputData(mesh);
  edit->SetSingularitiesData(mesh);
  edit->SetSingularityMode(static_cast<int>(kind % 2));
  edit->SetObjective(static_cast<int>(kind / 2 % 2));
  edit->SetBalanceAutomatically(kind / 4 % 2 != 0);
  edit->SetRefineWhereNeeded(kind / 8 % 4 == 3);
  edit->SetKeepConstraints(kind / 32 % 2 == 0);
  edit->Update();
  auto* const output = vtkPolyData::SafeDownCast(edit->GetOutputDataObject(0));
  if (listener->Errors > 0)
  {
    return listener->Errors > 1 || !IsEmpty(output) ? "an error, and an edited field" : "";
  }
  vtkDataArray* const energy = output->GetFieldData()->GetArray("RotationEnergy");
  for (vtkIdType i = 0; energy && i < energy->GetNumberOfTuples(); ++i)
  {
    if (!std::isfinite(energy->GetComponent(i, 0)))
    {
      return "an energy that is not finite";
    }
  }
  return "";
}

std::string GlyphsFlaw(vtkPolyData* mesh, unsigned kind, unsigned number, bool isField)
{
  vtkNew<vtkDirectionFieldGlyphs> filter;
  vtkNew<Listener> listener;
  listener->Listen(filter);
  filter->SetInputData(mesh);
  filter->SetGlyphType(static_cast<int>(kind % 5));
  filter->SetGlyphMode(static_cast<int>(kind / 5 % 2));
  filter->SetFollowSurface(kind / 10 % 2 != 0);
  filter->SetSide(static_cast<int>(kind / 20 % 4));
  filter->SetMaximumNumberOfGlyphs(1 + static_cast<int>(number % 60));
  bool isValid = true;
  if (kind >= 200)
  {
    const double value = Special(number);
    isValid = !std::isnan(value);
    kind % 3 == 0 ? filter->SetScale(value)
                  : (kind % 3 == 1 ? filter->SetSpacing(value) : filter->SetOffset(value));
  }
  filter->Update();
  vtkPolyData* glyphs = filter->GetOutput();
  if (listener->Errors > 0)
  {
    return listener->Errors > 1 || !IsEmpty(glyphs) ? "an error, and glyphs"
      : isField && isValid                          ? "no glyphs of a field"
                                                    : "";
  }
  for (vtkIdType i = 0; i < glyphs->GetNumberOfPoints(); ++i)
  {
    double point[3];
    glyphs->GetPoint(i, point);
    if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2]))
    {
      return "a glyph that is not finite";
    }
  }
  return {};
}
}

std::string FuzzedPolyData(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  vtkNew<vtkDirectionField> filter;
  vtkNew<Listener> listener;
  listener->Listen(filter);
  filter->SetDegree(1 + static_cast<int>((3 + bytes.Take()) % 16));
  const unsigned options = bytes.Take();
  filter->SetAlignment(static_cast<int>(options % 3));
  filter->SetConstrainBoundary(options / 4 % 2 != 0);
  filter->SetConstrainSharpEdges(options / 8 % 2 != 0);
  filter->SetConstrainGuidance(options / 16 % 2 != 0);
  filter->SetIntrinsicDelaunay(options / 32 % 2 != 0);
  filter->SetGuidanceVectors(options / 64 % 2 != 0 ? "guidance" : "Direction0");
  filter->SetGuidanceWeights(options / 128 % 2 != 0 ? "weights" : nullptr);
  filter->SetNumberOfThreads(1);
  const unsigned glyphKind = bytes.Take();
  filter->SetCellDirections(glyphKind % 3 == 1);
  const unsigned glyphNumber = bytes.Take();
  const vtkSmartPointer<vtkPolyData> mesh = ReadMesh(bytes);
  filter->SetInputData(mesh);
  filter->Update();
  std::string flaw = FieldFlaw(filter, mesh, listener->Errors);
  if (flaw.empty() && listener->Errors == 0)
  {
    flaw = GlyphsFlaw(
      filter->GetOutput(), glyphKind, glyphNumber, filter->GetOutput()->GetNumberOfPoints() > 0);
  }
  if (flaw.empty() && listener->Errors == 0)
  {
    flaw = UseFlaw(filter->GetOutput());
  }
  if (flaw.empty() && listener->Errors == 0)
  {
    flaw = StripesFlaw(filter->GetOutput(), glyphNumber);
    flaw = flaw.empty() ? EditFlaw(filter->GetOutput(), glyphKind) : flaw;
  }
  // The mesh's own arrays may be those of a field.
  flaw = flaw.empty() ? GlyphsFlaw(mesh, glyphKind, glyphNumber, false) : flaw;
  flaw = flaw.empty() ? UseFlaw(mesh) : flaw;
  flaw = flaw.empty() ? StripesFlaw(mesh, glyphNumber) : flaw;
  return flaw.empty() ? EditFlaw(mesh, glyphNumber) : flaw;
}
