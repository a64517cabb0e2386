// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SolverFiles/AbaqusFile.h"

#include "Remeshing/SolverFiles/InputDeck.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <stdexcept>

using namespace DirectionFields;

namespace
{
/// Three quads in a row and a triangle behind them, in an oblique plane; point 4 is not used.
ShellMesh Row()
{
  ShellMesh mesh;
  for (int i = 0; i < 9; ++i)
  {
    const double x = i % 5;
    const double y = i < 5 ? 0.0 : 1.0;
    mesh.Points.emplace_back(x / 3.0, 0.8 * y, 0.6 * y - 0.1 * x);
  }
  mesh.Faces = { { 0, 1, 6, 5 }, { 1, 2, 7, 6 }, { 2, 3, 8, 7 }, { 3, 5, 8, None } };
  mesh.Points[5] = { -1.0 / 3.0, 0.8, 0.7 };
  return mesh;
}

std::vector<int> All(const std::map<int, InputDeck::Element>& elements)
{
  std::vector<int> numbers;
  for (const auto& entry : elements)
  {
    numbers.push_back(entry.first);
  }
  return numbers;
}

std::string ErrorOf(const ShellMesh& mesh, const AbaqusOptions& options = {})
{
  try
  {
    AbaqusText(mesh, options);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return {};
}
}

TEST(AbaqusFile, NodesAndElementsAreThoseOfTheMesh)
{
  const ShellMesh mesh = Row();
  const InputDeck deck(AbaqusText(mesh));
  ASSERT_EQ(deck.Nodes.size(), 8U);
  EXPECT_EQ(deck.Nodes.count(5), 0U);
  for (const auto& [number, place] : deck.Nodes)
  {
    EXPECT_EQ(place, mesh.Points[static_cast<std::size_t>(number - 1)]);
  }
  ASSERT_EQ(All(deck.Elements), (std::vector<int>{ 1, 2, 3, 4 }));
  for (const auto& [number, element] : deck.Elements)
  {
    const std::array<Index, 4>& face = mesh.Faces[static_cast<std::size_t>(number - 1)];
    EXPECT_EQ(element.Type, face[3] == None ? "S3" : "S4");
    ASSERT_EQ(element.Nodes.size(), face[3] == None ? 3U : 4U);
    for (std::size_t k = 0; k < element.Nodes.size(); ++k)
    {
      EXPECT_EQ(element.Nodes[k], face[k] + 1);
    }
  }
}

// CalculiX reads 20 characters of a number: of one more it loses the exponent.
TEST(AbaqusFile, NumbersAreShortEnoughAndNextToExact)
{
  ShellMesh mesh = Row();
  const std::vector<Vector3> places = { { -1.2345678901234567e-05, 1.0 / 3.0, -1e22 / 3.0 },
    { 1.2345678901234567e-305, -0.12345678901234567, -1234567.8901234567 } };
  mesh.Points[0] = places[0];
  mesh.Points[1] = places[1];
  const InputDeck deck(AbaqusText(mesh));
  EXPECT_LE(deck.LongestNumber, 20U);
  EXPECT_GE(deck.LongestNumber, 17U);
  for (int p = 0; p < 2; ++p)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double wanted = places[static_cast<std::size_t>(p)][k];
      EXPECT_NEAR(deck.Nodes.at(p + 1)[k] / wanted, 1.0, 1e-13) << wanted;
    }
  }
}

TEST(AbaqusFile, NodesInTheMiddleOfEdgesAreSharedByFaces)
{
  const ShellMesh mesh = Row();
  AbaqusOptions options;
  options.SecondOrder = true;
  const InputDeck deck(AbaqusText(mesh, options));
  // V - E + F of a ring of four faces is 0: one face touches the first one at point 5.
  std::set<std::pair<int, int>> edges;
  for (const auto& [number, element] : deck.Elements)
  {
    const std::size_t corners = element.Nodes.size() / 2;
    EXPECT_EQ(element.Type, corners == 4 ? "S8R" : "S6");
    for (std::size_t k = 0; k < corners; ++k)
    {
      const int a = element.Nodes[k];
      const int b = element.Nodes[(k + 1) % corners];
      edges.insert({ std::min(a, b), std::max(a, b) });
      EXPECT_LT(
        (2.0 * deck.Nodes.at(element.Nodes[corners + k]) - deck.Nodes.at(a) - deck.Nodes.at(b))
          .norm(),
        1e-15);
    }
  }
  EXPECT_EQ(deck.Nodes.size(), 8U + edges.size());
  EXPECT_EQ(deck.Comments.back(), "** Abaqus: STRI65 in place of S6.");
  options.SecondOrder = false;
  EXPECT_EQ(InputDeck(AbaqusText(mesh, options)).Comments.size(), deck.Comments.size() - 1);
}

