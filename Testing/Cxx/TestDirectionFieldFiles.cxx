// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fields that are written to files and read back: TestDirectionFieldFiles DIRECTORY

#include "Fields.h"
#include "PipelineChecks.h"

#include "vtkDirectionFieldGlyphs.h"
#include "vtkDirectionFieldReader.h"
#include "vtkDirectionFieldWriter.h"

#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkMultiBlockDataSet.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace Checks;

namespace
{
std::string Directory;

std::string ReadFile(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  return std::string((std::istreambuf_iterator<char>(stream)), {});
}

void WriteFile(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
}

void Remove(const std::string& name)
{
  for (const char* ending : { ".rosy", ".ffield", ".rawfield", ".sing", ".sharp", ".obj" })
  {
    std::remove((name + ending).c_str());
  }
}

/// Writes a field. Returns whether that went well.
bool Write(vtkPolyData* field, const std::string& path, bool onPoints = false)
{
  vtkNew<vtkDirectionFieldWriter> writer;
  writer->SetInputData(field);
  writer->SetFileName(path.c_str());
  writer->SetFieldOn(onPoints ? vtkDirectionFieldWriter::POINTS : vtkDirectionFieldWriter::CELLS);
  writer->Write();
  return writer->GetErrorCode() == vtkErrorCode::NoError;
}

vtkSmartPointer<vtkPolyData> Read(vtkPolyData* mesh, const std::string& path)
{
  vtkNew<vtkDirectionFieldReader> reader;
  reader->SetInputData(mesh);
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

int SumOfIndices(vtkPolyData* field)
{
  vtkDataArray* indices = field->GetCellData()->GetArray("SingularityIndex");
  int sum = 0;
  for (vtkIdType i = 0; indices && i < indices->GetNumberOfTuples(); ++i)
  {
    sum += static_cast<int>(indices->GetComponent(i, 0));
  }
  return sum;
}

void TestParameters()
{
  vtkNew<vtkDirectionFieldWriter> writer;
  CHECK(writer->GetFileName() == nullptr);
  CHECK(writer->GetFieldOn() == vtkDirectionFieldWriter::CELLS);
  CHECK(writer->GetFeatureAngle() == 30.0);
  CHECK(writer->GetMinimumFeatureLength() == 0.1);
  writer->SetFileName("a.rosy");
  writer->SetFieldOn(7);
  writer->SetFeatureAngle(200.0);
  writer->SetMinimumFeatureLength(-1.0);
  CHECK(PipelineChecks::Prints(writer,
    { "FileName: a.rosy\n", "FieldOn: 1\n", "FeatureAngle: 180\n", "MinimumFeatureLength: 0\n" }));
  vtkNew<vtkDirectionFieldReader> reader;
  CHECK(reader->GetFileName() == nullptr);
  CHECK(reader->GetFieldOn() == vtkDirectionFieldReader::AUTOMATIC);
  CHECK(reader->GetNumberOfOutputPorts() == 2);
  reader->SetFileName("a.rosy");
  reader->SetFieldOn(9);
  CHECK(PipelineChecks::Prints(reader, { "FileName: a.rosy\n", "FieldOn: 2\n" }));
}

/// Fields written on points come back as they were, to 1e-15 where the points are double.
void TestPoints()
{
  for (const int degree : { 1, 2, 4, 6 })
  {
    auto mesh = PolyMeshes::Pebble(3);
    auto field = Field(mesh, degree);
    const std::string path = Directory + "/points.rawfield";
    Remove(Directory + "/points");
    CHECK(Write(field, path, true));
    auto back = Read(mesh, path);
    CheckDirections(back, degree, 1e-12);
    double worst = 0.0;
    for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
    {
      for (int k = 0; k < degree; ++k)
      {
        double d[3], e[3];
        Direction(field, k)->GetTuple(i, d);
        Direction(back, k)->GetTuple(i, e);
        for (int c = 0; c < 3; ++c)
        {
          worst = std::max(worst, std::abs(d[c] - e[c]));
        }
      }
    }
    std::cout << "degree " << degree << ": largest difference " << worst << std::endl;
    CHECK(worst <= 1e-15);
    CHECK(IsSame(field->GetCellData()->GetArray("SingularityIndex"),
      back->GetCellData()->GetArray("SingularityIndex")));
    CHECK(FieldValue(back, "IndexSum") == 2 * degree);
    CHECK(FieldValue(back, "EulerCharacteristic") == 2);
    CHECK(back->GetFieldData()->GetArray("Eigenvalue") == nullptr);
  }
}

/// Fields written on cells: the files that belong together, and the field back nearly.
void TestCells()
{
  auto mesh = PolyMeshes::Pebble(4, VTK_FLOAT);
  auto field = Field(mesh, 4);
  const std::string name = Directory + "/cells";
  Remove(name);
  for (const char* ending : { ".rosy", ".ffield", ".rawfield" })
  {
    CHECK(Write(field, name + ending));
    auto back = Read(mesh, name + ending);
    CHECK(back->GetPointData()->GetArray("Direction0")->GetDataType() == VTK_FLOAT);
    CHECK(SumOfIndices(back) == 8);
    CheckDirections(back, 4, 1e-5);
    // Glyphs take it as they take our own.
    vtkNew<vtkDirectionFieldGlyphs> glyphs;
    glyphs->SetInputData(back);
    glyphs->Update();
    CHECK(FieldValue(glyphs->GetOutput(), "NumberOfGlyphs") > 1700);
  }
  CHECK(ReadFile(name + ".rosy").substr(0, 7) == "5120\n4\n");
  CHECK(ReadFile(name + ".rawfield").substr(0, 7) == "4 5120\n");
  CHECK(ReadFile(name + ".sing").substr(0, 2) == "4 ");
  CHECK(ReadFile(name + ".sharp") == "0\n");
  CHECK(ReadFile(name + ".obj").find("\nf ") != std::string::npos);
  CHECK(Write(field, name + ".sing"));

  // The singularities come along on the second port.
  vtkNew<vtkDirectionFieldReader> reader;
  reader->SetInputData(mesh);
  reader->SetFileName((name + ".rosy").c_str());
  reader->Update();
  vtkPolyData* singularities = reader->GetOutput(1);
  CHECK(singularities->GetNumberOfPoints() >= 8);
  CHECK(singularities->GetPointData()->GetArray("Index") != nullptr);
}

/// Cell arrays of directions are written as they are, to the last bits.
void TestCellArrays()
{
  auto mesh = PolyMeshes::Square(6);
  vtkNew<vtkPolyData> field;
  field->ShallowCopy(mesh);
  std::vector<std::array<double, 3>> given;
  for (int k = 0; k < 2; ++k)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(k == 0 ? "Direction0" : "Direction1");
    array->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
    {
      const double angle = 0.1 + 0.37 * static_cast<double>(i);
      const double sign = k == 0 ? 1.0 : -1.0;
      array->InsertNextTuple3(sign * std::cos(angle), sign * std::sin(angle), 0.0);
    }
    field->GetCellData()->AddArray(array);
  }
  const std::string path = Directory + "/arrays.rawfield";
  Remove(Directory + "/arrays");
  CHECK(Write(field, path));
  std::ifstream stream(path);
  int degree = 0;
  vtkIdType rows = 0;
  stream >> degree >> rows;
  CHECK(degree == 2 && rows == mesh->GetNumberOfCells());
  double worst = 0.0;
  for (vtkIdType i = 0; i < rows; ++i)
  {
    double d[6], e[3];
    stream >> d[0] >> d[1] >> d[2] >> d[3] >> d[4] >> d[5];
    field->GetCellData()->GetArray("Direction0")->GetTuple(i, e);
    const double sign = d[0] * e[0] + d[1] * e[1] > 0.0 ? 1.0 : -1.0;
    for (int c = 0; c < 3; ++c)
    {
      worst = std::max({ worst, std::abs(sign * d[c] - e[c]), std::abs(sign * d[c + 3] + e[c]) });
    }
  }
  CHECK(stream.good());
  std::cout << "cell arrays: largest difference " << worst << std::endl;
  CHECK(worst < 1e-15);
}

/// The singularities that other programs find are those that the file lists.
void TestSingularities()
{
  for (const int degree : { 1, 2, 4, 6 })
  {
    vtkNew<vtkDirectionField> filter;
    filter->SetInputData(PolyMeshes::Pebble(3));
    filter->SetDegree(degree);
    filter->CellDirectionsOn();
    filter->Update();
    vtkPolyData* field = filter->GetOutput();
    vtkDataArray* indices = field->GetPointData()->GetArray("FaceSingularityIndex");
    REQUIRE(indices);
    std::string listed;
    int count = 0;
    for (vtkIdType i = 0; i < indices->GetNumberOfTuples(); ++i)
    {
      const int index = static_cast<int>(indices->GetComponent(i, 0));
      count += index != 0 ? 1 : 0;
      listed += index != 0 ? std::to_string(i) + " " + std::to_string(index) + "\n" : "";
    }
    CHECK(count > 0);
    const std::string name = Directory + "/singularities";
    Remove(name);
    CHECK(Write(field, name + ".sing"));
    CHECK(ReadFile(name + ".sing") ==
      std::to_string(degree) + " " + std::to_string(count) + "\n" + listed);
  }
}

/// Sharp edges for QuadWild, and no mesh of the user's is replaced.
void TestCompanions()
{
  auto mesh = PolyMeshes::Icosphere(0);
  auto field = Field(mesh, 4);
  const std::string name = Directory + "/companions";
  Remove(name);
  CHECK(Write(field, name + ".rosy"));
  // All 30 edges, from both sides.
  CHECK(ReadFile(name + ".sharp").substr(0, 3) == "60\n");
  CHECK(Write(field, name + ".rosy"));
  for (const char* ending : { ".obj", ".sharp" })
  {
    Remove(name);
    WriteFile(name + ending, "mine\n");
    vtkNew<vtkDirectionFieldWriter> writer;
    vtkNew<Messages> messages;
    writer->AddObserver(vtkCommand::ErrorEvent, messages);
    writer->SetInputData(field);
    writer->SetFileName((name + ".rosy").c_str());
    writer->Write();
    CHECK(messages->IsOneError({ ending, "Choose another name" }));
    CHECK(writer->GetErrorCode() != vtkErrorCode::NoError);
    CHECK(ReadFile(name + ending) == "mine\n");
    CHECK(ReadFile(name + ".rosy").empty());
  }
}

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

void TestPipeline()
{
  auto mesh = PolyMeshes::Pebble(4);
  const std::string path = Directory + "/pipeline.rosy";
  Remove(Directory + "/pipeline");
  CHECK(Write(Field(mesh, 4), path));
  PipelineChecks::CheckProgressAndAbort(
    [&]
    {
      auto reader = vtkSmartPointer<vtkDirectionFieldReader>::New();
      reader->SetInputData(mesh);
      reader->SetFileName(path.c_str());
      return reader;
    });
  // Block by block; the file belongs to each of them.
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, mesh);
  blocks->SetBlock(2, mesh);
  vtkNew<vtkDirectionFieldReader> reader;
  reader->SetInputDataObject(blocks);
  reader->SetFileName(path.c_str());
  reader->Update();
  auto output = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  REQUIRE(output && output->GetNumberOfBlocks() == 3);
  auto block = vtkPolyData::SafeDownCast(output->GetBlock(2));
  REQUIRE(block);
  CHECK(Direction(block, 0) != nullptr);
}
}

int TestDirectionFieldFiles(int argc, char* argv[])
{
  Directory = argc > 1 ? argv[1] : ".";
  TestParameters();
  TestPoints();
  TestCells();
  TestCellArrays();
  TestSingularities();
  TestCompanions();
  TestErrors();
  TestOtherMeshes();
  TestBroken();
  TestFieldgen();
  TestUnusual();
  TestPipeline();
  return Result();
}
