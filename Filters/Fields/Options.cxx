// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Options.h"

#include "OptionTable.h"
#include "Support/Sentences.h"

#include <stdexcept>
#include <string>

namespace DirectionFields
{
namespace
{
void Require(bool valid, const char* sentence)
{
  if (!valid)
  {
    throw std::invalid_argument(sentence);
  }
}

/// "1 to 16", "at least 0", as sentences have it.
std::string Words(double least, double most)
{
  Internal::Sentence words;
  if (most >= AnyFinite)
  {
    words << "at least " << least;
  }
  else
  {
    words << least << " to " << most;
  }
  return words.str();
}

void RequireRange(double value, const char* name, double least, double most, const char* unit)
{
  // Written so that NaN is refused, too.
  if (!(value >= least && value <= most))
  {
    throw std::invalid_argument(std::string(name) + " must be " + Words(least, most) + unit + ".");
  }
}
}

void Check(const Options& options)
{
#define SKIP(...)
#define CHECK(name, stage, least, most, unit) RequireRange(options.name, #name, least, most, unit);
  DIRECTIONFIELDS_OPTIONS(SKIP, SKIP, CHECK)
#undef SKIP
#undef CHECK
  const bool usesCurvature =
    options.Alignment == Alignment::PrincipalCurvature || options.ConstrainCurvature;
  Require(!usesCurvature || options.Degree == 2 || options.Degree == 4,
    "Set Directions per point (Degree) to 2 or 4: principal curvature gives a line or a cross "
    "field. For others turn Alignment and Constrain Curvature off, or align to Point Vectors.");
}

bool AreSameUpTo(OptionStage stage, const Options& a, const Options& b)
{
#define COMPARE(name, first, ...)                                                                  \
  if (OptionStage::first <= stage && a.name != b.name)                                             \
  {                                                                                                \
    return false;                                                                                  \
  }
  DIRECTIONFIELDS_OPTIONS(COMPARE, COMPARE, COMPARE)
#undef COMPARE
  return true;
}

void Check(const Guidance& guidance, const Options& options, std::size_t points)
{
  const bool needed = options.Alignment == Alignment::PointVectors || options.ConstrainGuidance;
  Require(!needed || guidance.Vectors.size() == points,
    "Choose a point array of three components as Guidance Vectors: Point Vectors and Constrain "
    "Guidance need a vector at each point.");
  Require(!needed || guidance.Weights.empty() || guidance.Weights.size() == points,
    "Choose other Guidance Weights: they must be one number a point.");
  Require(!needed || guidance.Strengths.empty() || guidance.Strengths.size() == points,
    "Choose other Guidance Strengths: they must be one number a point.");
}
}