// A quarter of a pipe, wound in both ways.
TEST(AbaqusFile, EdgesInTheMiddleOfACylinderAreRound)
{
  const auto worst = [](int around)
  {
    ShellMesh mesh;
    for (int i = 0; i <= around; ++i)
    {
      for (int j = 0; j <= 3; ++j)
      {
        const double angle = 0.5 * Pi * i / around;
        mesh.Points.emplace_back(std::cos(angle), std::sin(angle), j);
        const Index p = 4 * i + j;
        if (i < around && j < 3)
        {
          mesh.Faces.push_back({ p, p + 4, p + 5, p + 1 });
        }
      }
    }
    std::reverse(mesh.Faces.back().begin(), mesh.Faces.back().end());
    AbaqusOptions options;
    options.SecondOrder = true;
    const InputDeck deck(AbaqusText(mesh, options));
    double farthest = 0.0;
    for (const auto& [number, place] : deck.Nodes)
    {
      farthest = std::max(farthest, std::abs(std::hypot(place.x(), place.y()) - 1.0));
    }
    return farthest;
  };
  // Straight ones are off by 0.0086.
  EXPECT_LT(worst(6), 1e-12);
}

// The edges of a cube and the middles of a plane's faces stay straight, an arc in the plane is round.
TEST(AbaqusFile, SharpEdgesAreNotRounded)
{
  ShellMesh cube;
  for (int k = 0; k < 8; ++k)
  {
    cube.Points.emplace_back(k & 1, (k >> 1) & 1, k >> 2);
  }
  cube.Faces = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 },
    { 1, 3, 7, 5 } };
  AbaqusOptions options;
  options.SecondOrder = true;
  const InputDeck deck(AbaqusText(cube, options));
  ASSERT_EQ(deck.Nodes.size(), 20U);
  for (const auto& [number, place] : deck.Nodes)
  {
    const Vector3 doubled = 2.0 * place;
    EXPECT_EQ(doubled, doubled.array().round().matrix());
    EXPECT_EQ((place.array() == 0.5).count(), number > 8 ? 1 : 0);
  }
  // A ring around the origin, whose rims are lines.
  ShellMesh ring;
  constexpr int sides = 12;
  for (int k = 0; k < sides; ++k)
  {
    const double angle = 2.0 * Pi * k / sides;
    ring.Points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    ring.Points.emplace_back(2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.0);
    const Index p = 2 * k;
    const Index q = 2 * ((k + 1) % sides);
    ring.Faces.push_back({ p, p + 1, q + 1, q });
  }
  const InputDeck flat(AbaqusText(ring, options));
  for (const auto& [number, place] : flat.Nodes)
  {
    const double radius = place.norm();
    const double nearest = radius < 1.25 ? 1.0 : radius > 1.75 ? 2.0 : 1.5;
    EXPECT_NEAR(radius, nearest, 1e-12) << number;
    EXPECT_EQ(place.z(), 0.0);
  }
}

