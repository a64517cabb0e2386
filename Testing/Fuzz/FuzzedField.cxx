// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FuzzedField.h"

#include "Bytes.h"
#include "Coordinates.h"
#include "FuzzedSurface.h"
#include "Interpolation/GivenField.h"
#include "Meshes/Soundness.h"
#include "OptionTable.h"
#include "Streamlines.h"

#include <cmath>
#include <set>
#include <stdexcept>

using namespace DirectionFields;

namespace
{
void ReadOption(unsigned byte, double least, double most, double& value)
{
  constexpr double LargestInteresting = 10.0;
  value = Real(byte, value, least, std::isfinite(most) ? most : LargestInteresting);
}

void ReadOption(unsigned byte, int least, int most, int& value)
{
  value = Whole(byte, value, least, most);
}

constexpr std::size_t OptionsSize = 32;

/// One byte for each option in the order of the table, which new ones are appended to; the last byte is for ghosts.
Options ReadOptions(const Bytes& bytes, std::size_t begin)
{
  std::size_t place = begin;
  const auto next = [&bytes, &place] { return bytes.At(place++); };
  Options options;
#define READ_FLAG(name, ...) options.name = next() % 2 != 0;
#define READ_CHOICE(name, stage, last)                                                             \
  options.name = static_cast<decltype(options.name)>(next() % (last + 1));
#define READ_NUMBER(name, stage, least, most, unit) ReadOption(next(), least, most, options.name);
  DIRECTIONFIELDS_OPTIONS(READ_FLAG, READ_CHOICE, READ_NUMBER)
#undef READ_FLAG
#undef READ_CHOICE
#undef READ_NUMBER
  // Some numbers are interesting on other scales.
  const auto at = [&bytes, begin](std::size_t i) { return bytes.At(begin + i); };
  const double exponent = Real(at(2), -6.0, -12.0, -1.0);
  options.Tolerance = std::isfinite(exponent) ? std::pow(10.0, exponent) : exponent;
  // A thousand threads for each input would take long.
  options.NumberOfThreads = at(4) < FirstInvalid ? static_cast<int>(at(4) % 4) : -1;
  options.Shift = at(9) < 128 ? std::pow(10.0, at(9) / 4.0 - 12.0) : Special(at(9));
  options.MinimumFeatureLength = Real(at(22), Options().MinimumFeatureLength, 0.0, 1.0);
  return options;
}

Guidance ReadGuidance(Bytes& bytes, const Surface& surface, unsigned kind)
{
  Guidance guidance;
  const std::size_t points = surface.Points.size() + (kind == 255 ? 1 : 0);
  for (std::size_t i = 0; kind % 4 != 0 && i < points; ++i)
  {
    guidance.Vectors.push_back(ReadVector(bytes));
    if (kind % 4 == 2)
    {
      guidance.Weights.push_back(ReadNumber(bytes));
    }
  }
  return guidance;
}

/// The error that the surface deserves by its points and ids: the first one that is wrong.
struct Expected
{
  bool InvalidId = false;
  /// Of those that are NaN or infinite, where there are any; else of those that are too large.
  Index FirstNonFinite = None;
};

Expected ExpectedError(const Surface& surface)
{
  Expected expected;
  std::set<Index> used;
  for (const Triangle& t : surface.Triangles)
  {
    const bool collapsed = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    for (const Index point : t)
    {
      expected.InvalidId = expected.InvalidId || !Exists(point, surface);
      if (!collapsed && Exists(point, surface))
      {
        used.insert(point);
      }
    }
  }
  CoordinateCheck check(false);
  for (const Index point : used)
  {
    const double* const place = surface.Points[point].data();
    if (!check.MayBe(place))
    {
      check.Refuse(static_cast<std::size_t>(point), place);
    }
  }
  expected.FirstNonFinite = check.GetError().empty() ? None : static_cast<Index>(check.GetFirst());
  return expected;
}

std::string ErrorFlaw(const Expected& expected, const MeshError& error, bool mergePoints)
{
  const bool invalid = error.GetKind() == MeshError::Kind::InvalidPointId;
  const bool nonFinite = error.GetKind() == MeshError::Kind::NonFinitePoint;
  // Merging makes triangles collapse, whose points are not used any more.
  const bool rightPoint = mergePoints || error.GetId() == expected.FirstNonFinite;
  if (invalid != expected.InvalidId ||
    (!invalid && nonFinite != (expected.FirstNonFinite != None)) || (nonFinite && !rightPoint))
  {
    return std::string("the wrong error: ") + error.what();
  }
  return {};
}

bool AreValid(const Options& options, const Guidance& guidance, const Surface& surface)
{
  try
  {
    Check(options);
    Check(guidance, options, surface.Points.size());
  }
  catch (const std::invalid_argument&)
  {
    return false;
  }
  return true;
}

bool AreSame(const Result& one, const Result& other)
{
  return one.Representation == other.Representation && one.Normal == other.Normal &&
    one.SingularityIndex == other.SingularityIndex && one.Constraint == other.Constraint &&
    one.Components.size() == other.Components.size() && one.Notes == other.Notes;
}

/// Computes a field that must be sound, unless options or surface are to be refused.
std::string ComputeFlaw(DirectionField& field, const Surface& surface, const Options& options,
  const Guidance& guidance, const ProgressFunction& progress, Result& result)
{
  const bool valid = AreValid(options, guidance, surface);
  const Expected expected = ExpectedError(surface);
  try
  {
    result = field.Compute(options, guidance, progress);
  }
  catch (const std::invalid_argument& error)
  {
    return valid ? std::string("refused: ") + error.what() : "";
  }
  catch (const MeshError& error)
  {
    return ErrorFlaw(expected, error, options.MergePoints == MergePoints::On);
  }
  if (!valid)
  {
    return "invalid options were taken";
  }
  const bool nonFinite = expected.FirstNonFinite != None && options.MergePoints != MergePoints::On;
  return !result.Aborted && (expected.InvalidId || nonFinite)
    ? "the surface was not refused"
    : Meshes::Flaw(surface, options, result);
}

/// The first fault of lines along a field that was computed, read back from its result.
std::string LinesFlaw(const Surface& surface, const Result& result, SeedType seeds)
{
  Surface output;
  for (const Index i : result.OriginalPoint)
  {
    output.Points.push_back(surface.Points[i]);
  }
  output.Triangles = result.SplitTriangles.empty() ? surface.Triangles : result.SplitTriangles;
  output.Ghost = surface.Ghost;
  PointDirections directions;
  directions.Degree = result.Degree;
  directions.Direction = [&result](Index point, int k) { return result.Direction(point, k); };
  directions.Magnitude = [&result](Index point) { return std::abs(result.Representation[point]); };
  const GivenField field(output, directions);
  StreamlineOptions options;
  options.Seeds = seeds;
  options.StopAtCrossings = result.Degree % 2 == 0;
  options.MaximumNumber = 20;
  Streamlines lines;
  try
  {
    lines = TraceStreamlines(field, directions, {}, options);
  }
  catch (const std::invalid_argument& error)
  {
    // Around spikes lines may be longer than the memory has room for.
    const std::string words = error.what();
    return words.find("Lower Maximum Streamline Length") != std::string::npos ? "" : words;
  }
  for (std::size_t i = 0; i < lines.Points.size(); ++i)
  {
    if (!lines.Points[i].allFinite() || !(std::abs(lines.Directions[i].norm() - 1.0) < 1e-6))
    {
      return "a line is not finite";
    }
  }
  return lines.Offsets.size() == lines.Length.size() + 1 ? "" : "lines without points";
}

/// Some triangles, other ones for each byte but 0.
std::vector<char> Ghosts(unsigned byte, std::size_t triangles)
{
  std::vector<char> ghosts(byte == 0 ? 0 : triangles);
  for (std::size_t t = 0; t < ghosts.size(); ++t)
  {
    ghosts[t] = t * (2 * byte + 1) / 16 % 3 == 0;
  }
  return ghosts;
}
}

