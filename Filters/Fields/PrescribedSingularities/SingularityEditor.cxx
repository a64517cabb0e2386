// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PrescribedSingularities/SingularityEditor.h"

#include "Distance/TriangleRuns.h"
#include "PrescribedSingularities/ConstrainedVertices.h"
#include "PrescribedSingularities/SingularityTargets.h"
#include "Support/VectorMath.h"
#include "TrivialConnection/RotationAlignment.h"
#include "TrivialConnection/RotationAtPlace.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

namespace DirectionFields
{
/// The given field, and the data that the edits of each component share.
class SingularityEditor::Components
{
public:
  Components(const Surface& surface, const std::shared_ptr<const FieldSurface>& made,
    const PointDirections& directions, const std::vector<Vector3>& constraints);

  EditedField Edit(const std::vector<WantedSingularity>& wanted, const EditOptions& options,
    const Progress& progress);

  GivenField Base;
  std::vector<Index> FirstPoint;
  std::vector<Complex> Guidance;

private:
  std::vector<std::vector<PrescribedSingularity>> Snapped(
    const std::vector<WantedSingularity>& wanted, bool keepsUnmet, std::vector<std::string>& notes);
  bool HasSingularities(std::size_t component);
  TrivialConnection& GetRotation(std::size_t component);
  const TriangleRuns& GetNearest();
  void EditComponent(std::size_t component, const std::vector<PrescribedSingularity>& singularities,
    const EditOptions& options, const Progress& progress, EditedField& edited);
  void SetSection(std::size_t component, const RotationTarget& target, const TurnedField& field,
    EditedField& edited);

  /// The base, and the given direction where there is one, at each vertex.
  std::vector<Complex> Section;
  /// Not 0 for vertices with a given direction; empty for none.
  std::vector<char> IsGiven;
  /// Whether each component of the base has singularities; empty until it is asked for.
  std::vector<char> IsSingular;
  /// The surface's triangles that the mesh has.
  std::optional<TriangleRuns> Nearest;
  std::vector<std::unique_ptr<TrivialConnection>> Rotations;
};

SingularityEditor::Components::Components(const Surface& surface,
  const std::shared_ptr<const FieldSurface>& made, const PointDirections& directions,
  const std::vector<Vector3>& constraints)
  : Base(surface, made, directions)
  , Section(this->Base.GetSection())
{
  // Where the directions across seams differ, the field has a surface of its own, with the seams.
  if (&this->Base.GetGeometry() == made->Geometry.get())
  {
    this->FirstPoint = made->FirstPoint;
  }
  const TriangleMesh& mesh = this->Base.GetMesh();
  this->Rotations.resize(mesh.GetComponents().size());
  if (constraints.empty())
  {
    return;
  }
  const std::vector<Complex> kept = ConstrainedVertices(this->Base.GetGeometry(), constraints);
  this->IsGiven.resize(mesh.GetNumberOfVertices(), 0);
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (kept[v] != 0.0)
    {
      const double modulus = Modulus(this->Section[v]);
      this->Section[v] =
        (modulus > 0.0 ? modulus : 1.0) * IntegerPower(kept[v], this->Base.GetDegree());
      this->IsGiven[v] = 1;
    }
  }
}

TrivialConnection& SingularityEditor::Components::GetRotation(std::size_t component)
{
  std::unique_ptr<TrivialConnection>& rotation = this->Rotations[component];
  if (!rotation)
  {
    rotation = std::make_unique<TrivialConnection>(this->Base.GetGeometry(),
      this->Base.GetMesh().GetComponents()[component], this->Base.GetDegree(), this->Section,
      this->IsGiven);
  }
  return *rotation;
}

const TriangleRuns& SingularityEditor::Components::GetNearest()
{
  if (!this->Nearest)
  {
    const TriangleMesh& mesh = this->Base.GetMesh();
    LargeArray<Index> order;
    order.reserve(this->Base.GetMeshTriangles().size());
    for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
    {
      if (mesh.IsFront(t))
      {
        order.push_back(mesh.InputTriangle(t));
      }
    }
    this->Nearest.emplace(this->Base.GetSurface(), std::move(order));
  }
  return *this->Nearest;
}

bool SingularityEditor::Components::HasSingularities(std::size_t component)
{
  if (this->IsSingular.empty())
  {
    const auto& components = this->Base.GetMesh().GetComponents();
    const std::vector<int> indices = this->Base.Indices();
    for (const TriangleMesh::Component& part : components)
    {
      this->IsSingular.push_back(static_cast<char>(std::any_of(indices.begin() + part.FirstTriangle,
        indices.begin() + part.EndTriangle, [](int index) { return index != 0; })));
    }
  }
  return this->IsSingular[component] != 0;
}

