// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSingularityHand.h"

#include <DirectionFields/PrescribedSingularities/SingularityHand.h>

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStaticCellLocator.h"
#include "vtkStringArray.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <exception>
#include <string>

vtkStandardNewMacro(vtkSingularityHand);

namespace
{
using DirectionFields::HandStep;
using DirectionFields::Vector3;

// How far over the surface, relative to the diagonal of its box, a point is looked at: points on
// it would hide themselves.
constexpr double Lift = 1e-3;

/// The faces of the blocks, as triangles.
vtkSmartPointer<vtkPolyData> TrianglesOf(vtkDataObject* input)
{
  vtkNew<vtkAppendPolyData> append;
  if (auto* const composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkSmartPointer<vtkCompositeDataIterator> at;
    at.TakeReference(composite->NewIterator());
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    {
      if (auto* const block = vtkPolyData::SafeDownCast(at->GetCurrentDataObject()))
      {
        append->AddInputData(block);
      }
    }
  }
  else if (auto* const surface = vtkPolyData::SafeDownCast(input))
  {
    append->AddInputData(surface);
  }
  if (append->GetNumberOfInputConnections(0) == 0)
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputConnection(append->GetOutputPort());
  triangulate->PassVertsOff();
  triangulate->PassLinesOff();
  triangulate->Update();
  return triangulate->GetOutput();
}

/// Gives the first process the answer of the one that has the surface.
void SendToFirst(vtkPolyData* answer, bool hasSurface)
{
  vtkMultiProcessController* const controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() == 1)
  {
    return;
  }
  constexpr int tag = 58311;
  const int rank = controller->GetLocalProcessId();
  const int own = hasSurface ? rank : -1;
  int owner = -1;
  controller->AllReduce(&own, &owner, 1, vtkCommunicator::MAX_OP);
  if (owner > 0 && rank == owner)
  {
    controller->Send(answer, 0, tag);
  }
  else if (owner > 0 && rank == 0)
  {
    vtkNew<vtkPolyData> received;
    controller->Receive(received, owner, tag);
    answer->ShallowCopy(received);
  }
}
}

/// An input, and what is made of it.
class vtkSingularityHand::Target
{
public:
  Target(vtkDataObject* input, bool keepsConstraints)
    : Input(input)
    , Time(input->GetMTime())
    , KeepsConstraints(keepsConstraints)
    , Triangles(TrianglesOf(input))
  {
    this->Surface.Points.resize(static_cast<std::size_t>(this->Triangles->GetNumberOfPoints()));
    for (std::size_t i = 0; i < this->Surface.Points.size(); ++i)
    {
      this->Triangles->GetPoint(static_cast<vtkIdType>(i), this->Surface.Points[i].data());
    }
    vtkSmartPointer<vtkCellArrayIterator> cells;
    cells.TakeReference(this->Triangles->GetPolys()->NewIterator());
    for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* corners = nullptr;
      cells->GetCurrentCell(size, corners);
      this->Surface.Triangles.push_back({ static_cast<DirectionFields::Index>(corners[0]),
        static_cast<DirectionFields::Index>(corners[1]),
        static_cast<DirectionFields::Index>(corners[2]) });
    }
    this->Hand = std::make_unique<DirectionFields::SingularityHand>(
      this->Surface, keepsConstraints ? this->Constraints() : std::vector<Vector3>());
    if (this->Triangles->GetNumberOfCells() > 0)
    {
      this->Locator->SetDataSet(this->Triangles);
      this->Locator->BuildLocator();
    }
  }

  bool IsOf(vtkDataObject* input, bool keepsConstraints) const
  {
    return this->Input == input && this->Time == input->GetMTime() &&
      this->KeepsConstraints == keepsConstraints;
  }

  /// The first point of the surface on the way from one point to another.
  bool Hit(const double from[3], const double to[3], double hit[3]) const
  {
    if (this->Triangles->GetNumberOfCells() == 0)
    {
      return false;
    }
    double t = 0.0;
    double coordinates[3];
    int part = 0;
    // Else rays might pass through edges.
    const double close = 1e-6 * this->Triangles->GetLength();
    return this->Locator->IntersectWithLine(from, to, close, t, hit, coordinates, part) != 0;
  }

  /// Whether nothing of the surface is between an eye and a point on it.
  bool IsVisible(const double point[3], const double eye[4]) const
  {
    const double length = this->Triangles->GetLength();
    double away[3];
    double size = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      away[c] = eye[3] == 0.0 ? eye[c] : eye[c] - point[c];
      size += away[c] * away[c];
    }
    size = std::sqrt(size);
    if (!(size > 0.0))
    {
      return false;
    }
    const double far = eye[3] == 0.0 ? 2.0 * length : size;
    double from[3];
    double to[3];
    double hit[3];
    for (int c = 0; c < 3; ++c)
    {
      from[c] = point[c] + away[c] / size * far;
      to[c] = point[c] + away[c] / size * Lift * length;
    }
    return !this->Hit(from, to, hit);
  }

  bool HasSurface() const { return this->Triangles->GetNumberOfCells() > 0; }

  const DirectionFields::SingularityHand& GetHand() const { return *this->Hand; }

