// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files of fields that are broken, of other meshes or of unusual ones:
// TestDirectionFieldFileErrors DIRECTORY

#include "FieldFiles.h"
#include "Fields.h"
#include "PipelineChecks.h"

#include <filesystem>

using namespace Checks;
using namespace FieldFiles;

namespace
{
std::string Directory;

void CheckWriteError(
  vtkPolyData* field, const std::string& path, std::initializer_list<const char*> words)
{
  vtkNew<vtkDirectionFieldWriter> writer;
  vtkNew<Messages> messages;
  writer->AddObserver(vtkCommand::ErrorEvent, messages);
  writer->SetInputData(field);
  writer->SetFileName(path.c_str());
  writer->Write();
  CHECK(messages->IsOneError(words));
  CHECK(writer->GetErrorCode() != vtkErrorCode::NoError);
}

void CheckReadError(
  vtkPolyData* mesh, const std::string& path, std::initializer_list<const char*> words)
{
  vtkNew<vtkDirectionFieldReader> reader;
  vtkNew<Messages> messages;
  messages->Observe(reader);
  reader->SetInputData(mesh);
  reader->SetFileName(path.c_str());
  reader->Update();
  CHECK(messages->IsOneError(words));
  CHECK(reader->GetOutput()->GetNumberOfPoints() == 0);
}

void TestErrors()
{
  auto mesh = PolyMeshes::Pebble(1);
  auto field = Field(mesh, 4);
  const std::string name = Directory + "/errors";
  Remove(name);
  CheckWriteError(mesh, name + ".rosy", { "Direction0", "Apply Direction Field" });
  CheckWriteError(field, name + ".obj", { ".rosy" });
  CheckWriteError(field, name + ".xyz", { ".rosy", ".xyz" });
  CheckWriteError(field, "", { "File Name" });
  CheckWriteError(field, Directory + "/not/there.rosy", { "cannot be written" });
  CheckWriteError(Field(PolyMeshes::QuadTorus(12, 8), 4), name + ".rosy", { "Triangulate" });
  CheckWriteError(Field(mesh, 2), name + ".ffield", { "degree 4", "degree 2" });

  {
    // Windows apply the filter before a user can have chosen a file: the surface goes through.
    vtkNew<vtkDirectionFieldReader> reader;
    vtkNew<Messages> messages;
    messages->Observe(reader);
    reader->SetInputData(mesh);
    reader->Update();
    CHECK(messages->IsOneWarning({ "File Name" }));
    CHECK(reader->GetOutput()->GetNumberOfPoints() == mesh->GetNumberOfPoints());
  }
  CheckReadError(mesh, name + ".rosy", { "cannot be read" });
  CheckReadError(mesh, Directory, { ".rosy" });
  WriteFile(name + ".rosy", "80\n4\n1 0 0\n");
  CheckReadError(mesh, name + ".rosy", { "Line 4" });
  WriteFile(name + ".rosy", "1\n4\n1 0 0\n");
  CheckReadError(mesh, name + ".rosy", { "1 rows", "80 triangles", "42 points" });
  WriteFile(name + ".sing", "4 0\n");
  CheckReadError(mesh, name + ".sing", { ".rawfield" });
}

/// The filter's words for a mesh that was turned, and for what is no file.
void TestOtherMeshes()
{
  auto mesh = PolyMeshes::Pebble(2);
  const std::string name = Directory + "/other";
  Remove(name);
  CHECK(Write(Field(mesh, 4), name + ".rosy"));
  vtkNew<vtkPolyData> turned;
  turned->DeepCopy(mesh);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* p = mesh->GetPoint(i);
    turned->GetPoints()->SetPoint(i, p[2], p[1], -p[0]);
  }
  CheckReadError(turned, name + ".rosy", { "another mesh" });
  std::remove((Directory + "/device.rosy").c_str());
  std::filesystem::create_symlink("/dev/zero", Directory + "/device.rosy");
  CheckReadError(mesh, Directory + "/device.rosy", { "no regular file" });
  CheckWriteError(Field(mesh, 4), Directory + "/device.rosy", { "no regular file" });
  CHECK(!std::filesystem::exists(Directory + "/device.obj"));
}

