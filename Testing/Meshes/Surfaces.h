// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Surfaces_h
#define DirectionFields_Surfaces_h

#include "DirectionField.h"

#include <map>

/// Surfaces with known geometry. All closed ones are wound counter-clockwise as seen from outside.
namespace Meshes
{
using DirectionFields::Index;
using DirectionFields::Surface;
using DirectionFields::Vector3;

Surface Tetrahedron();
Surface Octahedron();
Surface Icosahedron();
/// Unit cube, two triangles a side.
Surface Cube();
/// Unit sphere: the icosahedron, each triangle split in four `levels` times. 10 4^levels + 2 vertices.
Surface Icosphere(int levels);
/// The upper half of the icosphere, cut along triangles.
Surface Hemisphere(int levels);
/// Square [0, size]^2 in the plane z = 0 with cells^2 squares of two triangles.
Surface Square(int cells, double size = 1.0);
/// Unit disk in the plane z = 0 of `rings` rings around a central vertex.
Surface Disk(int rings);
/// Open cylinder of radius 1 about the z axis.
Surface Cylinder(int around, int along, double height);
Surface Torus(int around, int across, double majorRadius = 1.0, double minorRadius = 0.4);
/// Closed surface of genus 2: two tori joined where they overlap, on a cubic lattice of the cell size.
Surface DoubleTorus();
/// Strip of quads closed with a half turn, of radius 1 and width 0.6.
Surface MoebiusStrip(int segments, int across = 1);
/// The orientable double cover of that, twice around at the same places.
Surface TwiceAroundMoebiusStrip(int segments, int across);
/// A figure eight turned half around while it runs around a circle; it meets itself in space only.
Surface KleinBottle(int around, int across);
/// The icosphere with opposite points made one: closed, of Euler characteristic 1.
Surface ProjectivePlane(int levels);
/// A closed surface without symmetries, like a potato, of 10 4^levels + 2 vertices.
Surface Potato(int levels);
/// Unit disk in the plane z = 0 that a turn by 90 degrees maps to itself, of 4 cells^2 squares bent
/// and cut into two triangles.
Surface FourfoldDisk(int cells);
/// Two thirds of a square of side 2 in the plane z = 0, with one reflex corner.
Surface LShape(int cells);
/// A square of side 2 in the plane z = 0 with a round hole of the radius in its middle. The sides go
/// on over a bevel of radius 0.15 down to walls if it is to be bent.
Surface PlateWithHole(int around, int across, double radius, bool bent);
/// A disk of radius 2 and height 0.3 with a hub of radius 0.8 up to the height 1.2, a bore of radius
/// 0.5 and six holes of radius 0.2 for bolts, 1.4 from the axis. Each sixth of a circle around the
/// axis has 4 fine edges.
Surface Flange(int fine);
/// Cube of side 2 whose edges and corners are cut off at 45 degrees, `cells` squares a face.
Surface ChamferedCube(int cells);
/// A ball of radius 1 with a limb of radius 0.1 and length 2 on either side of each axis.
Surface BallWithLimbs();
/// The triangles split in four without moving the middles outwards.
Surface FlatlySubdivided(const Surface& surface, int levels);
/// The points moved by pseudo-random vectors of at most the length given.
Surface Jittered(Surface surface, double length, unsigned seed);
/// The points moved along the surface's normals by normally distributed distances, as the noise of a scanner
/// does.
/// @param edges their standard deviation, in mean lengths of the edges
Surface Roughened(Surface surface, double edges, unsigned seed);

/// The same surface of needles and caps: many edges between triangles of one plane are flipped at
/// random.
Surface Scrambled(Surface surface, unsigned seed);
/// The part of the surface beyond x = 0.5 turned about that line.
Surface Folded(Surface surface, double angle);
/// The square with its inner points moved within the plane and its edges flipped; only the line x =
/// 0.5 still is one of edges, for an even number of cells.
Surface BadSquare(int cells, unsigned seed);
/// Points on the unit sphere with slivers between them: those of an icosphere, moved along it by
/// much of an edge length, but joined as they were.
Surface BadSphere(int levels, double length, unsigned seed);

Surface Transformed(const Surface& surface, const Eigen::Matrix3d& linear, const Vector3& shift);
/// A rotation about an oblique axis.
Eigen::Matrix3d ObliqueRotation(double angle);
Surface Joined(const Surface& a, const Surface& b);
/// Points in the order given by a seed, and so the triangles, with their corners turned around.
/// newPoint[i] is the new number of point i, newTriangle likewise.
Surface Shuffled(const Surface& surface, unsigned seed, std::vector<Index>& newPoint,
  std::vector<Index>& newTriangle);

/// Each triangle with three points of its own.
Surface Soup(const Surface& surface);

/// Guidance that is zero but at some points.
DirectionFields::Guidance GuidanceAt(
  const Surface& surface, const std::map<Index, Vector3>& vectors);
/// Number of the points of a field that are constrained in a way.
Index Count(const DirectionFields::Result& field, DirectionFields::ConstraintKind kind);
/// Angle in degrees from a direction to the nearest of the n directions of a field at a point.
double Deviation(const DirectionFields::Result& field, Index point, const Vector3& direction);
}

#endif
