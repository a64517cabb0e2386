// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fields that are written to files and read back: TestDirectionFieldFiles DIRECTORY

#include "FieldFiles.h"
#include "Fields.h"
#include "PipelineChecks.h"

#include "vtkDirectionField.h"
#include "vtkDirectionFieldGlyphs.h"
#include "vtkFieldAlignedRemesh.h"

#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"

using namespace Checks;
using namespace FieldFiles;

namespace
{
std::string Directory;

void TestParameters()
{
  vtkNew<vtkDirectionFieldWriter> writer;
  CHECK(writer->GetFileName() == nullptr);
  CHECK(writer->GetFieldOn() == vtkDirectionFieldWriter::CELLS);
  CHECK(writer->GetFeatureAngle() == 40.0);
  // What is sharp for one filter is for all.
  CHECK(vtkNew<vtkDirectionField>()->GetFeatureAngle() == writer->GetFeatureAngle());
  CHECK(vtkNew<vtkFieldAlignedRemesh>()->GetFeatureAngle() == writer->GetFeatureAngle());
  CHECK(writer->GetMinimumFeatureLength() == 0.5);
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
    CHECK(FieldValue(glyphs->GetOutput(), "NumberOfGlyphs") > 425);
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
  TestPipeline();
  return Result();
}
