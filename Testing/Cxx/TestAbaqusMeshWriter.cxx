// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes that are written for solvers: TestAbaqusMeshWriter DIRECTORY

#include "FieldFiles.h"
#include "Meshes/PolyData.h"
#include "Meshes/Surfaces.h"
#include "PipelineChecks.h"

#include "vtkAbaqusMeshWriter.h"
#include "vtkDirectionField.h"
#include "vtkFieldAlignedRemesh.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <array>
#include <filesystem>
#include <sstream>

using namespace Checks;
using FieldFiles::ReadFile;
using FieldFiles::WriteFile;

namespace
{
std::string Path;

/// Two quads, a vertex cell and a line, whose cells come before them.
vtkSmartPointer<vtkPolyData> Mesh()
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 6; ++i)
  {
    points->InsertNextPoint(i % 3, i / 3, 0.0);
  }
  mesh->SetPoints(points);
  for (int kind = 0; kind < 3; ++kind)
  {
    vtkNew<vtkCellArray> cells;
    if (kind == 2)
    {
      cells->InsertNextCell({ 0, 1, 4, 3 });
      cells->InsertNextCell({ 1, 2, 5, 4 });
    }
    else
    {
      cells->InsertNextCell(kind == 0 ? std::initializer_list<vtkIdType>{ 2 }
                                      : std::initializer_list<vtkIdType>{ 0, 1 });
    }
    kind == 0 ? mesh->SetVerts(cells) : kind == 1 ? mesh->SetLines(cells) : mesh->SetPolys(cells);
  }
  vtkNew<vtkIntArray> part;
  part->SetName("Part");
  vtkNew<vtkStringArray> material;
  material->SetName("Material");
  vtkNew<vtkDoubleArray> fibre;
  fibre->SetName("Fibre");
  fibre->SetNumberOfComponents(3);
  for (int c = 0; c < 4; ++c)
  {
    part->InsertNextValue(c == 3 ? -5 : 8);
    material->InsertNextValue(c == 3 ? "glass fibre" : "steel");
    fibre->InsertNextTuple3(0.0, c == 3 ? 2.0 : 0.0, 1.0);
  }
  mesh->GetCellData()->AddArray(part);
  mesh->GetCellData()->AddArray(material);
  mesh->GetCellData()->AddArray(fibre);
  return mesh;
}

vtkSmartPointer<vtkAbaqusMeshWriter> Writer(vtkPolyData* mesh)
{
  auto writer = vtkSmartPointer<vtkAbaqusMeshWriter>::New();
  writer->SetInputData(mesh);
  writer->SetFileName(Path.c_str());
  return writer;
}

void TestParameters()
{
  vtkNew<vtkAbaqusMeshWriter> writer;
  CHECK(writer->GetFileName() == nullptr);
  CHECK(std::string(writer->GetRegionArray()) == "Automatic");
  writer->SetFileName("a.inp");
  writer->SetRegionArray("Part");
  writer->SetDirectionArray("Fibre");
  writer->SecondOrderOn();
  writer->SetThickness(-1.0);
  CHECK(writer->GetThickness() == 0.0);
  std::ostringstream text;
  writer->Print(text);
  for (const char* line : { "FileName: a.inp\n", "RegionArray: Part\n", "DirectionArray: Fibre\n",
         "SecondOrder: 1\n", "Thickness: 0\n" })
  {
    CHECK(text.str().find(line) != std::string::npos);
  }
}

