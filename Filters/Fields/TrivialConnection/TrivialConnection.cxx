// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrivialConnection/TrivialConnection.h"

#include "Interpolation/InterpolantZero.h"
#include "Sections/DoubleCover.h"
#include "Sections/Singularities.h"
#include "Support/Threads.h"
#include "Support/VectorMath.h"
#include "TrivialConnection/LoopHolonomies.h"
#include "TrivialConnection/RotationAtPlace.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Phases are exact vertex values whatever the residual is; it only tells how close to the least
/// energy the field is.
constexpr double Tolerance = 1e-6;
/// Most attempts to bound the rotation where the least one is too large.
constexpr int MostRepairs = 16;

/// A set rotation may be exceeded by this much.
constexpr double Rounding = 1e-6;
double Wrapped(double angle)
{
  return angle - 2.0 * Pi * std::round(angle / (2.0 * Pi));
}
}

TrivialConnection::TrivialConnection(const IntrinsicGeometry& geometry,
  const TriangleMesh::Component& component, int degree, const std::vector<Complex>& base,
  const std::vector<char>& isGiven)
  : Geometry(geometry)
  , Component(component)
  , Degree(degree)
  , Base(base.begin() + component.FirstVertex, base.begin() + component.EndVertex)
  , Forms(geometry, component)
  , Constrained(geometry.Mesh, component, isGiven)
  , BaseRotation(PhaseDifferences(geometry, component, degree, this->Base.data()))
  , BaseIndices(SingularityIndices(geometry, component, degree, this->Base.data()))
  , Trees(this->Forms, this->Constrained)
{
}

const PoissonSolver& TrivialConnection::GetSolver()
{
  if (!this->Solver)
  {
    this->Solver.emplace(this->Forms, this->Constrained);
  }
  return *this->Solver;
}

double TrivialConnection::Holonomy(Index localTriangle) const
{
  return this->Degree *
    this->Geometry.Transport.Curvature[this->Component.FirstTriangle + localTriangle];
}

Eigen::VectorXd TrivialConnection::SolveFor(const EdgeForm& form, Eigen::VectorXd guess,
  const MergedUnknowns* merged, const Progress& progress, double& residual)
{
  const PoissonSolver& solver = this->GetSolver();
  const Eigen::VectorXd inflow = solver.Gathered(this->Forms.Inflow(form));
  PoissonSolver::Problem problem{ inflow };
  problem.Merged = merged;
  problem.Tolerance = Tolerance;
  problem.Progress = progress;
  if (guess.size() == 0)
  {
    guess = Eigen::VectorXd::Zero(solver.NumberOfUnknowns());
  }
  if (merged)
  {
    merged->Satisfy(guess);
  }
  residual = solver.Solve(problem, guess);
  return guess;
}

const TrivialConnection::Harmonic& TrivialConnection::GetHarmonic(const Progress& progress)
{
  if (this->Cache)
  {
    return *this->Cache;
  }
  Harmonic harmonic;
  const std::size_t count = this->Trees.GetGenerators().size();
  harmonic.Products.resize(static_cast<Index>(count), static_cast<Index>(count));
  for (std::size_t j = 0; j < count; ++j)
  {
    harmonic.Forms.push_back(this->Trees.FormOf(j));
    EdgeForm form(this->Component.Edges(), 0.0);
    for (const TreeCotree::Term& term : harmonic.Forms[j])
    {
      form[term.Edge] = term.Value;
    }
    double residual = 0.0;
    harmonic.Potentials.push_back(this->SolveFor(form, {}, nullptr, progress, residual));
    this->Forms.SubtractRise(this->GetSolver().Spread(harmonic.Potentials[j]), form);
    for (std::size_t i = 0; i <= j; ++i)
    {
      double product = 0.0;
      for (const TreeCotree::Term& term : harmonic.Forms[i])
      {
        product += this->Forms.Weight(term.Edge) * term.Value * form[term.Edge];
      }
      harmonic.Products(static_cast<Index>(i), static_cast<Index>(j)) = product;
      harmonic.Products(static_cast<Index>(j), static_cast<Index>(i)) = product;
    }
  }
  this->Cache = std::move(harmonic);
  return *this->Cache;
}

