// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Remesh_h
#define DirectionFields_Remesh_h

#include "Boundary/BoundarySpacing.h"
#include "Chains/MeshChain.h"
#include "MeshError.h"
#include "Options.h"
#include "Progress.h"
#include "Regions/RegionFigures.h"
#include "Surface.h"

#include <memory>
#include <string>
#include <vector>

namespace DirectionFields
{
namespace Internal
{
class Apices;
class ChosenPoints;
class PreparedField;
struct CurveCut;
struct GivenLines;
class ThinParts;
struct WantedSizes;
}

/// The faces of the new mesh.
enum class Element
{
  /// Quads, along a field of degree 4.
  Quads = 0,
  /// Triangles, along a field of degree 6.
  Triangles = 1
};

/// The field that a mesh follows where none is given.
enum class FieldAlignment
{
  /// Of unit length, drawn to the principal curvatures where the surface is bent differently in two
  /// directions: loops of edges go around limbs and tubes. Meshes of triangles, whose fields have
  /// three lines at a point, are made as by Smooth.
  Shape = 0,
  /// The smoothest one along boundary and features.
  Smooth = 1
};

/// What sizes that vary over the surface come from.
enum class SizeSource
{
  /// RemeshOptions::Sizing has them, if it is not empty.
  Sizing = 0,
  /// The curvature: all faces are about as far from the surface at their middles.
  Curvature = 1,
  /// The second derivatives of the function that Sizing has at the points: interpolated on the
  /// faces it is off by about as much everywhere.
  SecondDerivatives = 2
};

/// The options of a new mesh. The defaults stand here and nowhere else.
struct RemeshOptions
{
  DirectionFields::Element Element = DirectionFields::Element::Quads;
  /// About how many faces there are to be. At least 1.
  Index NumberOfFaces = 5000;
  /// Take EdgeLength in place of NumberOfFaces.
  bool UseEdgeLength = false;
  /// Wanted length of the edges, in the unit of the surface. Above 0.
  double EdgeLength = 1.0;
  /// Wanted length of the edges at each point relative to elsewhere; empty for the same everywhere.
  /// Values are clamped to 1/8 ... 8; values that are no positive numbers count as 1.
  std::vector<double> Sizing;
  /// Sizing is the wanted length itself, in the unit of the surface, in place of NumberOfFaces and
  /// EdgeLength. All lengths have to be finite and above 0. A note says where they differ by more
  /// than a factor of 64, which no mesh reaches.
  bool SizingIsLength = false;
  /// With other sources than SizeSource::Sizing edges differ by a factor of 32 at most, and by
  /// Gradation, or 1.3 where that is 0, from one to the next. NumberOfFaces, or that of even faces
  /// of EdgeLength, is kept, but for MaximumError. SizingIsLength has to be off.
  DirectionFields::SizeSource SizeSource = DirectionFields::SizeSource::Sizing;
  /// The distance of faces from the surface, in its unit, or the error of the function at their
  /// middles, for the other sources: as many faces are made as it needs. At least 0; 0 for what
  /// NumberOfFaces or EdgeLength allows.
  double MaximumError = 0.0;
  /// The factor by which lengths of edges beside each other may differ: sizes that grow faster are
  /// made smaller, around the smallest ones. Above 1; 0 for any. No effect without Sizing.
  double Gradation = 0.0;
  /// Irregular vertices are added in pairs where sizes that vary need them: the field, if none is
  /// given, is the smoothest one where lengths count in units of the size. Without them edges get
  /// only those lengths that the field of even sizes allows. No effect without Sizing.
  bool AddIrregularPairs = true;
  /// Only quads: triangles are joined in pairs with the quads between them, also without smoothing;
  /// vertices of other faces stay on the grid then. Notes say where triangles are left.
  bool PureQuads = false;
  /// Where the vertices on the boundary are. With BoundarySpacing::Keep and PureQuads a triangle is
  /// left in components whose boundary has an odd number of edges, and a note says so.
  DirectionFields::BoundarySpacing BoundarySpacing = DirectionFields::BoundarySpacing::Free;
  /// Faces are smaller where limbs and tips are so thin that a mesh of the wanted size would lose
  /// them: the mesh is made anew then, up to three times, and a note says where. The other faces
  /// get larger for it; there may be a quarter more than wanted. Likewise down to .55 of the length
  /// at borders of regions that are arcs, so that these are a thousandth of the surface's diagonal
  /// from the mesh.
  bool KeepThinParts = true;
  /// Sharp edges become edges of the new mesh, and tips of cones, whose angles sum up to less than
  /// 260 degrees, vertices. The boundary always becomes edges.
  bool KeepFeatures = true;
  /// As in Options, but 0.5 for less. Where features of less than 30 degrees meet at more points
  /// than a 20th of the faces, the least sharp are left out, and a note says so. Where edges are
  /// sharp by all angles, as those of a bent surface of few triangles, and the mesh is much better
  /// without features, it has none, and a note says so, too.
  double FeatureAngle = DefaultFeatureAngle;
  double MinimumFeatureLength = DefaultMinimumFeatureLength;
  /// With KeepFeatures and a FeatureAngle from 15 to 90 degrees edges that are bent less become
  /// edges of the new mesh, too, from half of that angle and 15 degrees on, where they stand out
  /// and have room: rims of fillets of few triangles, and worn edges. Where the mesh would be worse
  /// for it they are left out.
  bool KeepSoftFeatures = true;
  /// The region of each triangle of the surface, any numbers; empty for one region. Borders between
  /// regions become edges of the new mesh, and places where three meet vertices, whatever the
  /// features are; but for borders that run in stairs along the triangles, as those do that were
  /// drawn on the surface.
  std::vector<Index> Regions;
  /// Names of the regions in sentences for the user, by their numbers, which are from 0 on then;
  /// empty for the numbers.
  std::vector<std::string> RegionNames;
  /// The field, if none is given.
  FieldAlignment Alignment = FieldAlignment::Shape;
  /// How strongly the field is drawn to the principal curvatures for Alignment::Shape, as
  /// Options::AlignmentStrength: 0 for not at all, 1 for as much as can be. Range 0 to 1.
  double AlignmentStrength = 0.25;
  /// The cost of a singularity of the field for Alignment::Shape and a strength above 0, as
  /// Options::SingularityCost: less makes more irregular vertices, and edges of more even lengths
  /// where features leave them free.
  /// Range 0 to 4.
  double SingularityCost = 1.5;
  /// Steps in which vertices move so that faces become regular. 0 leaves them on the grid. Range 0
  /// to 1000.
  int SmoothingIterations = 12;
  /// As in Options.
  int NumberOfThreads = 0;
};

/// Throws std::invalid_argument, its text a sentence for the user, for options out of range.
/// @param points, triangles of the surface
void Check(const RemeshOptions& options, std::size_t points, std::size_t triangles);

/// Whether these are the same, so that the mesh of a surface and its field is, too.
bool AreSame(const RemeshOptions& a, const RemeshOptions& b);

/// The factor by which edges beside each other differ at most where sizes are for an error.
double GradationOfErrors(const RemeshOptions& options);

/// The length of edges that is asked for, or that gives the wanted number of faces.
/// @param area of the surface in units of the square of the size there
double EdgeLengthFor(double area, const RemeshOptions& options);

/// The role of a vertex of the new mesh.
enum class VertexKind : signed char
{
  Surface = 0,
  Boundary = 1,
  Feature = 2,
  /// Features end, meet or turn there.
  Corner = 3,
  /// A singularity of the field.
  Cone = 4
};

/// A mesh along a field.
struct RemeshResult
{
  std::vector<Vector3> Points;
  /// Corners counter-clockwise as the surface is wound; the fourth one of a triangle is None.
  std::vector<std::array<Index, 4>> Faces;
  std::vector<VertexKind> Kind;
  /// Singularity index at each point, in units of 1/n: 0 but at cones.
  std::vector<int> FieldIndex;
  /// Whether a face is a cell of the regular grid.
  std::vector<char> Regular;
  /// Where each point is on the surface given: a triangle, and weights of its corners.
  std::vector<Index> SourceTriangle;
  std::vector<std::array<double, 3>> SourceWeights;
  /// The triangle that the middle of each face is closest to, of those in the face's region.
  std::vector<Index> FaceSource;
  /// The region of each face, which FaceSource is in, too; empty where no regions are given.
  std::vector<Index> Regions;
  RegionFigures RegionsShown;
  BoundaryFigures Boundary;
  /// Boundary, features, borders of regions and curves, by kind, regions and place, and then the
  /// given points that are vertices, in their order.
  std::vector<MeshChain> Chains;