TEST(AbaqusFile, SetsHaveTheirMembersAndTheBoundaryItsNodes)
{
  ShellMesh mesh = Row();
  mesh.FaceSets = { { "Material -1", { 0, 2 } }, { "Material 7", { 3, 1 } }, { "Empty", {} } };
  mesh.PointSets = { { "Left edge", { 5, 0 } }, { "Corner", { 8 } } };
  const InputDeck deck(AbaqusText(mesh));
  EXPECT_EQ(deck.ElementSets.at("MATERIAL_M1"), (std::vector<int>{ 1, 3 }));
  EXPECT_EQ(deck.ElementSets.at("MATERIAL_7"), (std::vector<int>{ 2, 4 }));
  EXPECT_EQ(deck.ElementSets.count("EMPTY"), 0U);
  EXPECT_EQ(deck.NodeSets.at("LEFT_EDGE"), (std::vector<int>{ 1, 6 }));
  EXPECT_EQ(deck.NodeSets.at("CORNER"), std::vector<int>{ 9 });
  EXPECT_EQ(deck.NodeSets.at("NBOUNDARY"), (std::vector<int>{ 1, 2, 3, 4, 6, 7, 8, 9 }));

  AbaqusOptions options;
  options.SecondOrder = true;
  const InputDeck second(AbaqusText(mesh, options));
  ASSERT_EQ(second.NodeSets.at("LEFT_EDGE").size(), 3U);
  const Vector3 middle = second.Nodes.at(second.NodeSets.at("LEFT_EDGE")[2]);
  EXPECT_LT((middle - 0.5 * (mesh.Points[0] + mesh.Points[5])).norm(), 1e-15);
  // The inner edges are those between the quads, and that of the last quad and the triangle.
  EXPECT_EQ(second.NodeSets.at("NBOUNDARY").size(), 8U + 15U - 2U * 3U);
}

TEST(AbaqusFile, LinesOfSetsAreShort)
{
  ShellMesh mesh = Row();
  mesh.PointSets = { { "All", {} } };
  for (Index i = 0; i < 100; ++i)
  {
    mesh.Points.push_back(mesh.Points[0]);
    mesh.Points.back().z() += i;
  }
  for (Index i = 9; i < 107; ++i)
  {
    mesh.Faces.push_back({ 1, i, i + 1, None });
    mesh.PointSets[0].Members.push_back(i);
  }
  const InputDeck deck(AbaqusText(mesh));
  EXPECT_EQ(deck.MostWords, 16U);
  EXPECT_EQ(deck.NodeSets.at("ALL").size(), 98U);
}

TEST(AbaqusFile, NamesAreAllowedAndDifferent)
{
  ShellMesh mesh = Row();
  const std::string longName(100, 'x');
  mesh.FaceSets = { { "steel", { 0 } }, { "Steel", { 1 } }, { "(m\xC3\xBChsam)", { 2 } },
    { "3", { 3 } }, { "EALL", { 0 } }, { longName, { 1 } }, { longName + "y", { 2 } },
    { "two\nlines", { 3 } } };
  const InputDeck deck(AbaqusText(mesh));
  std::set<std::string> names;
  for (const auto& entry : deck.ElementSets)
  {
    names.insert(entry.first);
  }
  EXPECT_EQ(names,
    (std::set<std::string>{ "STEEL", "STEEL_2", "M_HSAM", "SET_3", "EALL_2", std::string(64, 'X'),
      std::string(62, 'X') + "_2", "TWO_LINES" }));
  for (const char* comment : { "** STEEL_2: Steel", "** TWO_LINES: two lines" })
  {
    EXPECT_EQ(std::count(deck.Comments.begin(), deck.Comments.end(), comment), 1) << comment;
  }
}

TEST(AbaqusFile, SectionsCoverAllFacesOnce)
{
  ShellMesh mesh = Row();
  AbaqusOptions options;
  options.Thickness = 0.125;
  const InputDeck whole(AbaqusText(mesh, options));
  ASSERT_EQ(whole.Sections.size(), 1U);
  EXPECT_EQ(whole.Sections[0].Elements, "EALL");
  EXPECT_EQ(whole.Sections[0].Material, "MATERIAL");
  EXPECT_EQ(whole.Sections[0].Thickness, 0.125);

  mesh.FaceSets = { { "A", { 0 } }, { "B", { 2, 1 } }, { "C", {} } };
  const InputDeck deck(AbaqusText(mesh, options));
  std::map<int, std::string> materials;
  for (const InputDeck::Section& section : deck.Sections)
  {
    for (const int element : deck.ElementSets.at(section.Elements))
    {
      EXPECT_TRUE(materials.emplace(element, section.Material).second);
    }
  }
  EXPECT_EQ(materials,
    (std::map<int, std::string>{ { 1, "A" }, { 2, "B" }, { 3, "B" }, { 4, "MATERIAL" } }));
}

