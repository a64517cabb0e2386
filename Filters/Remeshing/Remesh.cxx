// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remesh.h"

#include "Charts/FeatureLines.h"
#include "Computation/ComponentFields.h"
#include "Computation/Guide.h"
#include "Computation/Stages.h"
#include "Extraction/MeshExtraction.h"
#include "Finishing/FaceSources.h"
#include "Finishing/FinishedFaces.h"
#include "Finishing/JoinedFaces.h"
#include "Guidance/Guidance.h"
#include "Preparation/FeatureTurns.h"
#include "Preparation/PreparedSurface.h"
#include "Preparation/Seams.h"
#include "Preparation/SizeAdvice.h"
#include "Preparation/WantedSizes.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace DirectionFields
{
namespace
{
constexpr double LeastSize = 0.125;
// How far the progress is after each step.
constexpr double AfterPreparing = 0.12;
constexpr double AfterField = 0.4;
constexpr double AfterCells = 0.85;
constexpr double AfterJoining = 0.97;
/// Lengths of edges that differ by more than this factor are worth a sentence.
constexpr double Noticeably = 1.05;
/// Quads below this scaled Jacobian are made in another way if that makes better ones.
constexpr double Bad = 0.2;

int DegreeOf(Element element)
{
  return element == Element::Quads ? 4 : 6;
}

/// Features that end freely, or are closed, are longer than this, in wanted lengths of edges.
constexpr double ShortestFeature = 6.0;

FeatureSettings FeaturesOf(const RemeshOptions& options, double edgeLength)
{
  return { options.KeepFeatures, options.FeatureAngle, options.MinimumFeatureLength,
    ShortestFeature * edgeLength };
}

/// The wanted size at each point, clamped.
std::vector<double> SizesAt(const RemeshOptions& options, std::size_t points)
{
  std::vector<double> sizes(points, 1.0);
  for (std::size_t p = 0; p < options.Sizing.size(); ++p)
  {
    const double size = options.Sizing[p];
    sizes[p] =
      size > 0.0 && std::isfinite(size) ? std::clamp(size, LeastSize, 1.0 / LeastSize) : 1.0;
  }
  return sizes;
}
}

void Check(const RemeshOptions& options, std::size_t points)
{
  const auto require = [](bool holds, const char* what)
  {
    if (!holds)
    {
      throw std::invalid_argument(what);
    }
  };
  require(
    options.UseEdgeLength || options.NumberOfFaces >= 1, "NumberOfFaces has to be at least 1.");
  require(!options.UseEdgeLength || (options.EdgeLength > 0.0 && std::isfinite(options.EdgeLength)),
    "EdgeLength has to be a positive number.");
  require(options.Sizing.empty() || options.Sizing.size() == points,
    "There has to be one wanted size for each point of the surface.");
  require(options.FeatureAngle >= 0.0 && options.FeatureAngle <= 180.0,
    "FeatureAngle has to be between 0 and 180 degrees.");
  require(options.MinimumFeatureLength >= 0.0 && std::isfinite(options.MinimumFeatureLength),
    "MinimumFeatureLength has to be at least 0.");
  require(options.SmoothingIterations >= 0 && options.SmoothingIterations <= 1000,
    "SmoothingIterations has to be between 0 and 1000.");
  require(options.NumberOfThreads >= 0 && options.NumberOfThreads <= 1024,
    "NumberOfThreads has to be between 0 and 1024.");
}

/// What does not depend on the wanted size.
struct Remesh::Kept
{
  Kept(const Surface& surface, const RemeshOptions& options, double edgeLength,
    std::vector<double> longest, const std::vector<Vector3>& given, const Progress& progress)
    : Element(options.Element)
    , Longest(std::move(longest))
    , Given(given)
    , Prepared(surface, DegreeOf(options.Element), FeaturesOf(options, edgeLength), this->Longest,
        progress.Part(0.0, AfterPreparing / AfterField))
    , Original(this->Prepared.GetTriangles())
  {
    progress.Report(0.4);
    const int degree = DegreeOf(options.Element);
    this->IsFeature = this->Prepared.FindFeatures(FeaturesOf(options, edgeLength));
    const SurfaceGeometry& geometry = this->GetGeometry();
    if (given.empty())
    {
      Options field;
      field.Degree = degree;
      field.ConstrainBoundary = true;
      field.MergePoints = MergePoints::Off;
      field.UnitLength = true;
      std::vector<std::string> notes;
      const Guidance guidance = this->AlongFeatures();
      field.ConstrainGuidance = options.KeepFeatures;
      Stages stages(this->Prepared.GetSurface());
      const Guide guide(stages, field, guidance, notes);
      EnergyStage& energy = stages.GetEnergy(field, progress.Part(0.4, 0.7));
      this->Section =
        SolveComponents(stages, energy, guide, {}, field, false, progress.Part(0.7, 0.95)).Section;
    }
    else
    {
      Guidance guidance;
      guidance.Vectors = this->Prepared.Continued(given);
      this->Section = GuidanceSection(geometry, guidance, degree);
      Continue(geometry, degree, this->Section);
    }
    this->Charts.emplace(geometry, degree, this->Section);
    this->IsFrameless = FramelessVertices(geometry, degree, this->IsFeature);
    this->Joints.emplace(geometry.Mesh, this->Prepared.GetOriginals());
    this->Maps.resize(geometry.Mesh.GetComponents().size());
    progress.Report(1.0);
  }

  bool IsFor(const RemeshOptions& options, double edgeLength, const std::vector<double>& longest,
    const std::vector<Vector3>& given) const
  {
    return this->Element == options.Element && this->Given == given && this->Longest == longest &&
      this->IsFeature == this->Prepared.FindFeatures(FeaturesOf(options, edgeLength));
  }

  const SurfaceGeometry& GetGeometry() const { return this->Prepared.GetGeometry(); }

  /// Vectors along the features, at the points of the prepared surface.
  Guidance AlongFeatures() const
  {
    const SurfaceGeometry& geometry = this->GetGeometry();
    const std::vector<Vector3> directions = FeatureDirections(geometry, this->IsFeature);
    Guidance guidance;
    guidance.Vectors.assign(this->Prepared.GetSurface()->Points.size(), Vector3::Zero());
    for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
    {
      if (!directions[v].isZero(0.0))
      {
        guidance.Vectors[geometry.Mesh.Point(v)] = directions[v];
      }
    }
    return guidance;
  }

  DirectionFields::Element Element;
  /// How long the edges may become that the map is made on, at each point of the input; empty for its own ones.
  std::vector<double> Longest;
  std::vector<Vector3> Given;
  PreparedSurface Prepared;
  std::vector<Complex> Section;
  std::optional<FieldMatching> Charts;
  std::vector<char> IsFeature;
  std::vector<char> IsFrameless;
  std::optional<Seams> Joints;
  ClosestPoints Original;
  /// Of each component.
  std::vector<ParametrizationCache> Maps;
};

Remesh::Remesh(std::shared_ptr<const Surface> surface)
  : Input(std::move(surface))
{
}
Remesh::~Remesh() = default;
Remesh::Remesh(Remesh&&) noexcept = default;
Remesh& Remesh::operator=(Remesh&&) noexcept = default;

namespace
{
/// The wanted length of edges that gives the wanted number of faces.
double EdgeLengthFor(double area, const RemeshOptions& options)
{
  if (options.UseEdgeLength)
  {
    return options.EdgeLength;
  }
  const double face = area / options.NumberOfFaces;
  return std::sqrt(options.Element == Element::Quads ? face : 4.0 / std::sqrt(3.0) * face);
}

/// The cells of all components, with the same vertices on all sides of seams.
std::vector<ExtractedMesh> ExtractAll(
  const ExtractionInput& input, const Seams& seams, const Progress& progress, RemeshResult& result)
{
  const std::vector<TriangleMesh::Component>& components = input.Geometry.Mesh.GetComponents();
  std::vector<ExtractedMesh> all;
  const auto count = static_cast<double>(components.size());
  for (const TriangleMesh::Component& component : components)
  {
    const auto done = static_cast<double>(all.size());
    all.push_back(ExtractMesh(input, component, progress.Part(done / count, (done + 1.0) / count)));
    if (all.back().Failure != nullptr)
    {
      result.Notes.push_back("Component " + std::to_string(all.size() - 1) +
        " could not be remeshed, since " + all.back().Failure + ". It is as it was.");
    }
    result.KeptVertices += all.back().KeptVertices;
    result.FlippedTriangles += all.back().FlippedTriangles;
  }
  seams.Equalize(all);
  return all;
}

/// The cells of all components in one mesh.
FaceMesh JoinedCells(const std::vector<ExtractedMesh>& cells, const Seams& seams,
  const std::vector<char>& isTurn, RemeshResult& result)
{
  Index open = 0;
  FaceMesh mesh = JoinFaces(cells, seams, isTurn, open);
  if (open > 0)
  {
    result.Notes.push_back(std::to_string(open) +
      " seams between sheets of the surface are open in the mesh, since the faces there are too few. More faces, or "
      "shorter edges, would join them.");
  }
  return mesh;
}

/// Puts a mesh into the result.
void Take(const FaceMesh& mesh, RemeshResult& result)
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

double LeastQuality(const RemeshResult& mesh)
{
  double least = 1.0;
  for (const std::array<Index, 4>& face : mesh.Faces)
  {
    least = std::min(least, ScaledJacobian(mesh.Points, face));
  }
  return least;
}

/// Counts what a mesh is made of.
void Count(const RemeshOptions& options, const FaceMesh& mesh, RemeshResult& result)
{
  std::vector<int> valence(result.Points.size(), 0);
  for (const std::array<Index, 4>& face : result.Faces)
  {
    (face[3] == None ? result.Triangles : result.Quads) += 1;
    for (const Index v : face)
    {
      if (v != None)
      {
        ++valence[v];
      }
    }
  }
  for (std::size_t v = 0; v < valence.size(); ++v)
  {
    const bool isRegular = valence[v] == DegreeOf(options.Element) || mesh.Vertices[v].IsBoundary;
    result.IrregularVertices += isRegular ? 0 : 1;
  }
}
}

const char* Remesh::StepAt(double done)
{
  return done < AfterPreparing ? "Preparing the surface"
    : done < AfterField        ? "Computing the field"
    : done < AfterCells        ? "Mapping the surface to a grid"
                               : "Smoothing the mesh";
}

RemeshResult Remesh::Compute(const RemeshOptions& options, const std::vector<Vector3>& directions,
  const ProgressFunction& progressFunction)
{
  Check(options, this->Input->Points.size());
  Threads threads(options.NumberOfThreads);
  const Threads::Scope scope(threads);
  const Progress progress(progressFunction);
  try
  {
    RemeshResult result;
    const bool isPure = options.PureQuads && options.Element == Element::Quads;
    if (!isPure)
    {
      this->Make(options, directions, QuadPolicy::Mixed, progress, result);
      return result;
    }
    // Vertices that must not move leave triangles no room.
    const bool mayJoin = options.SmoothingIterations > 0;
    const bool isJoined =
      mayJoin && this->Make(options, directions, QuadPolicy::Joined, progress, result);
    const double quality = isJoined ? LeastQuality(result) : -1.0;
    if (quality < Bad)
    {
      RemeshResult split;
      this->Make(options, directions, QuadPolicy::Split,
        progress.Part(mayJoin ? AfterJoining : 0.0, 1.0), split);
      if (!isJoined || LeastQuality(split) > quality)
      {
        return split;
      }
    }
    return result;
  }
  catch (const Stopped&)
  {
    RemeshResult result;
    result.Aborted = true;
    return result;
  }
}

bool Remesh::Make(const RemeshOptions& options, const std::vector<Vector3>& directions,
  QuadPolicy way, const Progress& progress, RemeshResult& result)
{
  const std::vector<double> sizes = SizesAt(options, this->Input->Points.size());
  const double area = RelativeArea(*this->Input, sizes);
  result.EdgeLength = EdgeLengthFor(area, options);
  double coarse = result.EdgeLength * (way == QuadPolicy::Split ? 2.0 : 1.0);
  const std::vector<double> longest = LongestEdges(sizes, area, coarse);
  if (!this->State || !this->State->IsFor(options, coarse, longest, directions))
  {
    this->State.reset();
    this->State = std::make_unique<Kept>(
      *this->Input, options, coarse, longest, directions, progress.Part(0.0, AfterField));
  }
  Kept& kept = *this->State;
  const SurfaceGeometry& geometry = kept.GetGeometry();
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<double> size(mesh.GetNumberOfVertices());
  const std::vector<double> continued = kept.Prepared.Continued(sizes);
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    size[v] = continued[mesh.Point(v)];
  }
  const double ofArea = result.EdgeLength;
  if (!options.UseEdgeLength)
  {
    const double factor =
      std::max(1.0, LeastEdgeLength(geometry, size, options.NumberOfFaces) / ofArea);
    result.EdgeLength *= factor;
    coarse *= factor;
  }
  std::vector<double> perLength(size.size());
  for (std::size_t v = 0; v < size.size(); ++v)
  {
    perLength[v] = 1.0 / (coarse * size[v]);
  }
  std::vector<char> isFrameless = kept.IsFrameless;
  FeatureLines features(geometry, *kept.Charts, kept.IsFeature, isFrameless,
    std::vector<double>(mesh.GetComponents().size(), coarse));
  const ExtractionInput input{ geometry, *kept.Charts, features, isFrameless, kept.Section,
    perLength, kept.Maps };
  features.IsEnd.assign(mesh.GetNumberOfVertices(), 0);
  for (const Index v : kept.Joints->GetEnds())
  {
    features.IsEnd[v] = 1;
  }
  SizeAdvice advice(result.EdgeLength, DegreeOf(options.Element));
  if (result.EdgeLength > Noticeably * ofArea)
  {
    advice.Lengthen(ofArea);
  }
  for (const TriangleMesh::Component& component : mesh.GetComponents())
  {
    advice.AddComponent(geometry, component, perLength);
  }
  const std::vector<ExtractedMesh> cells =
    ExtractAll(input, *kept.Joints, progress.Part(AfterField, AfterCells), result);
  std::vector<double> reach(size.size());
  for (std::size_t v = 0; v < size.size(); ++v)
  {
    reach[v] = 0.5 * result.EdgeLength * size[v];
  }
  FaceMesh faces = JoinedCells(cells, *kept.Joints, FindTurns(geometry, features, reach), result);
  result.EulerCharacteristicBefore = kept.Joints->GetEulerCharacteristic();
  const std::vector<ClosestPoints> lines = kept.Prepared.LinesOf(geometry, features);
  const SurfaceContext ground{ *this->Input, kept.Prepared, kept.Original, lines,
    options.Sizing.empty() ? options.Sizing : sizes };
  if (!FinishFaces(faces, way, options.Element == Element::Quads, options.SmoothingIterations,
        result.EdgeLength, ground, progress.Part(AfterCells, AfterJoining)))
  {
    return false;
  }
  Take(faces, result);
  PointSources sources = SourcesOf(kept.Prepared, kept.Original, result.Points);
  result.SourceTriangle = std::move(sources.Triangle);
  result.SourceWeights = std::move(sources.Weights);
  FaceSources faceSources = SourcesOf(kept.Prepared, kept.Original, result.Points, result.Faces);
  result.FaceSource = std::move(faceSources.Triangle);
  result.MaximumDistance = faceSources.LargestDistance;
  advice.AddMesh(result.Points, faces.Cells, result.KeptVertices);
  const std::vector<std::string> sentences = advice.GetSentences();
  result.Notes.insert(result.Notes.end(), sentences.begin(), sentences.end());
  Count(options, faces, result);
  result.EulerCharacteristicAfter =
    EulerCharacteristic(static_cast<Index>(result.Points.size()), faces.Cells);
  result.Repaired = kept.Prepared.GetRepairs();
  return true;
}
}
