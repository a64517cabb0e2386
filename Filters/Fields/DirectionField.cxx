// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"

#include "Computation/ComponentFields.h"
#include "Computation/FieldToResult.h"
#include "Computation/Guide.h"
#include "Computation/Stages.h"
#include "Guidance/Guidance.h"
#include "Guidance/TensorSection.h"
#include "Support/Threads.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace DirectionFields
{
namespace
{
/// Notes on likely mistakes in the surface or the options.
std::vector<std::string> Hints(Stages& stages, const Options& options)
{
  std::vector<std::string> notes;
  if (options.MergePoints == MergePoints::Off && stages.GetBoundaryPoints().LookLikeSoup())
  {
    const BoundaryPoints& boundary = stages.GetBoundaryPoints();
    notes.emplace_back(std::to_string(boundary.Coincident) + " of the " +
      std::to_string(boundary.Count) +
      " points on the boundary of the surface lie exactly on another one: triangles touch there that "
      "are not connected. Switch on Merge Points to connect them.");
  }
  return notes;
}

Result Aborted(const Options& options)
{
  Result nothing;
  nothing.Degree = options.Degree;
  nothing.Aborted = true;
  return nothing;
}
}

DirectionField::DirectionField(const Surface& surface)
  : DirectionField(std::make_shared<const Surface>(surface))
{
}

DirectionField::DirectionField(std::shared_ptr<const Surface> surface)
  : Input(std::move(surface))
{
}

DirectionField::~DirectionField() = default;
DirectionField::DirectionField(DirectionField&&) noexcept = default;
DirectionField& DirectionField::operator=(DirectionField&&) noexcept = default;

void DirectionField::SetPhaseReference(std::vector<Vector3> directions, int degree)
{
  this->PhaseReference.Vectors = std::move(directions);
  this->PhaseReferenceDegree = degree;
}

std::vector<Vector3> DirectionField::GetPhaseReference(int degree) const
{
  return this->PhaseReferenceDegree == degree ? this->PhaseReference.Vectors
                                              : std::vector<Vector3>();
}

std::vector<Complex> DirectionField::PhaseReferenceSection(int degree) const
{
  if (this->PhaseReferenceDegree != degree ||
    this->PhaseReference.Vectors.size() != this->Input->Points.size())
  {
    return {};
  }
  return GuidanceSection(this->Cache->GetGeometry(), this->PhaseReference, degree);
}

void DirectionField::FollowTensors(SurfaceTensors tensors, const TensorGuidanceOptions& options)
{
  Internal::Check(*this->Input, tensors, options);
  const bool areSame = this->Followed && this->Followed->Tensors->Values == tensors.Values &&
    this->Followed->Tensors->Components == tensors.Components &&
    this->Followed->Tensors->AtTriangles == tensors.AtTriangles;
  if (!areSame)
  {
    this->Followed = std::make_unique<FollowedTensors>();
    this->Followed->Tensors = std::make_shared<const SurfaceTensors>(std::move(tensors));
  }
  this->Followed->Options = options;
}

void DirectionField::FollowNoTensors()
{
  this->Followed.reset();
}

std::shared_ptr<const TensorGuidance> DirectionField::GetTensorGuidance() const
{
  return this->AtTensors;
}

Options DirectionField::WithTensors(const Options& options) const
{
  Options used = options;
  if (this->Followed)
  {
    used.Alignment = Alignment::None;
    used.ConstraintSolver =
      FollowsExactly(options) ? ConstraintSolver::Energy : options.ConstraintSolver;
    if (options.Degree != 2 && options.Degree != 4)
    {
      throw std::invalid_argument("Set Directions per point (Degree) to 2 or 4: a tensor gives a "
                                  "line or a cross field.");
    }
  }
  return used;
}

Stages& DirectionField::StagesFor(const Options& options)
{
  if (!this->Cache || this->Cache->GetMergePoints() != options.MergePoints)
  {
    this->Cache.reset();
    this->Cache = std::make_unique<Stages>(this->Input, options.MergePoints);
  }
  return *this->Cache;
}

Result DirectionField::Compute(
  const Options& options, const Guidance& guidance, const ProgressFunction& progress) &
{
  return this->ComputeField(options, guidance, progress, true);
}

Result DirectionField::Compute(
  const Options& options, const Guidance& guidance, const ProgressFunction& progress) &&
{
  return this->ComputeField(options, guidance, progress, false);
}

Result DirectionField::ComputeField(const Options& given, const Guidance& guidance,
  const ProgressFunction& progressFunction, bool othersFollow)
{
  const Options options = this->WithTensors(given);
  Check(options);
  Check(guidance, options, this->Input->Points.size());
  Threads threads(options.NumberOfThreads);
  const Threads::Scope scope(threads);
  const Progress progress(progressFunction);
  try
  {
    progress.RequireToGoOn();
    Stages& stages = this->StagesFor(options);
    progress.RequireToGoOn();
    std::vector<std::string> notes = Hints(stages, options);
    const Guide guide(stages, options, guidance, notes, this->Followed.get());
    this->AtTensors = guide.TensorsAtPoints(stages);
    progress.RequireToGoOn();
    // The linear systems take about as long as half of the eigenvalue problem does.
    const double energyPart = guide.Any() || options.UnitLength ? 0.65 : 1.0;
    EnergyStage& energy = stages.GetEnergy(options, progress.Part(0.0, energyPart));
    ComponentFields fields =
      SolveComponents(stages, energy, guide, this->PhaseReferenceSection(options.Degree), options,
        othersFollow, progress.Part(energyPart, 1.0));
    return ToResult(stages, options, guide, std::move(fields), std::move(notes));
  }
  catch (const Stopped&)
  {
    return Aborted(options);
  }
}
}
