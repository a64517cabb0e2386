// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Quality/QualityReport.h"

#include "Support/Sentences.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace DirectionFields
{
namespace
{
/// Marks the faces that fail a limit.
/// @return what is said of them; empty for none
std::string Mark(const std::vector<bool>& fails, const std::string& limit, std::vector<char>& pass)
{
  const auto count = static_cast<std::size_t>(std::count(fails.begin(), fails.end(), true));
  for (std::size_t f = 0; f < fails.size(); ++f)
  {
    pass[f] = fails[f] ? 0 : pass[f];
  }
  return count == 0 ? std::string() : std::to_string(count) + " with " + limit;
}

std::vector<bool> Below(const std::vector<double>& values, double limit)
{
  std::vector<bool> fails(values.size(), false);
  std::transform(values.begin(), values.end(), fails.begin(),
    [limit](double value) { return limit > 0.0 && value < limit; });
  return fails;
}

std::vector<bool> Above(const std::vector<double>& values, double limit)
{
  std::vector<bool> fails(values.size(), false);
  std::transform(values.begin(), values.end(), fails.begin(),
    [limit](double value) { return limit > 0.0 && value > limit; });
  return fails;
}

void Judge(const FaceQuality& quality, const QualityLimits& limits, QualityReport& report)
{
  const std::size_t faces = quality.ScaledJacobian.size();
  report.IsLimited = true;
  report.Pass.assign(faces, 1);
  std::string reasons;
  for (const std::string& reason :
    { Mark(Below(quality.ScaledJacobian, limits.MinimumScaledJacobian),
        "a scaled Jacobian below " + Figure(limits.MinimumScaledJacobian), report.Pass),
      Mark(Above(quality.AspectRatio, limits.MaximumAspectRatio),
        "an aspect ratio above " + Figure(limits.MaximumAspectRatio), report.Pass),
      Mark(Above(quality.Warpage, limits.MaximumWarpage),
        "a warpage above " + Figure(limits.MaximumWarpage), report.Pass) })
  {
    reasons += reasons.empty() || reason.empty() ? reason : ", " + reason;
  }
  report.FailedFaces = static_cast<Index>(std::count(report.Pass.begin(), report.Pass.end(), 0));
  if (report.FailedFaces > 0)
  {
    report.Sentences.push_back(std::to_string(report.FailedFaces) + " of " + Count(faces, "face") +
      (report.FailedFaces == 1 ? " fails" : " fail") + " the limits: " + reasons +
      ". The array Pass shows where. More faces help where the surface bends or is narrow; where "
      "features meet at sharp angles, only other limits.");
  }
}
}

QualityReport ReportQuality(const FaceQuality& quality, const QualityLimits& limits)
{
  if (!(limits.MinimumScaledJacobian >= 0.0 && limits.MinimumScaledJacobian <= 1.0 &&
        limits.MaximumAspectRatio >= 0.0 && limits.MaximumWarpage >= 0.0 &&
        limits.MaximumWarpage <= 2.0))
  {
    throw std::invalid_argument("Minimum Scaled Jacobian has to be between 0 and 1, Maximum Aspect "
                                "Ratio at least 0, and Maximum Warpage between 0 and 2.");
  }
  QualityReport report;
  const std::vector<double>& jacobians = quality.ScaledJacobian;
  if (!jacobians.empty())
  {
    report.LeastScaledJacobian = *std::min_element(jacobians.begin(), jacobians.end());
    report.MeanScaledJacobian = Sum(jacobians) / static_cast<double>(jacobians.size());
    report.LargestAspectRatio =
      *std::max_element(quality.AspectRatio.begin(), quality.AspectRatio.end());
    report.LargestWarpage = *std::max_element(quality.Warpage.begin(), quality.Warpage.end());
  }
  if (limits.HasAny())
  {
    Judge(quality, limits, report);
  }
  return report;
}
}
