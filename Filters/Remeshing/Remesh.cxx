// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remesh.h"

#include "Boundary/BoundaryAdvice.h"
#include "Boundary/BoundaryDistance.h"
#include "Curves/CurveMapping.h"
#include "Curves/LinesOnMesh.h"
#include "Extraction/MeshExtraction.h"
#include "FaceMesh/FaceCounts.h"
#include "Finishing/FaceSources.h"
#include "Finishing/GivenPlaces.h"
#include "Finishing/JoinedFaces.h"
#include "Finishing/MeshAdvice.h"
#include "Finishing/SurfacePatches.h"
#include "Finishing/ThinParts.h"
#include "Finishing/UprightFaces.h"
#include "Parametrization/ComponentMap.h"
#include "Preparation/AffordableFeatures.h"
#include "Preparation/FeatureTurns.h"
#include "Preparation/PreparedField.h"
#include "Preparation/SizeAdvice.h"
#include "Preparation/SurfaceUnit.h"
#include "Preparation/WantedSizes.h"
#include "Refinement/LongEdges.h"
#include "Regions/RegionReport.h"
#include "SoftFeatures/Apices.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace DirectionFields
{
namespace
{
// How far the progress is after each step.
constexpr double AfterField = 0.4;
constexpr double AfterPreparing = PreparedField::PreparingShare * AfterField;
constexpr double AfterCells = 0.85;
constexpr double AfterFinishing = 0.97;
/// The user is told of lengths of edges that differ by more than this factor.
constexpr double Noticeably = 1.05;
/// Places on the boundary where its distance is measured, in wanted lengths of edges.
constexpr double Halfway = 0.5;
/// In wanted lengths of edges: of features that end freely, and to both sides of soft ones.
constexpr double ShortestFeature = 6.0, SoftRoom = 0.45;

int DegreeOf(Element element)
{
  return element == Element::Quads ? 4 : 6;
}

KeptEdges KeptOf(
  const RemeshOptions& options, const CurveCut* cut, const ChosenPoints& points, double edgeLength)
{
  return { { options.KeepFeatures, options.FeatureAngle, options.MinimumFeatureLength,
             ShortestFeature * edgeLength },
    options.Regions, cut ? cut->Edges : std::vector<std::array<Index, 2>>(), points.OnSurface(),
    options.KeepFeatures && options.KeepSoftFeatures ? SoftRoom * edgeLength : 0.0 };
}

/// How the mesh's own field is drawn to the principal curvatures. Their two lines are no part of a
/// field that has three.
ShapeAlignment AlignmentOf(const RemeshOptions& options)
{
  const bool isDrawn =
    options.Alignment == FieldAlignment::Shape && options.Element == Element::Quads;
  return isDrawn ? ShapeAlignment{ options.AlignmentStrength, options.SingularityCost }
                 : ShapeAlignment();
}

/// Copies the faces and the kinds of their vertices.
void CopyFaces(const FaceMesh& mesh, RemeshResult& result)
{
  result.Points = mesh.Points;
  result.Faces = mesh.Cells.Corners;
  result.Regular = mesh.Cells.IsRegular;
  for (const FaceMesh::Vertex& vertex : mesh.Vertices)
  {
    result.FieldIndex.push_back(vertex.SingularityIndex);
    result.Kind.push_back(vertex.Line < 0 ? VertexKind::Corner
        : vertex.IsBoundary               ? VertexKind::Boundary
        : vertex.Line > 0                 ? VertexKind::Feature
        : vertex.IsCone                   ? VertexKind::Cone
                                          : VertexKind::Surface);
  }
}

/// One mesh to be made.
struct Request
{
  const RemeshOptions& Options;
  const Surface& Input;
  PreparedField& Field;
  const WantedSizes& Sizes;
  /// Of lengths, in that of the user's surface.
  double Unit;
  /// Null for none.
  const CurveCut* Cut;
  const ChosenPoints& Points;

  bool HasCurves() const { return this->Cut && !this->Cut->Edges.empty(); }
};

/// Everything that the maps of the components are computed from.
ParametrizationInput InputFor(const Request& request)
{
  PreparedField& field = request.Field;
  const SurfaceGeometry& geometry = field.GetGeometry();
  const std::vector<double> window(geometry.Mesh.GetComponents().size(), request.Sizes.MapLength);
  FeatureLines features(geometry, field.GetMatching(), field.GetFeatures(), field.GetFrameless(),
    window, field.GetCorners());
  features.IsEnd.assign(geometry.Mesh.GetNumberOfVertices(), 0);
  for (const Index v : field.GetSeams().GetEnds())
  {
    features.IsEnd[v] = 1;
  }
  for (const Index v : field.GetSurface().FindPointVertices())
  {
    features.IsEnd[v] = 1;
  }
  return { geometry, field.GetMatching(), field.GetSection(), std::move(features),
    field.GetFrameless(), request.Sizes.PerLength(), field.GetCaches() };
}

/// The part of the progress for one component.
Progress PartFor(const TriangleMesh::Component& component, const ParametrizationInput& input,
  const Progress& progress)
{
  const std::vector<TriangleMesh::Component>& components = input.Geometry.Mesh.GetComponents();
  const auto count = static_cast<double>(components.size());
  const auto done = static_cast<double>(&component - components.data());
  return progress.Part(done / count, (done + 1.0) / count);
}

/// The faces of all components in one mesh.
struct FinishedMesh
{
  FaceMesh Faces;
  /// Seams whose sides could not be joined.
  Index OpenSeams = 0;
  BoundaryFigures Boundary;
  Index Turned = 0;
};

/// Whether quads only are wanted.
bool IsPure(const RemeshOptions& options)
{
  return options.PureQuads && options.Element == Element::Quads;
}

/// Joins the components along the seams, and improves the faces.
FinishedMesh Finish(const Request& request, const FeatureLines& features,
  std::vector<ExtractedMesh>& extracted, const Progress& progress)
{
  const PreparedField& field = request.Field;
  const WantedSizes& sizes = request.Sizes;
  FinishedMesh finished;
  field.GetSeams().Equalize(extracted);
  if (field.GetNeedless() > 0)
  {
    MoveToGiven(field.GetSurface(), extracted);
  }
  finished.Faces = JoinFaces(extracted, field.GetSeams(),
    FindTurns(field.GetGeometry(), features, sizes.HalfLengths()), finished.OpenSeams);
  if (request.Cut)
  {
    request.Points.Place(field.GetSurface(), *request.Cut, finished.Faces);
  }
  const std::vector<ClosestPoints> lines =
    field.GetSurface().LinesOf(field.GetGeometry(), features);
  const RemeshOptions& options = request.Options;
  const bool hasCloseLines = options.BoundarySpacing == BoundarySpacing::Free &&
    (!options.Regions.empty() || request.HasCurves());
  const std::optional<SurfacePatches> patches = hasCloseLines
    ? std::optional<SurfacePatches>(std::in_place, field.GetSurface(), features, sizes.EdgeLength)
    : std::nullopt;
  const SurfaceContext context{ request.Input, field.GetSurface(), field.GetInputTriangles(), lines,
    sizes.IsEven ? options.Sizing : sizes.AtPoints, hasCloseLines, patches ? &*patches : nullptr,
    field.GetNeedless() > 0 };
  const UprightFaces upright = FinishUpright(finished.Faces,
    { options.Element == Element::Quads, IsPure(options), options.SmoothingIterations,
      sizes.EdgeLength, options.BoundarySpacing, sizes.HasRows },
    context, features, progress);
  finished.Boundary = upright.Boundary;
  finished.Turned = upright.Turned;
  return finished;
}

/// The sentences about the components and the sizes, and the counts that belong to them.
void ReportExtraction(const Request& request, const std::vector<ExtractedMesh>& extracted,
  const FinishedMesh& finished, RemeshResult& result)
{
  for (std::size_t k = 0; k < extracted.size(); ++k)
  {
    if (extracted[k].Failure)
    {
      result.Notes.push_back("Component " + std::to_string(k) + " could not be remeshed, since " +
        Sentence(*extracted[k].Failure) + ". It is as it was.");
    }
    result.KeptVertices += extracted[k].KeptVertices;
    result.FlippedTriangles += extracted[k].FlippedTriangles;
  }
  if (finished.OpenSeams > 0)
  {
    result.Notes.push_back(std::to_string(finished.OpenSeams) +
      " seams between sheets of the surface are open in the mesh, since the faces there are too "
      "few. More faces, or shorter edges, would join them.");
  }
  const std::vector<std::string> aboutBoundary = BoundaryAdvice(finished.Faces, finished.Boundary,
    request.Options.BoundarySpacing, IsPure(request.Options) ? result.Triangles : 0);
  result.Notes.insert(result.Notes.end(), aboutBoundary.begin(), aboutBoundary.end());
  if (request.Field.GetNeedless() > 0)
  {
    result.Notes.push_back("The surface is rough: a field on it has " +
      std::to_string(request.Field.GetNeedless()) +
      " singularities that its shape does not need, too many for the number of faces. Faces follow a "
      "smoothed copy, and their points lie on the surface that came in. Where they are to be "
      "regular, smooth the surface before.");
  }
  if (request.Field.GetSurface().AreFeaturesInNoise())
  {
    result.Notes.push_back(
      "Features are the lines along which the surface bends as a whole: more than a tenth of its "
      "edges are sharp, as noise and coarse triangles make them. Curves that are given, as those of "
      "Feature Edges, are kept all the same.");
  }
  const WantedSizes& sizes = request.Sizes;
  SizeAdvice advice(sizes.EdgeLength, DegreeOf(request.Options.Element));
  if (sizes.EdgeLength > Noticeably * sizes.LengthForArea)
  {
    advice.Lengthen(sizes.LengthForArea);
  }
  const SurfaceGeometry& geometry = request.Field.GetGeometry();
  const std::vector<double> perLength = sizes.PerLength();
  for (const TriangleMesh::Component& component : geometry.Mesh.GetComponents())
  {
    advice.AddComponent(geometry, component, perLength);
  }
  advice.AddMesh(finished.Faces.Points, finished.Faces.Cells, result.KeptVertices);
  const std::vector<std::string> sentences = advice.GetSentences(request.Unit);
  result.Notes.insert(result.Notes.end(), sentences.begin(), sentences.end());
}

/// The sentences about the finished mesh.
void ReportQuality(const Request& request, const FaceMesh& mesh, RemeshResult& result)
{
  const RemeshOptions& options = request.Options;
  const std::vector<double>& sizes = request.Sizes.AtPoints;
  MeshWishes wishes;
  wishes.IsOfQuads = options.Element == Element::Quads;
  wishes.IsPure = IsPure(options);
  wishes.IsSmoothed = options.SmoothingIterations > 0;
  wishes.NumberOfFaces = options.UseEdgeLength ? 0 : options.NumberOfFaces;
  wishes.EdgeLength = request.Unit * result.EdgeLength;
  wishes.ShortestEdge = wishes.EdgeLength *
    (options.Sizing.empty() && !sizes.empty() ? *std::min_element(sizes.begin(), sizes.end())
                                              : 1.0);
  wishes.Extent = request.Unit * Extent(request.Input);
  wishes.ToSurface = request.Unit * result.MaximumDistance;
  wishes.ToMesh = request.Unit * result.MaximumDistanceToMesh;
  wishes.OfBoundary = request.Unit * result.MaximumBoundaryDistance;
  const auto onFeatures = std::count_if(mesh.Vertices.begin(), mesh.Vertices.end(),
    [](const FaceMesh::Vertex& vertex) { return vertex.Line != 0 && !vertex.IsBoundary; });
  wishes.HasHard = !options.Regions.empty() || request.Cut;
  wishes.PartOnFeatures = (options.KeepFeatures || wishes.HasHard) && !result.Kind.empty()
    ? static_cast<double>(onFeatures) / static_cast<double>(result.Kind.size())
    : 0.0;
  wishes.AddsPairs = options.AddIrregularPairs;
  wishes.HasGradation = options.Gradation > 0.0;
  wishes.Turned = result.TurnedFaces;
  wishes.PartCrossed = request.Field.GetPartCrossed();
  for (std::size_t v = 0; !options.Sizing.empty() && v < result.Points.size(); ++v)
  {
    const Triangle& t = request.Input.Triangles[result.SourceTriangle[v]];
    const std::array<double, 3>& w = result.SourceWeights[v];
    wishes.Sizes.push_back(
      result.EdgeLength * (w[0] * sizes[t[0]] + w[1] * sizes[t[1]] + w[2] * sizes[t[2]]));
  }
  result.IsSized = !options.Sizing.empty();
  result.EdgesAsWanted = EdgesAsWanted(mesh.Points, mesh.Cells, wishes.Sizes);
  for (const std::vector<std::string>& sentences : { MeshAdvice(mesh.Points, mesh.Cells, wishes),
         TopologyAdvice(CountTouching(request.Field.GetGeometry().Mesh,
                          request.Field.GetSurface().GetOriginals()),
           result.EulerCharacteristicBefore, result.EulerCharacteristicAfter, wishes.EdgeLength) })
  {
    result.Notes.insert(result.Notes.end(), sentences.begin(), sentences.end());
  }
  const std::vector<Triangle>& triangles = request.Input.Triangles;
  const Index vanished =
    CountUnused(triangles, request.Field.GetSurface().FindUsed(triangles.size()));
  if (vanished > 0)
  {
    result.Notes.push_back(std::to_string(vanished) +
      (vanished == 1 ? " component is" : " components are") +
      " not in the mesh, since all triangles there use a point twice. Clean takes them out of the "
      "surface.");
  }
}

/// Fills the result.
void Report(const Request& request, const FeatureLines& features,
  const std::vector<ExtractedMesh>& extracted, const FinishedMesh& finished, RemeshResult& result)
{
  const PreparedField& field = request.Field;
  CopyFaces(finished.Faces, result);
  const FaceCounts counts(finished.Faces, DegreeOf(request.Options.Element));
  result.Quads = counts.Quads;
  result.Triangles = counts.Triangles;
  result.IrregularVertices = counts.IrregularVertices;
  PointSources points = SourcesOf(field.GetSurface(), field.GetInputTriangles(), result.Points);
  result.SourceTriangle = std::move(points.Triangle);
  result.SourceWeights = std::move(points.Weights);
  FaceSources faces =
    SourcesOf(field.GetSurface(), field.GetInputTriangles(), result.Points, result.Faces);
  result.FaceSource = std::move(faces.Triangle);
  result.MaximumDistance = faces.LargestDistance;
  result.MaximumDistanceToMesh =
    LargestDistance(field.GetSurface().GetGivenPositions(), result.Points, result.Faces);
  result.EdgeLength = request.Sizes.EdgeLength;
  result.MaximumBoundaryDistance = BoundaryDistance(
    BoundaryLinesOf(request.Input, field.GetSurface().FindUsed(request.Input.Triangles.size())),
    result.Points, finished.Faces.Cells, Halfway * result.EdgeLength);
  result.EulerCharacteristicBefore = field.GetSeams().GetEulerCharacteristic();
  result.EulerCharacteristicAfter =
    EulerCharacteristic(static_cast<Index>(result.Points.size()), finished.Faces.Cells);
  result.Repaired = field.GetSurface().GetRepairs();
  result.Boundary = finished.Boundary;
  result.TurnedFaces = finished.Turned;
  if (!request.Options.Regions.empty() || request.HasCurves())
  {
    const RemeshOptions& options = request.Options;
    RegionReport report =
      ReportRegions(request.Input, options.Regions, options.RegionNames, request.HasCurves(),
        field.GetSurface(), features, finished.Faces, result.EdgeLength, result.FaceSource);
    result.Regions = std::move(report.OfFaces);
    result.RegionsShown = std::move(report.Shown);
    result.Notes.insert(result.Notes.end(), report.Sentences.begin(), report.Sentences.end());
  }
  result.Chains = LinesOn(finished.Faces, { field.GetSurface(), features, request.Cut },
    request.Points, result.Regions, request.Options.RegionNames, result.Notes);
  ReportExtraction(request, extracted, finished, result);
  ReportQuality(request, finished.Faces, result);
}
}

const char* Remesh::StepAt(double done)
{
  const double ofFirst = done / AfterFirst;
  return ofFirst < AfterPreparing ? "Preparing the surface"
    : ofFirst < AfterField        ? "Computing the field"
    : ofFirst < AfterCells        ? "Mapping the surface to a grid"
    : ofFirst <= 1.0              ? "Smoothing the mesh"
    : done < AfterShrinkings      ? "Making faces smaller at thin parts"
                                  : "Making another mesh for better faces";
}

RemeshResult Remesh::MakeForGiven(
  const RemeshOptions& given, const std::vector<Vector3>& givenDirections, const Progress& progress)
{
  RemeshOptions options = given;
  std::vector<Vector3> directions = givenDirections;
  if (this->Cut)
  {
    const CurveMapping mapping(*this->Given, *this->Cut);
    options.Regions = mapping.RegionsOfParts(given.Regions);
    mapping.ContinueSizes(options.Sizing);
    mapping.ContinueDirections(directions);
  }
  std::vector<std::string> aboutSizes;
  options = this->InUnitOfInput(options, aboutSizes);
  RemeshResult result;
  this->Make(options, directions, progress, result);
  if (this->Cut)
  {
    const CurveMapping mapping(*this->Given, *this->Cut);
    mapping.ReferToGiven(result.SourceTriangle, result.SourceWeights, result.FaceSource);
    result.Notes.insert(result.Notes.end(), this->Cut->Notes.begin(), this->Cut->Notes.end());
  }
  result.Notes.insert(result.Notes.end(), aboutSizes.begin(), aboutSizes.end());
  return result;
}

void Remesh::MakeOnce(const RemeshOptions& options, const std::vector<Vector3>& directions,
  const ThinParts& thin, double gridLength, const Progress& progress, RemeshResult& result)
{
  WantedSizes sizes = this->Prepare(options, directions, thin, progress.Part(0.0, AfterField));
  sizes.MapLength *= gridLength;
  const Request request{ options, *this->Input, *this->Cache, sizes, this->Unit, this->Cut.get(),
    *this->Points };
  ParametrizationInput input = InputFor(request);
  std::vector<ExtractedMesh> extracted;
  for (const TriangleMesh::Component& component : input.Geometry.Mesh.GetComponents())
  {
    const Progress part = PartFor(component, input, progress.Part(AfterField, AfterCells));
    const ComponentMap map = MapComponent(input, component, part.Part(0.15, 0.7));
    extracted.push_back(ExtractMesh(input.Geometry, map, part.Part(0.7, 1.0)));
  }
  this->IsCostly = AreCostly(extracted);
  const FinishedMesh finished =
    Finish(request, input.Features, extracted, progress.Part(AfterCells, AfterFinishing));
  Report(request, input.Features, extracted, finished, result);
  result.Notes.insert(result.Notes.end(), this->AboutFeatures.begin(), this->AboutFeatures.end());
}

WantedSizes Remesh::Prepare(const RemeshOptions& options, const std::vector<Vector3>& directions,
  const ThinParts& thin, const Progress& progress)
{
  WantedSizes sizes;
  sizes.IsEven = options.Sizing.empty();
  sizes.AtPoints = ClampedSizes(options.Sizing, this->Input->Points.size());
  const double area = RelativeArea(*this->Input, sizes.AtPoints);
  sizes.LengthForArea = sizes.EdgeLength = sizes.MapLength = EdgeLengthFor(area, options);
  const int degree = DegreeOf(options.Element);
  *this->Points = ChosenPoints(this->Cut.get(),
    options.KeepFeatures ? this->Tips->For(sizes.AtPoints, sizes.MapLength) : std::vector<Index>(),
    sizes.AtPoints, sizes.MapLength);
  KeptEdges kept = KeptOf(options, this->Cut.get(), *this->Points, sizes.MapLength);
  const AffordableFeatures affordable(
    *this->Input, kept.Features, degree, area / (sizes.MapLength * sizes.MapLength));
  kept.Features = affordable.Settings;
  this->AboutFeatures = affordable.Sentences();
  const bool isOfSizes = options.AddIrregularPairs && !options.Sizing.empty();
  sizes.HasRows = isOfSizes && directions.empty() && options.SizeSource == SizeSource::Sizing &&
    sizes.AreUneven();
  const OwnShape own(AlignmentOf(options), isOfSizes ? sizes.AtPoints : std::vector<double>());
  // Smaller faces at thin parts have the working surface of the others, which is not made anew.
  WorkingLengths lengths = LengthsFor(*this->Input, sizes.AtPoints, area, sizes.MapLength);
  sizes.Shrink(thin.GetLengths(), *this->Input, area, options.UseEdgeLength);
  if (!options.Sizing.empty())
  {
    // Sizes that are given have their values at the points that there are.
    lengths.Split.clear();
  }
  const bool isFree = directions.empty() && options.Sizing.empty();
  lengths.MostNeedless = isFree ? lengths.MostNeedless : None;
  if (!this->Cache || !this->Cache->IsFor(degree, kept, lengths, directions, own))
  {
    this->Cache.reset();
    this->Cache = std::make_unique<PreparedField>(
      *this->Input, degree, kept, lengths, directions, own, progress);
  }
  if (!options.UseEdgeLength)
  {
    const double factor = std::sqrt(this->Cache->GetAreaLeft());
    sizes.EdgeLength *= factor;
    sizes.MapLength *= factor;
  }
  const SurfaceGeometry& geometry = this->Cache->GetGeometry();
  const std::vector<double> continued = this->Cache->GetSurface().Continued(sizes.AtPoints);
  for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
  {
    sizes.AtVertices.push_back(continued[geometry.Mesh.Point(v)]);
  }
  if (!options.UseEdgeLength)
  {
    sizes.LengthenFor(geometry, options.NumberOfFaces);
  }
  return sizes;
}
}