TEST(AbaqusFile, AxesOfMaterialsAreInThePlanesOfFaces)
{
  ShellMesh mesh = Row();
  mesh.Directions = { { 0.0, 2.0, 0.0 }, { 1.0, 0.0, 5.0 }, { 0.0, 0.0, 0.0 },
    { 0.0, 1e-200, 0.0 } };
  mesh.FaceSets = { { "E 1", { 0, 1 } } };
  AbaqusOptions options;
  options.Thickness = 1.0;
  const InputDeck deck(AbaqusText(mesh, options));
  options.Thickness = 0.0;
  const InputDeck distributed(AbaqusText(mesh, options));
  ASSERT_EQ(deck.Sections.size(), 4U);
  EXPECT_EQ(distributed.Distribution.size(), 4U);
  for (const InputDeck::Section& section : deck.Sections)
  {
    const std::vector<int>& elements = deck.ElementSets.at(section.Elements);
    ASSERT_EQ(elements.size(), 1U);
    const auto f = static_cast<std::size_t>(elements[0] - 1);
    EXPECT_EQ(section.Material, f < 2 ? "E_1" : "MATERIAL");
    const std::vector<double>& six = deck.Orientations.at(section.Orientation);
    EXPECT_EQ(deck.Rotations.at(section.Orientation), (std::vector<double>{ 3.0, 0.0 }));
    EXPECT_EQ(six, distributed.Distribution.at(elements[0]));
    const Vector3 first(six[0], six[1], six[2]);
    const Vector3 second(six[3], six[4], six[5]);
    const Vector3 edge = mesh.Points[mesh.Faces[f][1]] - mesh.Points[mesh.Faces[f][0]];
    const Vector3 next = mesh.Points[mesh.Faces[f][2]] - mesh.Points[mesh.Faces[f][1]];
    const Vector3 normal = edge.cross(next).normalized();
    EXPECT_LT((first.cross(second) - normal).norm(), 1e-12) << f;
    const Vector3 wanted = f == 2 ? edge : mesh.Directions[f] * (f == 3 ? 1e200 : 1.0);
    EXPECT_NEAR(first.dot((wanted - wanted.dot(normal) * normal).normalized()), 1.0, 1e-12) << f;
  }
  EXPECT_EQ(deck.Comments[2].substr(0, 43), "** No direction in the plane of 1 elements:")
    << deck.Comments[2];
}

TEST(AbaqusFile, ErrorsSayWhatIsWrong)
{
  const auto errorWith = [](const std::function<void(ShellMesh&)>& change)
  {
    ShellMesh mesh = Row();
    change(mesh);
    return ErrorOf(mesh);
  };
  const auto isIn = [](const char* part, const std::string& text)
  { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(isIn("no faces", errorWith([](ShellMesh& mesh) { mesh.Faces.clear(); })));
  EXPECT_TRUE(isIn("Face 1 has the point 9", errorWith([](ShellMesh& m) { m.Faces[1][2] = 9; })));
  EXPECT_TRUE(isIn("Face 2 has no area",
    errorWith(
      [](ShellMesh& m) {
        m.Faces[2] = { 0, 1, 0, 1 };
      })));
  EXPECT_TRUE(isIn("Face 0 has point 6 twice. Clean makes",
    errorWith(
      [](ShellMesh& m) {
        m.Faces[0] = { 0, 1, 6, 6 };
      })));
  EXPECT_TRUE(isIn("point 3 are no finite",
    errorWith([](ShellMesh& m) { m.Points[3].y() = std::numeric_limits<double>::quiet_NaN(); })));
  EXPECT_TRUE(isIn("\"S\" has the number 4",
    errorWith(
      [](ShellMesh& m) {
        m.FaceSets = { { "S", { 4 } } };
      })));
  EXPECT_TRUE(isIn("\"P\" has the number -1",
    errorWith(
      [](ShellMesh& m) {
        m.PointSets = { { "P", { -1 } } };
      })));
  EXPECT_TRUE(
    isIn("1 directions for 4 faces", errorWith([](ShellMesh& m) { m.Directions.resize(1); })));
  AbaqusOptions options;
  options.Thickness = -1.0;
  EXPECT_TRUE(isIn("Thickness", ErrorOf(Row(), options)));
  options.Thickness = 1.0;
  ShellMesh mesh = Row();
  mesh.FaceSets = { { "A", { 0 } }, { "B", { 0 } } };
  EXPECT_TRUE(isIn("Face 0 is in two sets", ErrorOf(mesh, options)));
}