/// Cells before the polygons do not count, for their arrays either.
void TestText()
{
  const auto mesh = Mesh();
  const auto writer = Writer(mesh);
  writer->SetRegionArray("Part");
  CHECK(writer->Write() == 1);
  const std::string nodes = "*NODE, NSET=NALL\n1, 0, 0, 0\n2, 1, 0, 0\n3, 2, 0, 0\n4, 0, 1, 0\n"
                            "5, 1, 1, 0\n6, 2, 1, 0\n"
                            "*ELEMENT, TYPE=S4, ELSET=EALL\n1, 1, 2, 5, 4\n2, 2, 3, 6, 5\n";
  std::string text = ReadFile(Path);
  CHECK(text.substr(text.find("*NODE")) ==
    nodes + "** PART_8: Part 8\n*ELSET, ELSET=PART_8\n1\n** PART_M5: Part -5\n" +
      "*ELSET, ELSET=PART_M5\n2\n*NSET, NSET=NBOUNDARY\n1, 2, 3, 4, 5, 6\n");
  writer->SetRegionArray("Material");
  writer->SetDirectionArray("Fibre");
  writer->SetThickness(0.5);
  CHECK(writer->Write() == 1);
  text = ReadFile(Path);
  CHECK(text.find("*ELSET, ELSET=GLASS_FIBRE\n2\n") != std::string::npos);
  CHECK(text.find("** No direction in the plane of 1 elements") != std::string::npos);
  CHECK(text.find("*ORIENTATION, NAME=O_1\n1, 0, 0, 0, 1, 0\n3, 0.\n*SHELL SECTION, ELSET=E_1, "
                  "MATERIAL=STEEL, ORIENTATION=O_1\n0.5\n") != std::string::npos);
  CHECK(text.find("*ORIENTATION, NAME=O_2\n0, 1, 0, -1, 0, 0\n3, 0.\n*SHELL SECTION, ELSET=E_2, "
                  "MATERIAL=GLASS_FIBRE, ORIENTATION=O_2\n0.5\n") != std::string::npos);
}

/// A mesh of the remesher, with its regions.
void TestRemeshed()
{
  const auto surface = Meshes::ToPolyData(Meshes::Square(16));
  vtkNew<vtkIntArray> half;
  half->SetName("Half");
  for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c)
  {
    half->InsertNextValue(surface->GetCell(c)->GetBounds()[1] < 0.51 ? 1 : 2);
  }
  surface->GetCellData()->AddArray(half);
  vtkNew<vtkFieldAlignedRemesh> remesh;
  remesh->SetInputData(surface);
  remesh->SetRegionArray("Half");
  remesh->SetNumberOfFaces(200);
  remesh->Update();
  const auto writer = Writer(remesh->GetOutput());
  vtkNew<Messages> messages;
  writer->AddObserver(vtkCommand::WarningEvent, messages);
  // Without a word the regions are those that the mesh was made for.
  CHECK(writer->Write() == 1);
  CHECK(messages->Warnings.empty());
  const std::string automatic = ReadFile(Path);
  writer->SetRegionArray("None");
  CHECK(writer->Write() == 1);
  CHECK(ReadFile(Path).find("*ELSET") == std::string::npos);
  REQUIRE(messages->Warnings.size() == 1);
  CHECK(messages->Warnings[0].find("its regions are not in the file") != std::string::npos);
  writer->SetRegionArray("Half");
  CHECK(writer->Write() == 1);
  CHECK(messages->Warnings.size() == 1);
  CHECK(ReadFile(Path) == automatic);
  std::istringstream text(ReadFile(Path));
  std::string line;
  vtkIdType inSets = 0;
  bool isSet = false;
  while (std::getline(text, line))
  {
    if (line[0] == '*')
    {
      isSet = line.compare(0, 6, "*ELSET") == 0;
      continue;
    }
    // Full lines of sets end without a comma.
    inSets += isSet ? 1 + std::count(line.begin(), line.end(), ',') : 0;
  }
  CHECK(inSets == remesh->GetOutput()->GetNumberOfCells());
}