void TrivialConnection::ChooseTurning(
  EdgeForm& form, Eigen::VectorXd& potential, const Progress& progress)
{
  const Harmonic& harmonic = this->GetHarmonic(progress);
  const auto count = static_cast<Index>(harmonic.Forms.size());
  EdgeForm rotation = form;
  this->Forms.SubtractRise(this->GetSolver().Spread(potential), rotation);
  Eigen::VectorXd slope(count);
  for (Index j = 0; j < count; ++j)
  {
    slope[j] = 0.0;
    for (const TreeCotree::Term& term : harmonic.Forms[j])
    {
      slope[j] += this->Forms.Weight(term.Edge) * term.Value * rotation[term.Edge] / (2.0 * Pi);
    }
  }
  const Eigen::VectorXi turns = NearestIntegers(harmonic.Products, slope);
  for (Index j = 0; j < count; ++j)
  {
    if (turns[j] != 0)
    {
      for (const TreeCotree::Term& term : harmonic.Forms[j])
      {
        form[term.Edge] += 2.0 * Pi * turns[j] * term.Value;
      }
      potential += 2.0 * Pi * turns[j] * harmonic.Potentials[j];
    }
  }
}

std::optional<std::array<double, 3>> TrivialConnection::RotationsAt(
  const RotationTarget& target, Index localTriangle, const MeshPlace* place) const
{
  const Index triangle = this->Component.FirstTriangle + localTriangle;
  const int index = target.Indices[localTriangle];
  if (target.Objective == RotationObjective::LeastChange &&
    index == this->BaseIndices[localTriangle] && (!place || RotationRepair::IsMiddle(*place)))
  {
    return std::array<double, 3>{ this->Forms.Along(this->BaseRotation, 3 * triangle),
      this->Forms.Along(this->BaseRotation, 3 * triangle + 1),
      this->Forms.Along(this->BaseRotation, 3 * triangle + 2) };
  }
  const FlatTriangle flat(this->Geometry, triangle);
  std::array<double, 3> weights = { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 };
  if (place)
  {
    weights = place->Weights;
  }
  else if (index != 0 && index == this->BaseIndices[localTriangle])
  {
    const FieldInterpolant interpolant(
      this->Geometry, this->Degree, this->Base.data() - this->Component.FirstVertex, triangle);
    weights = flat.Weights(FindZero(interpolant, index > 0 ? 1 : -1).Place);
  }
  return RotationAround(flat, weights, index, this->Holonomy(localTriangle));
}

/// Joins the corners of a triangle by the base's rotations along its edges.
void TrivialConnection::JoinAsBase(
  Index localTriangle, const EdgeForm& form, MergedUnknowns& sets) const
{
  const TriangleMesh& mesh = this->Geometry.Mesh;
  const Index first = 3 * (this->Component.FirstTriangle + localTriangle);
  for (Index h = first; h < first + 3; ++h)
  {
    sets.Join(this->Constrained.UnknownOf(mesh.Tail(h) - this->Component.FirstVertex),
      this->Constrained.UnknownOf(mesh.Head(h) - this->Component.FirstVertex),
      this->Forms.Along(form, h) - this->Forms.Along(this->BaseRotation, h));
  }
}

