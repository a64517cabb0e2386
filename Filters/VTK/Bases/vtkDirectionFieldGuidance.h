// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDirectionFieldGuidance
 * @brief base of the filter whose fields are guided: alignment and constraints
 *
 * vtkDirectionFieldGuidance has the properties of vtkDirectionField that draw a field to curvature,
 * vectors or tensors, and those that constrain the directions of points: on the boundary, on sharp
 * edges, where the surface is curved, and where vectors are given.
 */

#ifndef vtkDirectionFieldGuidance_h
#define vtkDirectionFieldGuidance_h

#include "vtkDirectionFieldTensors.h"
#include "vtkDirectionFieldsFiltersModule.h" // For export macro

class VTKDIRECTIONFIELDSFILTERS_EXPORT vtkDirectionFieldGuidance : public vtkDirectionFieldTensors
{
public:
  vtkAbstractTypeMacro(vtkDirectionFieldGuidance, vtkDirectionFieldTensors);

  enum AlignmentType
  {
    ALIGN_NONE = 0,
    ALIGN_PRINCIPAL_CURVATURE = 1,
    ALIGN_POINT_VECTORS = 2,
    ALIGN_TENSOR = 3
  };

  ///@{
  /**
   * The guidance that the field is drawn to: none (0, default), the principal curvature directions
   * (1; degrees 2 and 4 only, else an error), GuidanceVectors (2), or the principal directions of
   * the tensors of SetTensorArray (3; degrees 2 and 4 only), which it follows as the properties of
   * vtkDirectionFieldTensors say.
   */
  vtkSetClampMacro(Alignment, int, ALIGN_NONE, ALIGN_TENSOR);
  vtkGetMacro(Alignment, int);
  ///@}

  enum CurvatureDirectionType
  {
    MAXIMUM_CURVATURE = 0,
    MINIMUM_CURVATURE = 1,
    LEAST_BENT = 2,
    MOST_BENT = 3
  };

  ///@{
  /**
   * Which principal direction a field of degree 2 is drawn or constrained to: that of the larger
   * signed curvature (0, default) or of the smaller (1), which change places where the surface
   * turns from convex to concave, or the direction in which the surface is bent least (2) or most
   * (3), which do not. Curvature is positive where the surface is convex, as seen from outside
   * where it is closed. Fields of degree 4 have both directions.
   */
  vtkSetClampMacro(CurvatureDirection, int, MAXIMUM_CURVATURE, MOST_BENT);
  vtkGetMacro(CurvatureDirection, int);
  ///@}

  ///@{
  /**
   * Radius of the surroundings of a point that its curvature is averaged over, in edges of the
   * mesh: 0 to 32. 0, the default, finds it for each point by how much of the curvature is noise.
   * The larger, the smoother are principal directions and curvature on scans, and the less they
   * know of small features; below about 2 nothing is averaged.
   */
  vtkSetClampMacro(CurvatureScale, double, 0.0, 32.0);
  vtkGetMacro(CurvatureScale, double);
  ///@}

  ///@{
  /**
   * How strongly the field is drawn, tau, free of units: lambda_t = lambda_1 - sigma tau /
   * (1 - tau) with sigma = max(lambda_1, 2 pi n / area of the component). 0 is the smoothest field,
   * 1 the guidance itself; 0.5 is lambda_t = 0 on a closed curved surface, which Knöppel et al.
   * recommend to start from. Range 0 to 1, default 0.5.
   */
  vtkSetClampMacro(AlignmentStrength, double, 0.0, 1.0);
  vtkGetMacro(AlignmentStrength, double);
  ///@}

  ///@{
  /**
   * Whether to take Shift, which is lambda_1 - lambda_t in 1 / length^2, instead of
   * AlignmentStrength: for those who know the spectrum of their surface. Default off; Shift has the
   * range 0 to VTK_DOUBLE_MAX and the default 0.
   */
  vtkSetMacro(UseShift, bool);
  vtkGetMacro(UseShift, bool);
  vtkBooleanMacro(UseShift, bool);
  vtkSetClampMacro(Shift, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Shift, double);
  ///@}

  ///@{
  /**
   * Name of the point array of 3 components that the field follows where Alignment is Point Vectors
   * or ConstrainGuidance is on; there, it is an error if there is no such array. The vectors are
   * projected to the tangent plane; their remaining length is a weight. Null, the default, an empty
   * name and "None" are no array.
   */
  vtkSetStringMacro(GuidanceVectors);
  vtkGetStringMacro(GuidanceVectors);
  ///@}

  ///@{
  /**
   * Name of a point array of 1 component with further weights of the GuidanceVectors, an error if
   * there is none; negative weights count as 0. Null, the default, an empty name and "None" are no
   * array: 1 everywhere.
   */
  vtkSetStringMacro(GuidanceWeights);
  vtkGetStringMacro(GuidanceWeights);
  ///@}

  ///@{
  /**
   * Constrain the points on the boundary to its direction: the mean of the n-th powers of its two
   * edges, so that a cross field keeps right-angled corners. Default off.
   */
  vtkSetMacro(ConstrainBoundary, bool);
  vtkGetMacro(ConstrainBoundary, bool);
  vtkBooleanMacro(ConstrainBoundary, bool);
  ///@}