/// Lines of the mesh are sets of nodes, also of a mesh that has got a field meanwhile, but not of
/// another one that has them by mistake.
void TestLines()
{
  vtkNew<vtkFieldAlignedRemesh> remesh;
  remesh->SetInputData(Meshes::ToPolyData(Meshes::Square(10)));
  remesh->SetNumberOfFaces(36);
  vtkNew<vtkDirectionField> field;
  field->SetInputConnection(remesh->GetOutputPort());
  field->CellDirectionsOn();
  field->Update();
  auto writer = Writer(vtkPolyData::SafeDownCast(field->GetOutputDataObject(0)));
  writer->SetDirectionArray("Direction0");
  CHECK(writer->Write() == 1);
  std::string text = ReadFile(Path);
  for (int side = 1; side <= 4; ++side)
  {
    const std::string name = "BOUNDARY_" + std::to_string(side);
    const std::size_t at = text.find(
      "** " + name + ": Boundary " + std::to_string(side) + "\n*NSET, NSET=" + name + "\n");
    REQUIRE(at != std::string::npos);
    const std::size_t line = text.find('\n', text.find("*NSET", at)) + 1;
    const std::string nodes = text.substr(line, text.find('\n', line) - line);
    CHECK(std::count(nodes.begin(), nodes.end(), ',') == 6);
  }
  CHECK(text.find("*DISTRIBUTION") != std::string::npos);

  // A point that is kept is a set, too, with the number that it was given by.
  vtkNew<vtkPolyData> kept;
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  places->InsertNextPoint(0.5, 0.5, 0.4);
  places->InsertNextPoint(0.43, 0.61, 0.0);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  vertices->InsertNextCell({ 1 });
  kept->SetPoints(places);
  kept->SetVerts(vertices);
  remesh->SetCurvesData(kept);
  vtkNew<Messages> offSurface;
  offSurface->Observe(remesh);
  remesh->Update();
  CHECK(offSurface->IsOneWarning({ "Point 0 is no vertex of the mesh" }));
  vtkPolyData* const withPoint = remesh->GetOutput();
  CHECK(Writer(withPoint)->Write() == 1);
  vtkIdType vertex = 0;
  for (vtkIdType p = 0; p < withPoint->GetNumberOfPoints(); ++p)
  {
    vertex = withPoint->GetPointData()->GetArray("GivenPoint")->GetTuple1(p) == 1.0 ? p : vertex;
  }
  const std::array<double, 3> at = { 0.43, 0.61, 0.0 };
  CHECK(vtkMath::Distance2BetweenPoints(withPoint->GetPoint(vertex), at.data()) < 1e-30);
  text = ReadFile(Path);
  CHECK(text.find("** POINT_1: Point 1\n*NSET, NSET=POINT_1\n" + std::to_string(vertex + 1) +
          "\n") != std::string::npos);
  CHECK(text.find("POINT_0") == std::string::npos);

  vtkNew<vtkPolyData> other;
  other->DeepCopy(PolyMeshes::QuadTorus(12, 8));
  other->GetFieldData()->ShallowCopy(remesh->GetOutput()->GetFieldData());
  writer = Writer(other);
  vtkNew<Messages> messages;
  writer->AddObserver(vtkCommand::WarningEvent, messages);
  CHECK(writer->Write() == 1);
  CHECK(messages->Warnings.size() == 1);
  CHECK(ReadFile(Path).find("*NSET") == std::string::npos);
}

void CheckError(vtkAbaqusMeshWriter* writer, std::initializer_list<const char*> words)
{
  WriteFile(Path, "before");
  vtkNew<Messages> messages;
  writer->AddObserver(vtkCommand::ErrorEvent, messages);
  writer->Write();
  CHECK(messages->IsOneError(words));
  CHECK(writer->GetErrorCode() != vtkErrorCode::NoError);
  CHECK(ReadFile(Path) == "before");
}

void TestErrors()
{
  const auto mesh = Mesh();
  auto writer = Writer(mesh);
  writer->SetFileName("");
  CheckError(writer, { "File Name" });
  writer = Writer(mesh);
  writer->SetFileName((Path + "/not/there.inp").c_str());
  CheckError(writer, { "cannot be written" });
  writer = Writer(mesh);
  writer->SetRegionArray("Fibre");
  CheckError(writer, { "\"Fibre\" of 1 component" });
  writer = Writer(mesh);
  writer->SetDirectionArray("Part");
  CheckError(writer, { "\"Part\" of 3 components", "Cell Directions" });
  writer = Writer(PolyMeshes::QuadTorus(12, 8));
  writer->GetInput()->GetPolys()->InsertNextCell({ 0, 1, 2, 3, 4 });
  CheckError(writer, { "Cell 96 has 5 corners", "Triangulate" });
  const auto damaged = Mesh();
  damaged->GetPolys()->InsertNextCell({ 0, 1, 99 });
  damaged->GetCellData()->Initialize();
  CheckError(Writer(damaged), { "99" });
  const auto thin = Mesh();
  thin->GetPolys()->InsertNextCell({ 0, 1, 0 });
  thin->GetCellData()->Initialize();
  CheckError(Writer(thin), { "Face 2 has no area", "Clean" });
}
}

int TestAbaqusMeshWriter(int argc, char* argv[])
{
  Path = std::string(argc > 1 ? argv[1] : ".") + "/written.inp";
  TestParameters();
  TestText();
  TestRemeshed();
  TestLines();
  TestErrors();
  return Result();
}