MergedUnknowns TrivialConnection::MergeSingular(const RotationTarget& target, const EdgeForm& form,
  const std::vector<RotationSetting>& settings, const std::vector<SetEdge>& edges,
  const Eigen::VectorXd* givenValues) const
{
  const TriangleMesh& mesh = this->Geometry.Mesh;
  MergedUnknowns sets(this->Constrained.NumberOfUnknowns);
  const std::vector<Index>& given = this->Constrained.GivenUnknowns;
  for (std::size_t g = 1; givenValues && g < given.size(); ++g)
  {
    const double difference = (*givenValues)[given[g]] - (*givenValues)[given[0]];
    sets.Join(given[0], given[g], 2.0 * Pi * std::round(difference / (2.0 * Pi)));
  }
  const auto add = [&](Index localTriangle, const MeshPlace* place)
  {
    const Index first = 3 * (this->Component.FirstTriangle + localTriangle);
    std::array<Index, 3> corner;
    for (int c = 0; c < 3; ++c)
    {
      corner[c] = this->Constrained.UnknownOf(mesh.Tail(first + c) - this->Component.FirstVertex);
    }
    if (sets.AreJoined(corner[0], corner[1]) || sets.AreJoined(corner[1], corner[2]) ||
      sets.AreJoined(corner[2], corner[0]))
    {
      return;
    }
    if (const auto rotation = this->RotationsAt(target, localTriangle, place))
    {
      for (int c = 0; c < 2; ++c)
      {
        sets.Join(corner[c], corner[c + 1], this->Forms.Along(form, first + c) - (*rotation)[c]);
      }
    }
  };
  std::vector<char> isDone(target.Indices.size(), 0);
  for (Index t = 0; t < static_cast<Index>(settings.size()); ++t)
  {
    isDone[t] = settings[t] == RotationSetting::Prescribed ? 0 : 1;
    if (settings[t] == RotationSetting::Base)
    {
      this->JoinAsBase(t, form, sets);
    }
  }
  for (const MeshPlace& place : target.Places)
  {
    const Index t = place.Triangle - this->Component.FirstTriangle;
    if (target.Indices[t] != 0 && !isDone[t])
    {
      isDone[t] = 1;
      add(t, &place);
    }
  }
  const bool keeps = target.Objective == RotationObjective::LeastChange;
  for (Index t = 0; t < static_cast<Index>(target.Indices.size()); ++t)
  {
    if (!isDone[t] && (target.Indices[t] != 0 || (keeps && this->BaseIndices[t] != 0)))
    {
      add(t, nullptr);
    }
  }
  for (const SetEdge& edge : edges)
  {
    const Index h = mesh.HalfEdge(this->Component.FirstEdge + edge.Edge);
    sets.Join(this->Constrained.UnknownOf(this->Forms.LocalTail(h)),
      this->Constrained.UnknownOf(this->Forms.LocalHead(h)), form[edge.Edge] - edge.Rotation);
  }
  sets.Close();
  return sets;
}

void TrivialConnection::SetTurn(
  const Eigen::VectorXd& potential, const EdgeForm& whole, TurnedField& field)
{
  Eigen::VectorXd turned = potential;
  if (!this->Constrained.GivenUnknowns.empty())
  {
    // The given directions are where they were, up to whole turns.
    turned.array() -= Wrapped(turned[this->Constrained.GivenUnknowns.front()]);
  }
  field.Turn = this->GetSolver().Spread(turned);
  field.Rotation = whole;
  this->Forms.SubtractRise(field.Turn, field.Rotation);
}

/// The total rotation before the base is turned, or its change from the base's.
EdgeForm TrivialConnection::FormToMinimize(const RotationTarget& target) const
{
  std::vector<int> change(target.Indices.size());
  std::transform(target.Indices.begin(), target.Indices.end(), this->BaseIndices.begin(),
    change.begin(), std::minus<>());
  const IntegerForm jumps = this->Trees.Route(std::move(change));
  const bool keeps = target.Objective == RotationObjective::LeastChange;
  EdgeForm form(this->Component.Edges());
  for (Index e = 0; e < this->Component.Edges(); ++e)
  {
    form[e] = 2.0 * Pi * jumps[e] + (keeps ? 0.0 : this->BaseRotation[e]);
  }
  return form;
}