  /// Interior vertices with another number of edges than 4, or 6 for triangles.
  Index IrregularVertices = 0;
  /// Vertices that are there because the map is no grid around them.
  Index KeptVertices = 0;
  Index FlippedTriangles = 0;
  /// Faces that look to the other side than the surface below them, as beside a line that bends
  /// more than edges can follow.
  Index TurnedFaces = 0;
  Index Quads = 0;
  Index Triangles = 0;
  /// Largest distance of a middle of a face or edge from the surface, in its unit.
  double MaximumDistance = 0.0;
  /// Largest distance of a point of the surface from the mesh, in its unit: of those points that
  /// decimation leaves, which moves the surface by a tenth of an edge at most.
  double MaximumDistanceToMesh = 0.0;
  /// Largest distance of the boundaries of surface and mesh from each other, both ways, in its
  /// unit; 0 where one of them has none.
  double MaximumBoundaryDistance = 0.0;
  /// V - E + F of the repaired surface and of the mesh.
  int EulerCharacteristicBefore = 0;
  int EulerCharacteristicAfter = 0;
  /// The length of edges that was asked for; with sizes that where they are 1, and with lengths one
  /// that faces of even size would have.
  double EdgeLength = 0.0;
  /// Whether there were sizes or lengths, and the part of all edges, from 0 to 1, whose length is
  /// within 25 % of what they ask for.
  bool IsSized = false;
  /// With SizeSource::Curvature and SecondDerivatives the error at the middles of faces that the
  /// sizes are for, in the unit of the surface or the function; else 0.
  double ErrorOfSizes = 0.0;
  double EdgesAsWanted = 1.0;
  Repairs Repaired;
  /// Sentences for the user.
  std::vector<std::string> Notes;
  bool Aborted = false;
};

/// Makes meshes of quads or triangles that follow a direction field. Everything that does not
/// depend on the wanted size is cached for the next mesh. Two threads may not use one object at the
/// same time.
class Remesh
{
public:
  /// Shares the surface, which must not change any more.
  /// @param curves lines on the surface that become edges of the meshes, each a row of points, the
  ///               first one again at the end of closed ones. They are projected to the surface;
  ///               parts that are farther from it than a hundredth of its diagonal are left out,
  ///               and a note says so.
  /// @param points that become vertices of the meshes, at the closest places of the surface. Those
  ///               farther away than a hundredth of its diagonal are left out, and so are those
  ///               closer than a tenth of an edge to one before them; notes say so.
  /// Throws std::invalid_argument for coordinates that are no finite numbers.
  explicit Remesh(std::shared_ptr<const Surface> surface,
    const std::vector<std::vector<Vector3>>& curves = {}, const std::vector<Vector3>& points = {});
  ~Remesh();
  Remesh(Remesh&&) noexcept;
  Remesh& operator=(Remesh&&) noexcept;