/// Broken files are errors, whatever is wrong with them.
void TestBroken()
{
  auto mesh = PolyMeshes::Pebble(1);
  auto field = Field(mesh, 4);
  const std::string name = Directory + "/broken";
  for (const char* ending : { ".rosy", ".ffield", ".rawfield" })
  {
    Remove(name);
    CHECK(Write(field, name + ending));
    const std::string text = ReadFile(name + ending);
    for (int k = 0; k < 60; ++k)
    {
      std::string broken = text;
      const std::size_t at = (7919U * static_cast<std::size_t>(k)) % text.size();
      if (k % 3 == 0)
      {
        broken.resize(at);
      }
      else if (k % 3 == 1)
      {
        broken[at] = static_cast<char>(33 + k);
      }
      else
      {
        broken.insert(at, "\n-1e400 \xff#");
      }
      WriteFile(name + ending, broken);
      vtkNew<vtkDirectionFieldReader> reader;
      vtkNew<Messages> messages;
      messages->Observe(reader);
      reader->SetInputData(mesh);
      reader->SetFileName((name + ending).c_str());
      reader->Update();
      CHECK(messages->Errors.size() <= 1);
      CHECK(messages->Errors.empty() == (reader->GetOutput()->GetNumberOfPoints() > 0));
    }
  }
}

/// The comments that fieldgen writes, with some of them missing.
void TestFieldgen()
{
  auto mesh = PolyMeshes::Pebble(2);
  auto field = Field(mesh, 4);
  std::string text =
    "# This file contains a triangle mesh in Wavefront OBJ format.\n#    degree n\n"
    "#    field i x y z\n#field, which are associated with faces\n";
  char line[200];
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* p = mesh->GetPoint(i);
    std::snprintf(line, sizeof(line), "v %.17g %.17g %.17g\n", p[0], p[1], p[2]);
    text += line;
  }
  text += "vt 0 0\n#degree 4\n";
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* d = Direction(field, 2)->GetTuple(i);
    std::snprintf(line, sizeof(line), "#field %d %.17g %.17g %.17g\n", static_cast<int>(i + 1),
      d[0], d[1], d[2]);
    text += i == 5 ? "" : line;
  }
  const std::string path = Directory + "/fieldgen.obj";
  WriteFile(path, text);
  vtkNew<vtkDirectionFieldReader> reader;
  vtkNew<Messages> messages;
  messages->Observe(reader);
  reader->SetInputData(mesh);
  reader->SetFileName(path.c_str());
  reader->Update();
  CHECK(messages->IsOneWarning({ "1 points", "neighbours" }));
  CHECK(SumOfIndices(reader->GetOutput()) == 8);
  auto* warnings =
    vtkStringArray::SafeDownCast(reader->GetOutput()->GetFieldData()->GetAbstractArray("Warnings"));
  CHECK(warnings && warnings->GetNumberOfValues() == 1);
}

/// Surfaces that are no manifold, cannot be oriented, or are empty.
void TestUnusual()
{
  const std::string name = Directory + "/unusual";
  auto strip = PolyMeshes::Moebius(30);
  Remove(name);
  // That the strip cannot be oriented is a warning, which this does not test.
  vtkObject::GlobalWarningDisplayOff();
  auto field = Field(strip, 2);
  vtkObject::GlobalWarningDisplayOn();
  if (strip->GetPolys()->IsHomogeneous() == 3)
  {
    CHECK(Write(field, name + ".rawfield", true));
    // There are as many triangles as points.
    vtkNew<vtkDirectionFieldReader> reader;
    reader->SetInputData(strip);
    reader->SetFileName((name + ".rawfield").c_str());
    reader->SetFieldOn(vtkDirectionFieldReader::POINTS);
    reader->Update();
    vtkPolyData* back = reader->GetOutput();
    CHECK(LargestAngle(field, back, 2) < 1e-6);
  }
  vtkNew<vtkPolyData> empty;
  CheckWriteError(empty, name + ".rosy", { "Direction0" });
  WriteFile(name + ".rosy", "0\n4\n");
  auto nothing = Read(empty, name + ".rosy");
  CHECK(nothing->GetNumberOfPoints() == 0);
}
}

int TestDirectionFieldFileErrors(int argc, char* argv[])
{
  Directory = argc > 1 ? argv[1] : ".";
  TestErrors();
  TestOtherMeshes();
  TestBroken();
  TestFieldgen();
  TestUnusual();
  return Result();
}
