// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFieldAlignedRemesh
 * @brief makes a mesh of quads, or of triangles, that follows a direction field
 *
 * vtkFieldAlignedRemesh covers a surface with a new mesh of quads of about the same size whose
 * edges follow a cross field, or of equilateral triangles along a field of degree 6. Boundaries,
 * sharp edges and corners become edges and vertices of the mesh. Away from the field's
 * singularities every vertex is regular: four quads, or six triangles, meet there.
 *
 * The mesh is cut out by an integer-grid map: coordinates on the surface whose gradients follow the
 * field and that agree across every edge up to a map of the grid onto itself (D. Bommes et al.:
 * Integer-Grid Maps for Reliable Quad Meshing, 2013). The grid's points are inserted into the
 * triangles of the surface, and all other vertices are removed by local operations, which cannot
 * change the topology: whatever the map is like, the mesh is manifold, consistently wound, and has
 * as many boundaries and handles as the surface. Where the map folds, some triangles are among the
 * quads.
 *
 * @section Input Input
 * A vtkPolyData: triangles, polygons or triangle strips. If it has a direction field of degree 4 (6
 * for triangles), as output port 0 of vtkDirectionField does in the point arrays `Direction0`,
 * `Direction1`, ..., the mesh follows that, else a field of unit length along boundary and sharp
 * edges is computed, as Alignment says.
 *
 * Lines on the surface, the second input, become edges of the mesh, and points vertices.
 *
 * @section Output Output
 * Port 0: polygons, wound as the input, with its data, except the arrays of the field. Point data
 * of real numbers, and colors, are interpolated, others are those of the nearest point of the
 * triangle. Cell data of real numbers are the mean of the cells that a face covers, weighted by
 * area, others the value that covers most of it; the RegionArray is exact, and the integral of the
 * ConservedArray is kept. Also
 * - point data `VertexKind`: signed char. 0 on the surface, 1 on the boundary, 2 on a sharp edge, 3
 *   corner, 4 singularity of the field.
 * - point data `FieldIndex`: int. The singularity's index in units of 1/n, 0 elsewhere.
 * - with points in input port 1, point data `GivenPoint`: int. The number of the point, or -1.
 * - cell data `Regular`: signed char. 1 for cells of the map's grid.
 * - cell data `ScaledJacobian`, `AspectRatio` and `Warpage`: float, as Verdict defines them. The
 *   least sine of an angle of a face, relative to that of an even one: 1 for squares and even
 *   triangles, negative for faces that overlap. The longest edge times the circumference over four
 *   times the area: 1 for squares and even triangles, else more, 1e30 for a face without area. How
 *   far a quad is from a plane: 0 for one in a plane, 2 at most; 1 - what vtkMeshQuality gives.
 * - with a limit of the quality, cell data `Pass`: signed char. 1 for faces that keep all limits.
 * - field data `Faces`, `Quads`, `Triangles`, `IrregularVertices` (in the interior), `KeptVertices`
 *   (those that are no points of the grid, but could not be removed), `FlippedTriangles` (of the
 *   map), `TurnedFaces` (that look to the other side than the surface below them): int.
 * - field data `EdgeLength`, the one that was asked for; `MaximumDistance`, how far the middle of a
 *   face or edge is from the surface; and `MaximumDistanceToMesh`, how far a point of the surface
 *   is from the mesh: double, in the input's unit.
 * - field data `LeastScaledJacobian`, `MeanScaledJacobian`, `LargestAspectRatio`, `LargestWarpage`:
 *   double, over all faces; with a limit of them `FailedFaces`, the number of those that fail, and
 *   `Pass`, 1 if there are none: int.
 * - with a SizingArray: field data `EdgesAsWanted`, the part of the edges whose length is within 25
 *   % of what it asks for: double, 0 to 1. EdgeLength is that where the size is 1, or, with
 *   lengths, one that faces of even size would have.
 *   With sizes of another SizeSource `ErrorOfSizes`, too, the error that they are for: double.
 * - with the BoundarySpacing EVEN: field data `BoundaryUnevenness`, the standard deviation of the
 *   lengths of the boundary's edges, relative to their mean, between those two corners where it is
 *   largest: double. With KEEP: `BoundaryPoints`, those of the input's boundary, and
 *   `BoundaryPointsKept`, those of them that are vertices of the mesh's: int.
 * - with a RegionArray: field data `Regions`, their number, and `RegionsLost`, of those without
 *   faces: int; `BordersKept`, the part of the length of their borders that is on edges between
 *   them, to a tenth of EdgeLength: double, 0 to 1; `CornersMissed`, the places where three meet,
 *   or two at the boundary, that are no vertices: int; `LargestAreaError`, of all regions with
 *   faces, relative to the area on the surface: double.
 * - field data `EulerCharacteristic`: int, two components, of the surface and of the mesh.
 * - field data `Repairs` and `Warnings`, as vtkDirectionField.
 *
 * Port 1: the irregular vertices, with point data `Valence`, `FieldIndex` and `MissingEdges` (of a
 * regular vertex, negative for more edges): int; `Size`: float, the diameter of a ball that shows
 * the vertex, as fits the faces.
 *
 * Port 2: the lines of the mesh, a poly line for each part of its boundary, features and borders of
 * regions between the places where these end, meet or turn, and a vertex for each given point,
 * with
 * - point data `MeshPoint`: int. The number of the point on the mesh.
 * - cell data `ChainId`: int. The number of the line, from 0 on; vertices come after the lines.
 * - cell data `ChainKind`: signed char. 0 boundary, 1 feature, 2 border of regions, 3 curve of
 *   input port 1, 4 point of it.
 * - cell data `ChainName`: string. The kind, the regions beside it and a number, as in
 *   `Border steel/copper 1`: different for all lines, and the same in a finer or coarser mesh, but
 *   where lines are next to each other.
 * - cell data `FirstRegion` and `SecondRegion` with a RegionArray: int, long long where values
 *   are beyond int, -1 outside; strings, empty outside, if that is an array of strings. The
 *   second one is on the left of the line, and so are the faces at the boundary.
 * - with an input port 1, cell data `CurveId` and `GivenPoint`: int. The number of the curve that
 *   the line is on, of whatever kind it is, and of the point, each from 0 on in the order of the
 *   cells, else -1; and the cell arrays of input port 1: NaN, 0 or an empty text on lines that are
 *   on none.
 * The mesh of port 0 has them in its field data, too, for files: `ChainNames`, string, a value for
 * each line; `ChainOffsets`, int, where each line begins in `ChainPoints`, and the end; and
 * `ChainPoints`, int, the numbers of the points. Where there are regions `RegionArray`, string, is
 * the name of their cell array.
 *
 * The same input gives the same bytes, whatever the number of threads.
 *
 * @warning
 * A component with one side only, like a Moebius strip, is cut open along a line of the new mesh
 * and joined again there; polygons are wound the other way on the other side of that line. Sheets
 * that meet in edges of more than two triangles share their vertices there.
 *
 * @sa
 * vtkDirectionField
 */

