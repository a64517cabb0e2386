// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Functions.h"

#include <DirectionFields/Comparison/FieldDerivatives.h>
#include <DirectionFields/Comparison/FieldDifference.h>
#include <DirectionFields/Distance/ClosestPoints.h>
#include <DirectionFields/Guidance/CurveGuidance.h>
#include <DirectionFields/Guidance/TensorGuidance.h>
#include <DirectionFields/Remesh.h>
#include <DirectionFields/Reports/DrawingReports.h>
#include <DirectionFields/Reports/FieldSummary.h>
#include <DirectionFields/Reports/FieldWarnings.h>
#include <DirectionFields/Reports/RemeshReports.h>
#include <DirectionFields/Streamlines.h>
#include <DirectionFields/Stripes.h>

#include <algorithm>
#include <functional>

namespace DirectionFields
{
namespace
{
/// The options of a function, and its number of threads.
template <class T>
struct Chosen
{
  T Options;
  int Threads = 0;
};

template <class T>
void ReadThreads(Keywords& keywords, Chosen<T>& chosen)
{
  keywords("number_of_threads", chosen.Threads, 0.0, 1024.0);
  keywords.RequireNoMore();
}

/// What a mesh is to be, and what its faces are judged by.
struct ChosenMesh
{
  RemeshOptions Options;
  QualityLimits Limits;
};

ChosenMesh ReadRemeshOptions(Keywords& keywords)
{
  ChosenMesh chosen;
  RemeshOptions& options = chosen.Options;
  keywords.Choice("element", options.Element, { "quads", "triangles" });
  keywords("faces", options.NumberOfFaces, 1.0, static_cast<double>(1 << 30));
  options.EdgeLength = 0.0;
  keywords("edge_length", options.EdgeLength, 0.0);
  options.UseEdgeLength = options.EdgeLength != 0.0;
  options.EdgeLength = options.UseEdgeLength ? options.EdgeLength : 1.0;
  keywords("sizing_is_length", options.SizingIsLength);
  keywords.Choice(
    "size_source", options.SizeSource, { "sizing", "curvature", "second_derivatives" });
  keywords("maximum_error", options.MaximumError, 0.0);
  keywords("gradation", options.Gradation, 0.0);
  keywords("add_irregular_pairs", options.AddIrregularPairs);
  keywords("pure_quads", options.PureQuads);
  keywords.Choice("boundary_spacing", options.BoundarySpacing, { "free", "even", "keep" });
  keywords("keep_thin_parts", options.KeepThinParts);
  keywords("keep_features", options.KeepFeatures);
  keywords("feature_angle", options.FeatureAngle, 0.0, 180.0, " degrees");
  keywords("minimum_feature_length", options.MinimumFeatureLength, 0.0);
  keywords("keep_soft_features", options.KeepSoftFeatures);
  keywords.Choice("alignment", options.Alignment, { "shape", "smooth" });
  keywords("alignment_strength", options.AlignmentStrength, 0.0, 1.0);
  keywords("singularity_cost", options.SingularityCost, 0.0, 4.0);
  keywords("smoothing_iterations", options.SmoothingIterations, 0.0, 1000.0);
  keywords("minimum_scaled_jacobian", chosen.Limits.MinimumScaledJacobian, 0.0, 1.0);
  keywords("maximum_aspect_ratio", chosen.Limits.MaximumAspectRatio, 0.0);
  keywords("maximum_warpage", chosen.Limits.MaximumWarpage, 0.0, 2.0);
  keywords("number_of_threads", options.NumberOfThreads, 0.0, 1024.0);
  keywords.RequireNoMore();
  return chosen;
}

Chosen<StreamlineOptions> ReadStreamlineOptions(Keywords& keywords)
{
  Chosen<StreamlineOptions> chosen;
  StreamlineOptions& options = chosen.Options;
  keywords.Choice("start", options.Seeds, { "evenly", "singularities", "points" });
  keywords("spacing", options.Spacing, 0.0);
  keywords("ratio", options.Ratio, 0.1, 0.9);
  keywords("maximum_length", options.MaximumLength, 0.0);
  keywords("minimum_length", options.MinimumLength, 0.0);
  keywords("stop_at_crossings", options.StopAtCrossings);
  keywords.Choice("direction", options.Direction, { "both", "forward", "backward" });
  keywords("maximum_number", options.MaximumNumber, 1.0, 1e7);
  keywords("offset", options.Offset, -1.0, 1.0);
  ReadThreads(keywords, chosen);
  return chosen;
}

Chosen<StripeOptions> ReadStripeOptions(Keywords& keywords)
{
  Chosen<StripeOptions> chosen;
  keywords.Choice("direction", chosen.Options.Direction, { "along", "across" });
  keywords("spacing", chosen.Options.Spacing, 0.0);
  keywords("line_offset", chosen.Options.LineOffset, -1.0, 1.0);
  keywords("bands", chosen.Options.Bands);
  keywords("phases", chosen.Options.BandPhases);
  ReadThreads(keywords, chosen);
  return chosen;
}

Chosen<CurveGuidanceOptions> ReadCurveOptions(Keywords& keywords)
{
  Chosen<CurveGuidanceOptions> chosen;
  keywords("degree", chosen.Options.Degree, 1.0, 16.0);
  keywords("radius", chosen.Options.Radius, 0.0);
  keywords("falloff", chosen.Options.Falloff, 0.0);
  keywords("maximum_distance", chosen.Options.MaximumDistance, 0.0);
  ReadThreads(keywords, chosen);
  return chosen;
}

Chosen<TensorGuidanceOptions> ReadTensorOptions(Keywords& keywords)
{
  Chosen<TensorGuidanceOptions> chosen;
  keywords.Choice("direction", chosen.Options.Direction, TensorDirectionNames());
  keywords("scale", chosen.Options.Scale, 0.0, 32.0);
  ReadThreads(keywords, chosen);
  return chosen;
}

/// @param regions of each triangle, from 0 on, or None
/// @param names   of the regions, by these numbers
/// @param lines   that become edges of the mesh
/// @param places  that become vertices of the mesh, or None
py::object MakeMesh(const SharedSurface& surface, const py::object& directions,
  const py::object& sizing, const py::object& regions, const std::vector<std::string>& names,
  const std::vector<py::array>& lines, const py::object& places, const py::object& progress,
  const py::dict& given)
{
  Keywords keywords("remesh", given);
  ChosenMesh chosen = ReadRemeshOptions(keywords);
  RemeshOptions& options = chosen.Options;
  options.Sizing = NumbersOrNone(sizing);
  if (!regions.is_none())
  {
    options.Regions = regions.cast<std::vector<Index>>();
    options.RegionNames = names;
  }
  const std::vector<Vector3> field = VectorsOrNone(directions);
  const std::vector<Vector3> vertices = VectorsOrNone(places);
  std::vector<std::vector<Vector3>> curves;
  std::transform(lines.begin(), lines.end(), std::back_inserter(curves), &Vectors);
  return Run(progress, options.NumberOfThreads,
    [=](const ProgressFunction& report)
    {
      auto mesh = std::make_shared<RemeshResult>(
        Remesh(surface, curves, vertices).Compute(chosen.Options, field, report));
      const auto quality = std::make_shared<FaceQuality>(QualityOf(mesh->Points, mesh->Faces));
      const auto judged = std::make_shared<QualityReport>(ReportQuality(*quality, chosen.Limits));
      const std::vector<IrregularVertex> others =
        IrregularVertices(*mesh, chosen.Options.Element == Element::Quads ? 4 : 6);
      const std::string summary = Summary(*mesh, *judged);
      mesh->Notes.insert(mesh->Notes.end(), judged->Sentences.begin(), judged->Sentences.end());
      const std::string repairs = DescribeRepairs(mesh->Repaired);
      if (!repairs.empty())
      {
        mesh->Notes.push_back(repairs);
      }
      return [=]() -> py::object
      {
        std::vector<Index> irregular;
        for (const IrregularVertex& vertex : others)
        {
          irregular.push_back(vertex.Point);
        }
        py::dict all;
        all["points"] = Own<double>(std::move(mesh->Points), { 3 });
        all["faces"] = Own<Index>(std::move(mesh->Faces), { 4 });
        all["quality"] = Own<double>(std::move(quality->ScaledJacobian));
        all["aspect_ratios"] = Own<double>(std::move(quality->AspectRatio));
        all["warpages"] = Own<double>(std::move(quality->Warpage));
        all["passes"] = Own<bool>(std::move(judged->Pass));
        all["irregular"] = Own<Index>(std::move(irregular));
        all["kinds"] = Own<signed char>(std::move(mesh->Kind));
        all["field_indices"] = Own<int>(std::move(mesh->FieldIndex));
        all["source_triangles"] = Own<Index>(std::move(mesh->SourceTriangle));
        all["source_weights"] = Own<double>(std::move(mesh->SourceWeights), { 3 });
        all["source_faces"] = Own<Index>(std::move(mesh->FaceSource));
        py::dict chains;
        for (MeshChain& chain : mesh->Chains)
        {
          chains[py::str(chain.Name)] = Own<Index>(std::move(chain.Points));
        }
        all["chains"] = chains;
        all["regions"] = Own<Index>(std::move(mesh->Regions));
        all["regions_lost"] = Own<Index>(std::move(mesh->RegionsShown.Lost));
        all["borders_kept"] = mesh->RegionsShown.BordersKept;
        all["corners_missed"] = mesh->RegionsShown.MissedCorners;
        all["largest_area_error"] = mesh->RegionsShown.LargestAreaError;
        all["edge_length"] = mesh->EdgeLength;
        all["edges_as_wanted"] = mesh->EdgesAsWanted;
        all["error_of_sizes"] = mesh->ErrorOfSizes;
        all["boundary_unevenness"] = mesh->Boundary.Unevenness;
        all["boundary_points_kept"] = mesh->Boundary.Kept;
        all["maximum_distance"] = mesh->MaximumDistance;
        all["summary"] = summary;
        all["warnings"] = mesh->Notes;
        return all;
      };
    });
}

py::dict ToPython(Streamlines& lines)
{
  std::vector<Vector3> places;
  std::vector<int> types;
  std::vector<int> indices;
  std::vector<Index> triangles;
  for (const StreamlineNode& node : lines.Nodes)
  {
    places.push_back(node.Position);
    types.push_back(static_cast<int>(node.Type));
    indices.push_back(node.SingularityIndex);
    triangles.push_back(node.Triangle);
  }
  py::dict all;
  all["points"] = Own<double>(std::move(lines.Points), { 3 });
  all["offsets"] = Own<std::int64_t>(std::move(lines.Offsets));
  all["normals"] = Own<double>(std::move(lines.Normals), { 3 });
  all["directions"] = Own<double>(std::move(lines.Directions), { 3 });
  all["arc"] = Own<double>(std::move(lines.Arc));
  all["magnitudes"] = Own<double>(std::move(lines.Magnitude));
  all["nearest_points"] = Own<Index>(std::move(lines.Point));
  all["branches"] = Own<int>(std::move(lines.Branch));
  all["seeds"] = Own<Index>(std::move(lines.Seed));
  all["families"] = Own<int>(std::move(lines.Family));
  all["lengths"] = Own<double>(std::move(lines.Length));
  all["closed"] = Own<bool>(std::move(lines.Closed));
  all["ends"] = Own<int>(std::move(lines.Ends), { 2 });
  all["end_nodes"] = Own<Index>(std::move(lines.EndNodes), { 2 });
  all["nodes"] = Own<double>(std::move(places), { 3 });
  all["node_types"] = Own<int>(std::move(types));
  all["node_indices"] = Own<int>(std::move(indices));
  all["node_triangles"] = Own<Index>(std::move(triangles));
  all["spacing"] = lines.Spacing;
  return all;
}

py::object DrawLines(const SharedGiven& field, const py::object& places, const py::object& progress,
  const py::dict& given)
{
  Keywords keywords("streamlines", given);
  const Chosen<StreamlineOptions> chosen = ReadStreamlineOptions(keywords);
  const std::vector<Vector3> points = VectorsOrNone(places);
  return Run(progress, chosen.Threads,
    [=](const ProgressFunction& report)
    {
      std::vector<StreamlineSeed> seeds;
      if (!points.empty())
      {
        const ClosestPoints closest(*field->Mesh);
        for (const Vector3& point : points)
        {
          const ClosestPoints::Answer found = closest.Find(point);
          seeds.push_back({ found.Triangle, found.Weights });
        }
      }
      const PointDirections directions = field->Get();
      const auto lines = std::make_shared<Streamlines>(TraceStreamlines(
        GivenField(*field->Mesh, directions), directions, seeds, chosen.Options, report));
      return [=]() -> py::object
      {
        const std::string summary = Summary(*lines, chosen.Options.Seeds);
        py::dict all = ToPython(*lines);
        all["summary"] = summary;
        all["warnings"] = Warnings(*lines, chosen.Options);
        return all;
      };
    });
}

py::dict ToPython(StripePattern& pattern)
{
  std::vector<Vector3> places;
  std::vector<Index> triangles;
  std::vector<int> stripeIndices;
  std::vector<int> fieldIndices;
  for (const StripeSingularity& singularity : pattern.Singularities)
  {
    places.push_back(singularity.Position);
    triangles.push_back(singularity.Triangle);
    stripeIndices.push_back(singularity.StripeIndex);
    fieldIndices.push_back(singularity.FieldIndex);
  }
  py::dict all;
  all["points"] = Own<double>(std::move(pattern.LinePositions), { 3 });
  all["offsets"] = Own<std::int64_t>(std::move(pattern.LineOffsets));
  all["normals"] = Own<double>(std::move(pattern.LineNormals), { 3 });
  all["arc"] = Own<double>(std::move(pattern.Arc));
  all["closed"] = Own<bool>(std::move(pattern.Closed));
  all["lengths"] = Own<double>(std::move(pattern.Length));
  all["end_singularities"] = Own<Index>(std::move(pattern.EndSingularities), { 2 });
  all["band_points"] = Own<double>(std::move(pattern.BandPositions), { 3 });
  all["band_normals"] = Own<double>(std::move(pattern.BandNormals), { 3 });
  all["band_offsets"] = Own<std::int64_t>(std::move(pattern.BandOffsets));
  all["band_corners"] = Own<std::int64_t>(std::move(pattern.BandCorners));
  all["band_phases"] = Own<float>(std::move(pattern.BandPhases));
  all["band_triangles"] = Own<Index>(std::move(pattern.BandTriangle));
  all["stripe"] = Own<bool>(std::move(pattern.Stripe));
  all["singularities"] = Own<double>(std::move(places), { 3 });
  all["singular_triangles"] = Own<Index>(std::move(triangles));
  all["stripe_indices"] = Own<int>(std::move(stripeIndices));
  all["field_indices"] = Own<int>(std::move(fieldIndices));
  all["misfit"] = pattern.Misfit;
  all["spacing"] = pattern.Spacing;
  return all;
}

py::object DrawStripes(const SharedGiven& field, const py::object& spacings,
  const py::object& progress, const py::dict& given)
{
  Keywords keywords("stripes", given);
  const Chosen<StripeOptions> chosen = ReadStripeOptions(keywords);
  const std::vector<double> lengths = NumbersOrNone(spacings);
  return Run(progress, chosen.Threads,
    [=](const ProgressFunction& report)
    {
      std::function<double(Index)> spacing;
      if (!lengths.empty())
      {
        spacing = [&lengths](Index point) { return lengths[point]; };
      }
      const auto pattern = std::make_shared<StripePattern>(
        MakeStripes(GivenField(*field->Mesh, field->Get()), chosen.Options, spacing, report));
      return [=]() -> py::object
      {
        const std::string summary = Summary(*pattern);
        const std::vector<std::string> warnings = Warnings(*pattern, chosen.Options);
        py::dict all = ToPython(*pattern);
        all["summary"] = summary;
        all["warnings"] = warnings;
        return all;
      };
    });
}

py::object GuideAlongCurves(const SharedSurface& surface, const std::vector<py::array>& lines,
  const py::object& strengths, const py::object& progress, const py::dict& given)
{
  Keywords keywords("guide_by_curves", given);
  Chosen<CurveGuidanceOptions> chosen = ReadCurveOptions(keywords);
  chosen.Options.Strengths = NumbersOrNone(strengths);
  std::vector<std::vector<Vector3>> curves;
  std::transform(lines.begin(), lines.end(), std::back_inserter(curves), &Vectors);
  return Run(progress, chosen.Threads,
    [=](const ProgressFunction& report)
    {
      const auto guidance = std::make_shared<CurveGuidance>(
        GuideByCurves(*surface, curves, chosen.Options, Progress(report)));
      const std::string summary = Summary(*guidance, curves.size());
      return [=]() -> py::object
      {
        py::dict all;
        all["vectors"] = Own<double>(std::move(guidance->Vectors), { 3 });
        all["weights"] = Own<double>(std::move(guidance->Weights));
        all["strengths"] = guidance->Strengths.empty()
          ? py::object(py::none())
          : py::object(Own<double>(std::move(guidance->Strengths)));
        all["samples"] = guidance->Samples;
        all["far_samples"] = guidance->FarSamples;
        all["summary"] = summary;
        return all;
      };
    });
}

py::object GuideAlongTensors(const SharedSurface& surface, const py::array& values,
  bool atTriangles, const py::object& progress, const py::dict& given)
{
  const SurfaceTensors tensors{ Numbers(values), static_cast<int>(values.shape(1)), atTriangles };
  Keywords keywords("guide_by_tensors", given);
  const Chosen<TensorGuidanceOptions> chosen = ReadTensorOptions(keywords);
  return Run(progress, chosen.Threads,
    [=](const ProgressFunction& report)
    {
      const auto found = std::make_shared<TensorGuidance>(
        GuideByTensors(*surface, tensors, chosen.Options, Progress(report)));
      return [=]() -> py::object
      {
        py::dict all;
        all["vectors"] = Own<double>(std::move(found->Guidance.Vectors), { 3 });
        all["weights"] = Own<double>(std::move(found->Guidance.Weights));
        all["major_values"] = Own<double>(std::move(found->MajorValue));
        all["minor_values"] = Own<double>(std::move(found->MinorValue));
        all["anisotropy"] = Own<double>(std::move(found->Anisotropy));
        all["isotropic_share"] = found->IsotropicShare;
        all["asymmetric_part"] = found->AsymmetricPart;
        return all;
      };
    });
}

py::object CompareFields(const SharedGiven& one, const SharedGiven& two, const py::object& progress)
{
  return Run(progress, 0,
    [=](const ProgressFunction& report)
    {
      const PointDirections given = one->Get();
      const PointDirections second = two->Get();
      auto first = std::make_unique<GivenField>(*one->Mesh, given);
      auto other = std::make_unique<GivenField>(*one->Mesh, second);
      if (first->GetMesh().GetNumberOfVertices() != other->GetMesh().GetNumberOfVertices())
      {
        // Points across seams are one for the one field only: they are compared apart.
        const auto apart = std::make_shared<const FieldSurface>(*one->Mesh, false);
        first = std::make_unique<GivenField>(*one->Mesh, apart, given);
        other = std::make_unique<GivenField>(*one->Mesh, apart, second);
      }
      const auto difference = std::make_shared<FieldDifference>(Compare(*first, given, second));
      const auto matches = MatchSingularities(*first, *other, Progress(report));
      const std::string summary = Summary(*difference, &matches);
      return [=]() -> py::object
      {
        py::list singularities;
        for (const ComparedSingularity& at : matches)
        {
          singularities.append(
            py::make_tuple(at.Field, at.SingularityIndex, at.Triangle, at.Match, at.Distance));
        }
        py::dict all;
        all["angles"] = Own<double>(std::move(difference->Angle));
        all["mean"] = difference->Mean;
        all["maximum"] = difference->Maximum;
        all["singularities"] = singularities;
        all["summary"] = summary;
        return all;
      };
    });
}

py::tuple Derivatives(const SharedGiven& field)
{
  FieldDerivatives derivatives(GivenField(*field->Mesh, field->Get()));
  return py::make_tuple(
    Own<double>(std::move(derivatives.Divergence)), Own<double>(std::move(derivatives.Curl)));
}
}

void AddDrawing(py::module_& module, py::dict& described)
{
  Describe(described, "remesh", ReadRemeshOptions);
  Describe(described, "streamlines", ReadStreamlineOptions);
  Describe(described, "stripes", ReadStripeOptions);
  Describe(described, "guide_by_curves", ReadCurveOptions);
  Describe(described, "guide_by_tensors", ReadTensorOptions);
  module.def("remesh", &MakeMesh);
  module.def("streamlines", &DrawLines);
  module.def("stripes", &DrawStripes);
  module.def("guide_by_curves", &GuideAlongCurves);
  module.def("guide_by_tensors", &GuideAlongTensors);
  module.def("compare", &CompareFields);
  module.def("derivatives", &Derivatives);
}
}