private:
  std::vector<Vector3> Constraints() const
  {
    vtkDataArray* const kind = this->Triangles->GetPointData()->GetArray("ConstraintKind");
    vtkDataArray* const direction =
      this->Triangles->GetPointData()->GetArray("ConstraintDirection");
    std::vector<Vector3> constraints;
    if (kind && direction && kind->GetNumberOfComponents() == 1 &&
      direction->GetNumberOfComponents() == 3)
    {
      constraints.assign(this->Surface.Points.size(), Vector3::Zero());
      for (std::size_t i = 0; i < constraints.size(); ++i)
      {
        if (kind->GetComponent(static_cast<vtkIdType>(i), 0) != 0.0)
        {
          direction->GetTuple(static_cast<vtkIdType>(i), constraints[i].data());
        }
      }
    }
    return constraints;
  }

  vtkSmartPointer<vtkDataObject> Input;
  vtkMTimeType Time;
  bool KeepsConstraints;
  vtkSmartPointer<vtkPolyData> Triangles;
  DirectionFields::Surface Surface;
  std::unique_ptr<DirectionFields::SingularityHand> Hand;
  vtkNew<vtkStaticCellLocator> Locator;
};

//------------------------------------------------------------------------------
vtkSingularityHand::vtkSingularityHand() = default;

//------------------------------------------------------------------------------
vtkSingularityHand::~vtkSingularityHand() = default;

//------------------------------------------------------------------------------
void vtkSingularityHand::AddSingularity(double x, double y, double z, double index)
{
  this->List.push_back({ x, y, z, index });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSingularityHand::RemoveAllSingularities()
{
  this->List.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkSingularityHand::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSingularityHand::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const input = vtkDataObject::GetData(inputVector[0], 0);
  vtkPolyData* const output = vtkPolyData::GetData(outputVector, 0);
  try
  {
    if (!this->Last || !this->Last->IsOf(input, this->KeepConstraints))
    {
      this->Last.reset();
      this->Last = std::make_unique<Target>(input, this->KeepConstraints);
    }
    this->Take(*this->Last, output);
  }
  catch (const std::exception& problem)
  {
    this->Last.reset();
    vtkNew<vtkStringArray> note;
    note->SetName("Note");
    note->InsertNextValue(problem.what());
    output->GetFieldData()->AddArray(note);
  }
  SendToFirst(output, this->Last && this->Last->HasSurface());
  return 1;
}

//------------------------------------------------------------------------------
void vtkSingularityHand::Take(Target& target, vtkPolyData* output) const
{
  HandStep step;
  for (const std::array<double, 4>& row : this->List)
  {
    step.Singularities.push_back(
      { Vector3(row[0], row[1], row[2]), static_cast<int>(std::lround(row[3])) });
  }
  Vector3 place = Vector3::Constant(std::nan(""));
  if (!target.Hit(this->Ray, this->Ray + 3, place.data()))
  {
    place.setConstant(std::nan(""));
  }
  const auto which = static_cast<std::size_t>(this->Which);
  switch (this->Step)
  {
    case MOVE:
      step = target.GetHand().Move(step.Singularities, which, place);
      break;
    case MERGE:
      step = target.GetHand().Merge(step.Singularities, which);
      break;
    case ADD:
      step = target.GetHand().Add(step.Singularities, place, this->Index);
      break;
    case ADD_PAIR:
      step = target.GetHand().AddPair(step.Singularities, place, this->Index);
      break;
    default:
      break;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> indices;
  indices->SetName("SingularityIndex");
  vtkNew<vtkUnsignedCharArray> visible;
  visible->SetName("Visible");
  for (const DirectionFields::WantedSingularity& singularity : step.Singularities)
  {
    const vtkIdType id = points->InsertNextPoint(singularity.Position.data());
    cells->InsertNextCell(1, &id);
    indices->InsertNextValue(singularity.Index);
    visible->InsertNextValue(target.IsVisible(singularity.Position.data(), this->Eye) ? 1 : 0);
  }
  vtkNew<vtkStringArray> note;
  note->SetName("Note");
  note->InsertNextValue(step.Note);
  vtkNew<vtkIntArray> isDone;
  isDone->SetName("IsDone");
  isDone->InsertNextValue(step.IsDone ? 1 : 0);
  output->SetPoints(points);
  output->SetVerts(cells);
  output->GetPointData()->AddArray(indices);
  output->GetPointData()->AddArray(visible);
  output->GetFieldData()->AddArray(note);
  output->GetFieldData()->AddArray(isDone);
}

//------------------------------------------------------------------------------
void vtkSingularityHand::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "List: " << this->List.size() << "\n";
  os << indent << "Step: " << this->Step << "\n";
  os << indent << "Which: " << this->Which << "\n";
  os << indent << "Index: " << this->Index << "\n";
  os << indent << "KeepConstraints: " << this->KeepConstraints << "\n";
}