std::vector<std::vector<PrescribedSingularity>> SingularityEditor::Components::Snapped(
  const std::vector<WantedSingularity>& wanted, bool keepsUnmet, std::vector<std::string>& notes)
{
  const TriangleMesh& mesh = this->Base.GetMesh();
  std::vector<std::vector<PrescribedSingularity>> snapped(mesh.GetComponents().size());
  for (const WantedSingularity& singularity : wanted)
  {
    if (!singularity.Position.allFinite())
    {
      const char* const reason =
        "A singularity has coordinates that are not finite. Give each a place on the surface.";
      if (!keepsUnmet)
      {
        throw std::invalid_argument(reason);
      }
      notes.emplace_back(reason);
      continue;
    }
    const ClosestPoints::Answer found = this->GetNearest().Find(singularity.Position);
    if (singularity.Index == 0 || found.Triangle == None)
    {
      continue;
    }
    PrescribedSingularity prescribed{ {}, singularity.Index };
    prescribed.Place.Triangle = this->Base.GetMeshTriangles()[found.Triangle];
    for (int c = 0; c < 3; ++c)
    {
      const int corner = this->Base.MeshCorner(prescribed.Place.Triangle, c);
      prescribed.Place.Weights[corner == None ? c : corner] = found.Weights[c];
    }
    const auto& components = mesh.GetComponents();
    const auto after =
      std::upper_bound(components.begin(), components.end(), prescribed.Place.Triangle,
        [](Index t, const TriangleMesh::Component& component)
        { return t < component.FirstTriangle; });
    snapped[static_cast<std::size_t>(after - components.begin()) - 1].push_back(prescribed);
  }
  return snapped;
}

EditedField SingularityEditor::Components::Edit(const std::vector<WantedSingularity>& wanted,
  const EditOptions& options, const Progress& progress)
{
  EditedField edited;
  edited.Section = this->Base.GetSection();
  const auto snapped = this->Snapped(wanted, options.KeepsUnmet, edited.Notes);
  edited.Components.resize(snapped.size());
  progress.Report(0.1);
  const double perComponent = 0.9 / static_cast<double>(std::max<std::size_t>(1, snapped.size()));
  for (std::size_t c = 0; c < snapped.size(); ++c)
  {
    if (snapped[c].empty() && !(options.IsWholeList && this->HasSingularities(c)))
    {
      continue;
    }
    const double begin = 0.1 + perComponent * static_cast<double>(c);
    try
    {
      this->EditComponent(
        c, snapped[c], options, progress.Part(begin, begin + perComponent), edited);
    }
    catch (const std::invalid_argument& problem)
    {
      if (!options.KeepsUnmet)
      {
        throw;
      }
      edited.Components[c].IsUnmet = true;
      edited.Notes.emplace_back(problem.what());
    }
  }
  if (!edited.WrongTriangles.empty())
  {
    edited.Notes.push_back(std::to_string(edited.WrongTriangles.size()) +
      " triangles have other indices than was asked for: the mesh is too coarse there for the field to turn that "
      "much. Turn Refine Where Needed on, subdivide the mesh, or move the singularities apart.");
  }
  return edited;
}

void SingularityEditor::Components::EditComponent(std::size_t component,
  const std::vector<PrescribedSingularity>& singularities, const EditOptions& options,
  const Progress& progress, EditedField& edited)
{
  const TriangleMesh& mesh = this->Base.GetMesh();
  const TriangleMesh::Component& part = mesh.GetComponents()[component];
  TrivialConnection& rotation = this->GetRotation(component);
  const RotationTarget target = MakeTarget(this->Base.GetGeometry(), part, this->Base.GetDegree(),
    rotation, this->Base.GetGeometry().Positions, singularities, options, edited.Notes);
  EditedComponent& report = edited.Components[component];
  const bool aligns = options.AlignmentStrength > 0.0 && !this->Guidance.empty();
  TurnedField field = rotation.Turn(target, progress.Part(0.0, aligns ? 0.5 : 1.0));
  if (aligns)
  {
    const ComplexVector guidance =
      Eigen::Map<const ComplexVector>(this->Guidance.data() + part.FirstVertex, part.Vertices());
    report.AlignmentShare = AlignField(rotation, target, guidance,
      StrengthOf(options.AlignmentStrength, this->Base.GetDegree(), rotation.GetSolver().GetArea()),
      progress.Part(0.5, 1.0), field);
  }
  report.Energy = field.Energy;
  report.Residual = field.Residual;
  report.TurningNumbers = field.TurningNumbers;
  for (const double angle : field.Rotation)
  {
    report.MaximumRotation = std::max(report.MaximumRotation, std::abs(angle) / Pi);
  }
  for (const Index t : rotation.WrongTriangles(target, field))
  {
    if (mesh.IsFront(part.FirstTriangle + t))
    {
      edited.WrongTriangles.push_back(part.FirstTriangle + t);
      ++report.WrongTriangles;
    }
  }
  if (field.KeepsTurningNumbers)
  {
    edited.Notes.push_back("A component has more than " +
      std::to_string(TrivialConnection::MostLoops) +
      " loops: the field turns along them as the given one does, which may be more than it would have to.");
  }
  this->SetSection(component, target, field, edited);
}