#ifndef vtkFieldAlignedRemesh_h
#define vtkFieldAlignedRemesh_h

#include "vtkDirectionFieldAlgorithm.h"
#include "vtkDirectionFieldsFiltersModule.h" // For export macro

#include <memory> // For the cached computation

namespace DirectionFields
{
struct RemeshOptions;
struct TriangulatedPolyData;
}

class VTKDIRECTIONFIELDSFILTERS_EXPORT vtkFieldAlignedRemesh : public vtkDirectionFieldAlgorithm
{
public:
  static vtkFieldAlignedRemesh* New();
  vtkTypeMacro(vtkFieldAlignedRemesh, vtkDirectionFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Curves, the optional input of port 1: polydata of lines, or a composite dataset of it, on the
   * surface. They become edges of the mesh whatever KeepFeatures is. Parts that are farther from
   * the surface than a hundredth of its diagonal are left out, with a warning. Vertex cells, or all
   * points of polydata without cells, become vertices of the mesh at the closest places of the
   * surface; a warning says which are too far away, or closer than a tenth of an edge to others.
   */
  void SetCurvesConnection(vtkAlgorithmOutput* output);
  void SetCurvesData(vtkDataObject* curves);
  ///@}

  enum Elements
  {
    QUADS = 0,
    TRIANGLES = 1
  };

  ///@{
  /**
   * The faces of the mesh: QUADS (0, default), or TRIANGLES (1).
   */
  vtkSetClampMacro(Element, int, QUADS, TRIANGLES);
  vtkGetMacro(Element, int);
  ///@}

  enum SizeModes
  {
    FACES = 0,
    EDGE_LENGTH = 1,
    LENGTHS_AT_POINTS = 2
  };

  ///@{
  /**
   * How the size of the faces is given: by NumberOfFaces (FACES, 0, default), by EdgeLength
   * (EDGE_LENGTH, 1), or by the lengths that the SizingArray has at the points (LENGTHS_AT_POINTS,
   * 2), which differ by no more than a factor of 64.
   */
  vtkSetClampMacro(SizeMode, int, FACES, LENGTHS_AT_POINTS);
  vtkGetMacro(SizeMode, int);
  ///@}

  ///@{
  /**
   * The approximate number of faces, over all components. Range 1 to 10000000, default 5000.
   */
  vtkSetClampMacro(NumberOfFaces, int, 1, 10000000);
  vtkGetMacro(NumberOfFaces, int);
  ///@}

  ///@{
  /**
   * Wanted length of the edges, in the input's unit of length. Range 0 to VTK_DOUBLE_MAX, default
   * 1; 0 is an error where the SizeMode asks for it.
   */
  vtkSetClampMacro(EdgeLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(EdgeLength, double);
  ///@}

  ///@{
  /**
   * Name of a point array of 1 component: the wanted length of edges relative to elsewhere, from
   * 1/8 to 8, or, with the SizeMode LENGTHS_AT_POINTS, in the input's unit of length. An error if
   * there is none. Null, the default, an empty name and "None" are no array: the same everywhere.
   */
  vtkSetStringMacro(SizingArray);
  vtkGetStringMacro(SizingArray);
  ///@}

  enum SizeSources
  {
    ARRAY = 0,
    CURVATURE = 1,
    SECOND_DERIVATIVES = 2
  };

  ///@{
  /**
   * What sizes that vary come from: the SizingArray, if there is one (ARRAY, 0, default); the
   * curvature, so that all faces are about as far from the surface (CURVATURE, 1), without regard
   * to the SizingArray; or the second derivatives of the function that the SizingArray has at the
   * points, so that it is off by as much everywhere where it is interpolated on the faces
   * (SECOND_DERIVATIVES, 2). An error with the SizeMode LENGTHS_AT_POINTS, but for ARRAY.
   */
  vtkSetClampMacro(SizeSource, int, ARRAY, SECOND_DERIVATIVES);
  vtkGetMacro(SizeSource, int);
  ///@}

  ///@{
  /**
   * The distance of faces from the surface, in its unit (CURVATURE), or the error of the function
   * (SECOND_DERIVATIVES), at the middles of faces: as many faces are made as that needs. Range 0 to
   * VTK_DOUBLE_MAX; 0, the default, for what NumberOfFaces allows. No effect with ARRAY.
   */
  vtkSetClampMacro(MaximumError, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumError, double);
  ///@}

  ///@{
  /**
   * The factor by which lengths of edges beside each other may differ: where the SizingArray grows
   * faster, edges are shorter than it asks for, around the shortest ones. A grid cannot follow
   * jumps. Above 1, 1.3 say; 0, the default, for any, or 1.3 where the SizeSource
   * is not ARRAY. Values above 0 and up to 1 are an error. No
   * effect without a SizingArray.
   */
  vtkSetClampMacro(Gradation, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Gradation, double);
  ///@}

  ///@{
  /**
   * Whether irregular vertices are added in pairs where sizes of the SizingArray need them, as
   * RemeshOptions::AddIrregularPairs. Default on. No effect without a SizingArray, and along a
   * field that the input has.
   */
  vtkSetMacro(AddIrregularPairs, bool);
  vtkGetMacro(AddIrregularPairs, bool);
  vtkBooleanMacro(AddIrregularPairs, bool);
  ///@}

  ///@{
  /**
   * Name of a cell array of 1 component that divides the surface into regions: integers, strings,
   * or numbers that are whole. Edges between cells of different values become edges of the mesh,
   * whatever KeepFeatures is, places where three regions meet become vertices, and each face has
   * the value of the region that it is in. An error if there is none, and if the values are others
   * or number the cells. Null, the default, an empty name and "None" are no array: one region.
   */
  vtkSetStringMacro(RegionArray);
  vtkGetStringMacro(RegionArray);
  ///@}

  ///@{
  /**
   * Name of a cell array of numbers per area, as a pressure or a thickness, whose integral the mesh
   * is to have: the sum of value times area over the faces is that over the cells, of each
   * component and in each region, since means are changed by a multiple of their size. A quad has
   * the area of the triangles beside its first diagonal, as vtkIntegrateAttributes takes it. The
   * array is of doubles then. An error if there is none, and for arrays that the mesh does not take
   * over: active normals, ghost marks and those of the field. Null, the default, an empty name and
   * "None" are no array.
   */
  vtkSetStringMacro(ConservedArray);
  vtkGetStringMacro(ConservedArray);
  ///@}

  ///@{
  /**
   * Quads only: triangles are joined in pairs with the quads between them, or rows of quads between
   * them are taken out. Without smoothing the vertices of these move, too. A warning says where
   * triangles are left, in features that have too few faces. No effect on meshes of triangles.
   * Default off.
   */
  vtkSetMacro(PureQuads, bool);
  vtkGetMacro(PureQuads, bool);
  vtkBooleanMacro(PureQuads, bool);
  ///@}

  enum BoundarySpacings
  {
    FREE = 0,
    EVEN = 1,
    KEEP = 2
  };

  ///@{
  /**
   * Where the vertices on the boundary are, that is, on edges of one cell only: where faces are
   * best (FREE, 0, default), at even distances between two corners, or around (EVEN, 1), or at the
   * points of the input's boundary and nowhere else, so that the mesh fits to what is beside it
   * (KEEP, 2).
   * With KEEP faces beside the boundary are as large as its edges, and PureQuads leaves a triangle
   * where the boundary of a component has an odd number of edges, with a warning.
   */
  vtkSetClampMacro(BoundarySpacing, int, FREE, KEEP);
  vtkGetMacro(BoundarySpacing, int);
  ///@}

  ///@{
  /**
   * Make faces smaller where limbs and tips are so thin that a mesh of the wanted size would lose
   * them: the mesh is made anew then, up to three times, and a warning says where. Other edges get
   * up to 1.4 times as long so that the number of faces stays, but for a quarter more. Default on.
   */
  vtkSetMacro(KeepThinParts, bool);
  vtkGetMacro(KeepThinParts, bool);
  vtkBooleanMacro(KeepThinParts, bool);
  ///@}

  ///@{
  /**
   * Make edges of the mesh of edges sharper than FeatureAngle, and vertices of the tips of cones,
   * whose angles sum up to less than 260 degrees. The boundary always becomes edges of the mesh.
   * Default on.
   */
  vtkSetMacro(KeepFeatures, bool);
  vtkGetMacro(KeepFeatures, bool);
  vtkBooleanMacro(KeepFeatures, bool);
  ///@}

  ///@{
  /**
   * Angle between the normals of two faces above which their edge is sharp, in degrees. Range 0 to
   * 180, default 40. Below 0.5, edges are taken for flat. Where features of less than 30 degrees
   * meet at more points than a 20th of the faces, the least sharp are left out, with a warning.
   * Where edges are sharp by all angles, as those of a bent surface of few triangles, and the mesh
   * is much better without features, it has none, with a warning.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Make edges of the mesh of rims, too: edges that are bent by half of FeatureAngle or more and
   * stand out from the edges beside them, as those of fillets of few triangles and worn edges,
   * where faces have room between them. If the mesh is worse for them they are left out. No effect
   * without KeepFeatures, and for a FeatureAngle below 15 or above 90 degrees. Default on.
   */
  vtkSetMacro(KeepSoftFeatures, bool);
  vtkGetMacro(KeepSoftFeatures, bool);
  vtkBooleanMacro(KeepSoftFeatures, bool);
  ///@}

  enum Alignments
  {
    SHAPE = 0,
    SMOOTH = 1
  };

  ///@{
  /**
   * The field that is computed if the input has none: drawn to the principal curvatures where the
   * surface is bent differently in two directions, so that loops of edges go around limbs and tubes
   * (SHAPE, 0, default), or the smoothest one along boundary and sharp edges (SMOOTH, 1). Meshes of
   * triangles are made as by SMOOTH.
   */
  vtkSetClampMacro(Alignment, int, SHAPE, SMOOTH);
  vtkGetMacro(Alignment, int);
  ///@}

  ///@{
  /**
   * How strongly SHAPE draws the field: 0 not at all, 1 as much as can be, as
   * vtkDirectionField::SetAlignmentStrength. Range 0 to 1, default 0.25.
   */
  vtkSetClampMacro(AlignmentStrength, double, 0.0, 1.0);
  vtkGetMacro(AlignmentStrength, double);
  ///@}

  ///@{
  /**
   * What a singularity costs the field of SHAPE, as vtkDirectionField::SetSingularityCost: less
   * makes more irregular vertices, and edges of more even lengths where features leave them free.
   * Range 0 to 4, default 1.5.
   */
  vtkSetClampMacro(SingularityCost, double, 0.0, 4.0);
  vtkGetMacro(SingularityCost, double);
  ///@}

  ///@{
  /**
   * Steps in which vertices move along the surface so that faces become regular. 0: they stay where
   * the grid has them. Range 0 to 1000, default 12.
   */
  vtkSetClampMacro(SmoothingIterations, int, 0, 1000);
  vtkGetMacro(SmoothingIterations, int);
  ///@}

  ///@{
  /**
   * Limits that faces are to keep, for the array Pass and a warning that says how many do not; the
   * mesh stays the same. 0, the default, is no limit. Ranges 0 to 1, 0 to VTK_DOUBLE_MAX, and 0 to
   * 2.
   */
  vtkSetClampMacro(MinimumScaledJacobian, double, 0.0, 1.0);
  vtkGetMacro(MinimumScaledJacobian, double);
  vtkSetClampMacro(MaximumAspectRatio, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumAspectRatio, double);
  vtkSetClampMacro(MaximumWarpage, double, 0.0, 2.0);
  vtkGetMacro(MaximumWarpage, double);
  ///@}

  ///@{
  /**
   * Keep the field for the next mesh of the same surface, which then takes less time, and the mesh
   * itself where only data or limits change, as in time series. Default on.
   */
  vtkSetMacro(KeepStages, bool);
  vtkGetMacro(KeepStages, bool);
  vtkBooleanMacro(KeepStages, bool);
  ///@}

  ///@{
  /**
   * Threads to compute with; 0 (default) for as many as the process may run at once. Range 0 to
   * 1024.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, 1024);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

protected:
  vtkFieldAlignedRemesh();
  ~vtkFieldAlignedRemesh() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Execute(
    const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress) override;
  const char* MemoryAdvice() const override;
  void Release(bool hasFailed) override;
  int ThreadsToUse() const override;

private:
  vtkFieldAlignedRemesh(const vtkFieldAlignedRemesh&) = delete;
  void operator=(const vtkFieldAlignedRemesh&) = delete;

  DirectionFields::RemeshOptions MakeOptions(
    vtkPolyData* input, const DirectionFields::TriangulatedPolyData& surface) const;

  int Element;
  int SizeMode;
  int NumberOfFaces;
  double EdgeLength;
  char* SizingArray;
  double Gradation;
  bool AddIrregularPairs;
  char* RegionArray;
  char* ConservedArray;
  bool PureQuads;
  int BoundarySpacing;
  int SizeSource;
  double MaximumError;
  bool KeepThinParts;
  bool KeepFeatures;
  bool KeepSoftFeatures;
  double FeatureAngle;
  int Alignment;
  double AlignmentStrength;
  double SingularityCost;
  int SmoothingIterations;
  double MinimumScaledJacobian;
  double MaximumAspectRatio;
  double MaximumWarpage;
  bool KeepStages;
  int NumberOfThreads;

  struct Stages;
  std::unique_ptr<Stages> Last;
};

#endif