TurnedField TrivialConnection::Turn(const RotationTarget& target, const Progress& progress)
{
  TurnedField field;
  const bool keeps = target.Objective == RotationObjective::LeastChange;
  EdgeForm form = this->FormToMinimize(target);
  Eigen::VectorXd potential;
  progress.Report(0.3);
  const std::size_t loops = this->Trees.GetGenerators().size();
  const bool chooses = loops > 0 && loops <= MostLoops;
  const bool hasSeveralSets = this->Constrained.GivenUnknowns.size() > 1;
  if (chooses || hasSeveralSets)
  {
    potential = this->SolveFor(form, std::move(potential), nullptr, progress, field.Residual);
  }
  if (chooses)
  {
    this->ChooseTurning(form, potential, progress);
  }
  progress.Report(0.6);
  // Rigid triangles count in the rotation of the field itself.
  EdgeForm whole = form;
  for (Index e = 0; keeps && e < this->Component.Edges(); ++e)
  {
    whole[e] += this->BaseRotation[e];
  }
  const Eigen::VectorXd givenValues = potential;
  const RotationRepair repair(this->Geometry.Mesh, this->Component, this->BaseIndices, target);
  std::vector<RotationSetting> settings;
  std::vector<SetEdge> edges;
  std::size_t leastWrong = static_cast<std::size_t>(this->Component.Triangles()) + 1;
  const auto attempt = [&]
  {
    TurnedField next;
    const MergedUnknowns merged =
      this->MergeSingular(target, whole, settings, edges, hasSeveralSets ? &givenValues : nullptr);
    potential = this->SolveFor(form, std::move(potential), &merged, progress, next.Residual);
    this->SetTurn(potential, whole, next);
    next.Settings = settings;
    std::vector<Index> wrong = this->WrongTriangles(target, next);
    if (wrong.size() < leastWrong)
    {
      leastWrong = wrong.size();
      field = next;
    }
    return std::pair(std::move(wrong), std::move(next.Rotation));
  };
  for (int repairs = 0; repairs < MostRepairs && leastWrong > 0; ++repairs)
  {
    const auto [wrong, rotation] = attempt();
    // Where singularities are too near to each other, it is the edges that have to be bounded.
    if (repair.Loosen(wrong, settings))
    {
      edges.clear();
    }
    else if (!RotationRepair::LimitEdges(rotation, edges))
    {
      break;
    }
  }
  if (leastWrong > 0)
  {
    // The base shows how the mesh can carry the indices that nobody has changed.
    settings = field.Settings;
    edges.clear();
    std::vector<Index> wrong = this->WrongTriangles(target, field);
    for (int k = 0; k < MostRepairs && leastWrong > 0 && repair.KeepBase(wrong, 1 << k, settings);
         ++k)
    {
      wrong = attempt().first;
    }
  }
  field.KeepsTurningNumbers = loops > MostLoops;
  field.Energy = this->Forms.Product(field.Rotation, field.Rotation);
  field.TurningNumbers =
    LoopHolonomies(this->Geometry, this->Component, this->Degree, this->Trees, field.Rotation);
  return field;
}

ComplexVector TrivialConnection::SectionOf(const TurnedField& field) const
{
  ComplexVector section(this->Component.Vertices());
  // The phase that is open is the one in which the field is closest to the base.
  double phase = 0.0;
  if (this->Constrained.GivenUnknowns.empty())
  {
    const Complex overlap = ParallelSum<Complex>(this->Component.Vertices(), LightPiece, 0.0,
      [&](Index begin, Index end)
      {
        Complex sum = 0.0;
        ForCosinesAndSines(
          begin, end, [&](Index v) { return field.Turn[v]; },
          [&](Index v, double cosine, double sine)
          { sum += std::norm(this->Base[v]) * Complex(cosine, sine); });
        return sum;
      });
    phase = std::arg(overlap);
  }
  ParallelFor(this->Component.Vertices(), LightPiece,
    [&](Index begin, Index end)
    {
      ForCosinesAndSines(
        begin, end, [&](Index v) { return phase - field.Turn[v]; },
        [&](Index v, double cosine, double sine)
        {
          const double modulus = Modulus(this->Base[v]);
          section[v] =
            (modulus > 0.0 ? this->Base[v] / modulus : Complex(1.0)) * Complex(cosine, sine);
        });
    });
  if (this->Component.IsCover)
  {
    SparseMatrix identity(section.size(), section.size());
    identity.setIdentity();
    DoubleCover(this->Geometry, this->Component, this->Degree).MakeSymmetric(section, identity);
    for (Complex& value : section)
    {
      const double modulus = Modulus(value);
      value = modulus > 0.0 ? value / modulus : Complex(1.0);
    }
  }
  return section;
}

std::vector<Index> TrivialConnection::WrongTriangles(
  const RotationTarget& target, const TurnedField& field) const
{
  const bool isSmall = ParallelSum(this->Component.Edges(), LightPiece, 0,
                         [&](Index begin, Index end)
                         {
                           int large = 0;
                           for (Index e = begin; e < end; ++e)
                           {
                             large += std::abs(field.Rotation[e]) > Pi - Rounding ? 1 : 0;
                           }
                           return large;
                         }) == 0;
  // Rotations below a half turn are not changed by being wrapped.
  if (isSmall && !this->Component.IsCover)
  {
    return {};
  }
  const ComplexVector section = this->SectionOf(field);
  const std::vector<int> indices =
    SingularityIndices(this->Geometry, this->Component, this->Degree, section.data());
  std::vector<Index> wrong;
  for (Index t = 0; t < static_cast<Index>(indices.size()); ++t)
  {
    if (indices[t] != target.Indices[t])
    {
      wrong.push_back(t);
    }
  }
  return wrong;
}
}