std::string FuzzedField(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  const Options options = ReadOptions(bytes, 0);
  const Options earlier = ReadOptions(bytes, OptionsSize);
  bytes.Skip(2 * OptionsSize);
  const unsigned again = bytes.Take();
  const unsigned progressCalls = bytes.Take();
  const unsigned guidanceKind = bytes.Take();
  Surface surface = ReadSurface(bytes);
  surface.Ghost = Ghosts(bytes.At(OptionsSize - 1), surface.Triangles.size());
  const Guidance guidance = ReadGuidance(bytes, surface, guidanceKind);

  DirectionField field(surface);
  Result result;
  if (again % 2 == 0)
  {
    const std::string flaw = ComputeFlaw(field, surface, options, guidance, {}, result);
    const SeedType seeds = again % 4 == 0 ? SeedType::EvenlySpaced : SeedType::Singularities;
    return flaw.empty() && !result.OriginalPoint.empty() ? LinesFlaw(surface, result, seeds) : flaw;
  }
  unsigned calls = 0;
  const auto progress = [&calls, progressCalls](double)
  { return progressCalls == 0 || ++calls < progressCalls; };
  std::string flaw = ComputeFlaw(field, surface, earlier, guidance, progress, result);
  if (!flaw.empty())
  {
    return "earlier: " + flaw;
  }
  Result anew;
  DirectionField other(surface);
  result = {};
  flaw = ComputeFlaw(field, surface, options, guidance, {}, result);
  const std::string flawAnew = ComputeFlaw(other, surface, options, guidance, {}, anew);
  if (flaw.empty() && (!flawAnew.empty() || !AreSame(anew, result)))
  {
    flaw = "another field after other options";
  }
  return flaw;
}