void SingularityEditor::Components::SetSection(std::size_t component, const RotationTarget& target,
  const TurnedField& field, EditedField& edited)
{
  const TriangleMesh& mesh = this->Base.GetMesh();
  const TriangleMesh::Component& part = mesh.GetComponents()[component];
  const TrivialConnection& rotation = *this->Rotations[component];
  const bool keeps = target.Objective == RotationObjective::LeastChange;
  if (keeps && field.Turn.cwiseAbs().maxCoeff() == 0.0)
  {
    return;
  }
  edited.Components[component].IsChanged = true;
  const ComplexVector section = rotation.SectionOf(field);
  for (Index v = part.FirstVertex; v < part.EndVertex; ++v)
  {
    const double modulus = keeps ? Modulus(this->Section[v]) : 1.0;
    edited.Section[v] = (modulus > 0.0 ? modulus : 1.0) * section[v - part.FirstVertex];
  }
  if (keeps)
  {
    return;
  }
  // Moduli grow with the distance from a singularity in the triangle, so that interpolation
  // vanishes there.
  for (const MeshPlace& place : target.Places)
  {
    if (target.Indices[place.Triangle - part.FirstTriangle] == 0)
    {
      continue;
    }
    const FlatTriangle flat(this->Base.GetGeometry(), place.Triangle);
    const Complex at = flat.Place(WithinTriangle(place.Weights));
    double farthest = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      farthest = std::max(farthest, std::abs(flat.Corner(c) - at));
    }
    for (int c = 0; c < 3; ++c)
    {
      edited.Section[mesh.Tail(3 * place.Triangle + c)] *= std::abs(flat.Corner(c) - at) / farthest;
    }
  }
}

SingularityEditor::SingularityEditor(const Surface& surface, const PointDirections& directions,
  const std::vector<Vector3>& constraints)
  : Cache(std::make_unique<Components>(
      surface, std::make_shared<const FieldSurface>(surface), directions, constraints))
{
}

SingularityEditor::~SingularityEditor() = default;
SingularityEditor::SingularityEditor(SingularityEditor&&) noexcept = default;
SingularityEditor& SingularityEditor::operator=(SingularityEditor&&) noexcept = default;

const GivenField& SingularityEditor::GetBase() const
{
  return this->Cache->Base;
}

const std::vector<Index>& SingularityEditor::GetFirstPoints() const
{
  return this->Cache->FirstPoint;
}

std::vector<WantedSingularity> SingularityEditor::GetOwnSingularities() const
{
  const GivenField& base = this->GetBase();
  const std::vector<int> indices = base.Indices();
  std::vector<WantedSingularity> own;
  for (Index t = 0; t < static_cast<Index>(indices.size()); ++t)
  {
    if (indices[t] == 0 || !base.GetMesh().IsFront(t))
    {
      continue;
    }
    // Divided first: the sum of the largest coordinates would overflow.
    WantedSingularity singularity{ Vector3::Zero(), indices[t] };
    for (const Index i : base.GetSurface().Triangles[base.GetMesh().InputTriangle(t)])
    {
      singularity.Position += base.GetSurface().Points[i] / 3.0;
    }
    own.push_back(singularity);
  }
  return own;
}

void SingularityEditor::SetGuidance(std::vector<Complex> guidance)
{
  this->Cache->Guidance = std::move(guidance);
}

EditedField SingularityEditor::Edit(const std::vector<WantedSingularity>& wanted,
  const EditOptions& options, const Progress& progress)
{
  return this->Cache->Edit(wanted, options, progress);
}
}