  ///@{
  /**
   * Constrain the points on sharp edges to the sharpest of their edges. Default off. An edge is
   * sharp where the normals of its two triangles differ by more than FeatureAngle, in degrees:
   * range 0 to 180, default 40.
   */
  vtkSetMacro(ConstrainSharpEdges, bool);
  vtkGetMacro(ConstrainSharpEdges, bool);
  vtkBooleanMacro(ConstrainSharpEdges, bool);
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Chains of sharp edges that are shorter than this, in parts of the square root of the
   * component's area, count as noise unless they are much sharper than the edges around, or lead
   * from boundary to boundary. Range 0, which keeps all of them, to VTK_DOUBLE_MAX, default 0.5.
   */
  vtkSetClampMacro(MinimumFeatureLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumFeatureLength, double);
  ///@}

  ///@{
  /**
   * Constrain the points of high curvature to their principal directions; degrees 2 and 4 only,
   * else an error. Default off.
   */
  vtkSetMacro(ConstrainCurvature, bool);
  vtkGetMacro(ConstrainCurvature, bool);
  vtkBooleanMacro(ConstrainCurvature, bool);
  ///@}

  ///@{
  /**
   * Curvature is high where |H| l or |K| l^2 exceeds this, l being the radius of a sphere with the
   * area of the component: a sphere has 1 everywhere. Raise it for scans, whose noise is curved.
   * Range 0 to VTK_DOUBLE_MAX, default 2.
   */
  vtkSetClampMacro(CurvatureTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(CurvatureTolerance, double);
  ///@}

  ///@{
  /**
   * A curvature constraint is dropped where it differs by more than ConsistencyAngle from the
   * constraint of a neighbour, in degrees, after transport and modulo 360 / n: range 0 to 180,
   * default 30. With DropConstraintsAtSingularities, default off, so are the curvature constraints
   * of triangles around which the constraints wind, as Pellenard et al. have it.
   */
  vtkSetClampMacro(ConsistencyAngle, double, 0.0, 180.0);
  vtkGetMacro(ConsistencyAngle, double);
  vtkSetMacro(DropConstraintsAtSingularities, bool);
  vtkGetMacro(DropConstraintsAtSingularities, bool);
  vtkBooleanMacro(DropConstraintsAtSingularities, bool);
  ///@}

  ///@{
  /**
   * Name of a point array of 1 component that says how strongly ConstrainGuidance holds each of the
   * GuidanceVectors, an error if there is none: at 1 exactly; with less, tau, by the term w tau /
   * (1 - tau) sqrt(sigma A) |u - g|^2 of the energy, where w is the weight, A a third of the area
   * around the point and sigma that of AlignmentStrength; at 0 not at all. Values outside of 0 to 1
   * count as the nearer end. Null, the default, an empty name and "None" are no array: all are 1.
   */
  vtkSetStringMacro(GuidanceStrengths);
  vtkGetStringMacro(GuidanceStrengths);
  ///@}

  ///@{
  /**
   * Constrain the points where GuidanceVectors have a positive weight to these vectors, as strongly
   * as GuidanceStrengths say. Default off.
   */
  vtkSetMacro(ConstrainGuidance, bool);
  vtkGetMacro(ConstrainGuidance, bool);
  vtkBooleanMacro(ConstrainGuidance, bool);
  ///@}

  enum ConstraintSolverType
  {
    LEAST_SQUARES = 0,
    ENERGY = 1
  };

  ///@{
  /**
   * How the free points follow the constrained ones: by the least energy (1, default), or by the
   * least squares of the residual over all points, as Pellenard et al. have it (0), which takes
   * longer, mostly makes more singularities, and is refused for components of more than
   * 250 000 points. Where the field has the directions of tensors, and where GuidanceStrengths are
   * less than 1, it is by energy always.
   */
  vtkSetClampMacro(ConstraintSolver, int, LEAST_SQUARES, ENERGY);
  vtkGetMacro(ConstraintSolver, int);
  ///@}

protected:
  /**
   * The filter gives its properties their defaults, together with those of the computation.
   */
  vtkDirectionFieldGuidance() = default;
  ~vtkDirectionFieldGuidance() override;

  int Alignment;
  int CurvatureDirection;
  double CurvatureScale;
  double AlignmentStrength;
  bool UseShift;
  double Shift;
  char* GuidanceVectors = nullptr;
  char* GuidanceWeights = nullptr;
  char* GuidanceStrengths = nullptr;
  bool ConstrainBoundary;
  bool ConstrainSharpEdges;
  double FeatureAngle;
  double MinimumFeatureLength;
  bool ConstrainCurvature;
  double CurvatureTolerance;
  double ConsistencyAngle;
  bool DropConstraintsAtSingularities;
  bool ConstrainGuidance;
  int ConstraintSolver;

private:
  vtkDirectionFieldGuidance(const vtkDirectionFieldGuidance&) = delete;
  void operator=(const vtkDirectionFieldGuidance&) = delete;
};

#endif
