// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Reports/DrawingReports.h"

#include "Support/Sentences.h"

#include <algorithm>
#include <cstddef>

namespace DirectionFields
{
namespace
{
/// More of the branch points than this sharing a triangle with another one is worth a warning.
constexpr double MostCrowded = 0.05;
}

std::string Summary(const Streamlines& lines, SeedType seeds)
{
  std::string text = Count(lines.Length.size(), "line");
  if (seeds == SeedType::EvenlySpaced)
  {
    text += ' ' + Figure(lines.Spacing) + " apart";
  }
  else if (seeds == SeedType::Singularities)
  {
    const auto singularities = std::count_if(lines.Nodes.begin(), lines.Nodes.end(),
      [](const StreamlineNode& node) { return node.Type == StreamlineNodeType::Singularity; });
    text +=
      " out of " + Count(static_cast<std::size_t>(singularities), "singularity", "singularities");
  }
  else
  {
    text += " through the points given";
  }
  text += ", " + Figure(Sum(lines.Length)) + " long together";
  const auto closed = std::count_if(
    lines.Closed.begin(), lines.Closed.end(), [](char isClosed) { return isClosed != 0; });
  if (closed > 0)
  {
    text += ", " + std::to_string(closed) + " closed";
  }
  return text + (lines.IsLimited ? ", not all of them" : "");
}

std::string Summary(const StripePattern& pattern)
{
  const std::string lines = Count(pattern.Length.size(), "stripe");
  return lines +
    (pattern.Spacing > 0.0 ? ' ' + Figure(pattern.Spacing) + " apart" : ", spacing of an array") +
    ", " + Figure(Sum(pattern.Length)) + " long together, " +
    Count(static_cast<std::size_t>(pattern.BranchPoints), "branch point") + ", misfit " +
    Figure(pattern.Misfit);
}

std::string Summary(const Glyphs& glyphs)
{
  const std::string text = Count(glyphs.Point.size(), "glyph");
  return glyphs.Spacing > 0.0 ? text + ' ' + Figure(glyphs.Spacing) + " or more apart" : text;
}

std::vector<std::string> Warnings(const Streamlines& lines, const StreamlineOptions& options)
{
  if (!lines.IsLimited)
  {
    return {};
  }
  return { "There are " + std::to_string(options.MaximumNumber) +
    " lines, and there would be more. Raise Maximum Number Of Lines, or Spacing for fewer lines." };
}

std::vector<std::string> Warnings(const StripePattern& pattern, const StripeOptions& options)
{
  std::vector<std::string> warnings;
  if (pattern.LineOffset != options.LineOffset)
  {
    Internal::Sentence text;
    text << "Stripes of a line field (degree 2) have no left and right side: Line Offset "
         << pattern.LineOffset << " is taken. Choose a multiple of 0.5.";
    warnings.push_back(text.str());
  }
  if (pattern.CrowdedBranchPoints > MostCrowded * pattern.BranchPoints)
  {
    warnings.push_back("The mesh is too coarse for stripes this narrow: of " +
      std::to_string(pattern.BranchPoints) + " triangles where stripes branch, " +
      std::to_string(pattern.CrowdedBranchPoints) +
      " have more than one line ending in them. Subdivide the surface before Direction Field, or "
      "raise Spacing.");
  }
  return warnings;
}
}