  /// Throws MeshError for a surface that cannot be processed, and std::invalid_argument.
  /// @param directions any of the directions of a field of degree 4 (6 for triangles) at each point
  ///                   of the surface; empty to compute one along boundary and features, as
  ///                   RemeshOptions::Alignment says
  RemeshResult Compute(const RemeshOptions& options, const std::vector<Vector3>& directions = {},
    const ProgressFunction& progress = {});

  /// The step of the computation at a fraction of the progress, in words for the user.
  static const char* StepAt(double done);

private:
  /// How far the progress is after the first mesh, and after those with smaller faces at thin
  /// parts.
  static constexpr double AfterFirst = 0.9;
  static constexpr double AfterShrinkings = 0.96;

  /// Throws std::invalid_argument, its text a sentence for the user, for lengths of edges that are
  /// no positive numbers, that need more faces than a mesh can have, or that are longer than the
  /// surface.
  void RequirePossible(const RemeshOptions& options) const;
  void RequireShort(const RemeshOptions& options) const;
  /// Options with the lengths that another source of sizes asks for, and the error that these are
  /// for. Throws MeshError, and std::invalid_argument for values that are no function.
  RemeshOptions WithSizes(const RemeshOptions& given, double& error) const;
  /// Options for the surface that is computed on, with sizes that are relative and grow as they
  /// may.
  RemeshOptions InUnitOfInput(const RemeshOptions& given, std::vector<std::string>& notes) const;
  /// Cuts the surface along the lines given, if that is not done yet. Throws MeshError and Stopped.
  void CutSurface(const Progress& progress);
  /// Makes a mesh of the surface given, with the sizes of these options, in the unit within.
  RemeshResult MakeForGiven(
    const RemeshOptions& given, const std::vector<Vector3>& directions, const Progress& progress);
  /// Makes a mesh with lengths for an error, and others with shorter ones where faces are farther
  /// from the surface than that.
  RemeshResult MakeForError(const RemeshOptions& given, double error, double gradation,
    const std::vector<Vector3>& directions, const Progress& progress);
  /// Makes a mesh, of many accidental features without them if that is as good. Throws Stopped.
  void Make(const RemeshOptions& options, const std::vector<Vector3>& directions,
    const Progress& progress, RemeshResult& result);
  /// What the user is told where accidental features are left out; empty where there are few.
  std::string AboutAccidental(
    const RemeshOptions& options, const std::vector<Vector3>& directions, const Progress& progress);
  /// How long edges may be where borders of regions bend, see LengthsAtBorders: even sizes only.
  std::vector<double> LengthsAtArcs(const RemeshOptions& options) const;
  /// Makes a mesh, and others where that one loses thin parts or has faces that are of no use.
  /// Throws Stopped.
  /// @param without a mesh without the features of these options, or null. Returns false after the
  ///                first mesh where that is not better.
  bool MakeRounds(const RemeshOptions& options, const std::vector<Vector3>& directions,
    const RemeshResult* without, const Progress& progress, RemeshResult& result);
  /// Makes a mesh with soft features, and one without where that one is bad. Returns the options of
  /// the better one.
  RemeshOptions MakeFirst(const RemeshOptions& options, const std::vector<Vector3>& directions,
    const Internal::ThinParts& thin, const Progress& progress, RemeshResult& result);
  /// Makes one mesh, with smaller faces at thin parts.
  /// @param gridLength of the grid's edges, as a part of the wanted one
  void MakeOnce(const RemeshOptions& options, const std::vector<Vector3>& directions,
    const Internal::ThinParts& thin, double gridLength, const Progress& progress,
    RemeshResult& result);
  /// Makes sure that the cache has the surface and the field for these options.
  Internal::WantedSizes Prepare(const RemeshOptions& options,
    const std::vector<Vector3>& directions, const Internal::ThinParts& thin,
    const Progress& progress);

  /// Of all places and lengths within: others than those of the surface where that is very far from
  /// 0 for its size, very large or small.
  Vector3 Origin;
  double Unit;
  std::shared_ptr<const Surface> Given;
  /// Cut along the curves, if there are any.
  std::shared_ptr<const Surface> Input;
  std::unique_ptr<Internal::GivenLines> Lines;
  std::unique_ptr<Internal::CurveCut> Cut;
  std::unique_ptr<Internal::ChosenPoints> Points;
  std::unique_ptr<Internal::Apices> Tips;
  std::unique_ptr<Internal::PreparedField> Cache;
  /// The last map has so many integers that each one takes far longer than all else.
  bool IsCostly = false;
  /// What the user is told about features that are left out; empty for none.
  std::vector<std::string> AboutFeatures;
};
}

#endif
