// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Alignment and constraints: which arrays there are, and the texts of the messages.

#include "Checks.h"

#include "vtkDirectionField.h"

#include "vtkDoubleArray.h"
#include "vtkStringArray.h"

#include <functional>

using namespace Checks;

namespace
{
const char* const ConstraintArrays[] = { "ConstraintKind", "ConstraintDirection" };
const char* const CurvatureArrays[] = { "PrincipalDirection0", "PrincipalDirection1",
  "MeanCurvature", "GaussianCurvature" };

using Settings = std::function<void(vtkDirectionField*)>;

vtkSmartPointer<vtkPolyData> FieldOf(vtkPolyData* mesh, const Settings& settings)
{
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(mesh);
  settings(filter);
  filter->Update();
  CHECK(messages->IsEmpty());
  for (const auto* list : { &messages->Errors, &messages->Warnings })
  {
    for (const std::string& message : *list)
    {
      std::cerr << message << std::endl;
    }
  }
  return filter->GetOutput();
}

void TestError(
  vtkPolyData* mesh, const Settings& settings, std::initializer_list<const char*> words)
{
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(mesh);
  settings(filter);
  filter->Update();
  CHECK(messages->IsOneError(words));
  CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  CHECK(filter->GetOutput(1)->GetNumberOfPoints() == 0);

  // The filter works as before after the error.
  filter->SetAlignment(vtkDirectionField::ALIGN_NONE);
  filter->ConstrainCurvatureOff();
  filter->ConstrainGuidanceOff();
  filter->Update();
  CHECK(messages->Errors.size() == 1);
  CHECK(messages->Warnings.empty());
  CHECK(FieldValue(filter->GetOutput(), "IndexSum") == 2 * filter->GetDegree());
}

/// A pebble with arrays to choose from.
PolyMeshes::Mesh WithArrays(int precision = VTK_DOUBLE)
{
  auto mesh = PolyMeshes::Pebble(2, precision);
  const vtkIdType points = mesh->GetNumberOfPoints();
  vtkNew<vtkDoubleArray> around, upper, pairs, zero;
  vtkNew<vtkStringArray> labels;
  around->SetName("around");
  around->SetNumberOfComponents(3);
  around->SetNumberOfTuples(points);
  upper->SetName("upper");
  upper->SetNumberOfTuples(points);
  pairs->SetName("pairs");
  pairs->SetNumberOfComponents(2);
  pairs->SetNumberOfTuples(points);
  pairs->Fill(1.0);
  zero->SetName("zero");
  zero->SetNumberOfComponents(3);
  zero->SetNumberOfTuples(points);
  zero->Fill(0.0);
  labels->SetName("labels");
  labels->SetNumberOfTuples(points);
  for (vtkIdType i = 0; i < points; ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    around->SetTuple3(i, -p[1], p[0], 0.0);
    upper->SetValue(i, p[2] > 0.1 ? 2.0 : -1.0);
  }
  for (vtkAbstractArray* array : std::initializer_list<vtkAbstractArray*>{
         around.Get(), upper.Get(), pairs.Get(), zero.Get(), labels.Get() })
  {
    mesh->GetPointData()->AddArray(array);
  }
  return mesh;
}

/// The arrays there are, and no others.
void CheckArrays(vtkPolyData* field, bool constraints, bool curvature)
{
  for (const char* name : ConstraintArrays)
  {
    CHECK((field->GetPointData()->GetArray(name) != nullptr) == constraints);
  }
  for (const char* name : CurvatureArrays)
  {
    CHECK((field->GetPointData()->GetArray(name) != nullptr) == curvature);
  }
  for (int i = 0; i < field->GetPointData()->GetNumberOfArrays(); ++i)
  {
    CHECK(field->GetPointData()->GetAbstractArray(i)->GetNumberOfTuples() ==
      field->GetNumberOfPoints());
  }
}

void TestArrays()
{
  const auto align = [](vtkDirectionField* filter)
  { filter->SetAlignment(vtkDirectionField::ALIGN_PRINCIPAL_CURVATURE); };
  const auto constrain = [](vtkDirectionField* filter) { filter->ConstrainBoundaryOn(); };
  const auto curved = [](vtkDirectionField* filter)
  {
    filter->ConstrainCurvatureOn();
    filter->SetCurvatureTolerance(0.5);
  };
  const auto vectors = [](vtkDirectionField* filter)
  {
    filter->SetAlignment(vtkDirectionField::ALIGN_POINT_VECTORS);
    filter->SetGuidanceVectors("around");
  };
  CheckArrays(FieldOf(PolyMeshes::Square(6), [](vtkDirectionField*) {}), false, false);
  CheckArrays(FieldOf(PolyMeshes::Square(6), constrain), true, false);
  CheckArrays(FieldOf(PolyMeshes::Pebble(2), align), false, true);
  CheckArrays(FieldOf(PolyMeshes::Pebble(2), curved), true, true);
  CheckArrays(FieldOf(WithArrays(), vectors), false, false);

  // The arrays are float where the points are.
  for (const int precision : { VTK_FLOAT, VTK_DOUBLE })
  {
    auto field = FieldOf(PolyMeshes::Pebble(2, precision), curved);
    CheckArrays(field, true, true);
    vtkPointData* data = field->GetPointData();
    CHECK(data->GetArray("ConstraintKind")->GetDataType() == VTK_INT);
    CHECK(data->GetArray("ConstraintDirection")->GetDataType() == precision);
    for (const char* name : CurvatureArrays)
    {
      CHECK(data->GetArray(name)->GetDataType() == precision);
    }
    bool any = false;
    for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
    {
      const double kind = data->GetArray("ConstraintKind")->GetTuple1(i);
      const double length = vtkMath::Norm(data->GetArray("ConstraintDirection")->GetTuple3(i));
      CHECK(kind == 0.0 || kind == 3.0);
      CHECK(std::abs(length - (kind > 0.0 ? 1.0 : 0.0)) < 1e-6);
      any = any || kind > 0.0;
    }
    CHECK(any);
  }

  // Arrays that an earlier filter left are removed.
  vtkNew<vtkDirectionField> first, second;
  first->SetInputData(PolyMeshes::Pebble(2));
  curved(first);
  second->SetInputConnection(first->GetOutputPort());
  second->Update();
  CheckArrays(first->GetOutput(), true, true);
  CheckArrays(second->GetOutput(), false, false);
  // Nor where there is nothing to compute: the arrays of the last run are not the input's.
  first->ConstrainCurvatureOff();
  first->Update();
  CheckArrays(first->GetOutput(), false, false);
}

/// The figures have one tuple per component, in the order of the components, and say what was
/// computed.
void TestFieldData()
{
  auto mesh =
    PolyMeshes::BesideEachOther(PolyMeshes::Pebble(2), PolyMeshes::QuadTorus(24, 12), 4.0);
  const auto figures = [](vtkPolyData* field, const char* name, vtkIdType c)
  {
    vtkDataArray* array = field->GetFieldData()->GetArray(name);
    CHECK(array && array->GetNumberOfTuples() == 2 && array->GetNumberOfComponents() == 1);
    CHECK(array && array->GetDataType() == VTK_DOUBLE);
    return FieldValue(field, name, c);
  };
  auto smooth = FieldOf(mesh, [](vtkDirectionField*) {});
  auto aligned = FieldOf(mesh,
    [](vtkDirectionField* filter)
    {
      filter->SetAlignment(vtkDirectionField::ALIGN_PRINCIPAL_CURVATURE);
      filter->SetAlignmentStrength(0.25);
    });
  auto shifted = FieldOf(mesh,
    [](vtkDirectionField* filter)
    {
      filter->SetAlignment(vtkDirectionField::ALIGN_PRINCIPAL_CURVATURE);
      filter->UseShiftOn();
      filter->SetShift(3.5);
    });
  for (const vtkIdType c : { 0, 1 })
  {
    const double eigenvalue = figures(smooth, "Eigenvalue", c);
    CHECK(figures(smooth, "Lambda", c) == eigenvalue);
    CHECK(std::abs(figures(smooth, "SmoothnessEnergy", c) - eigenvalue) < 1e-6 * eigenvalue);
    CHECK(figures(smooth, "SystemResidual", c) == 0.0);
    CHECK(figures(aligned, "Eigenvalue", c) == eigenvalue);
    CHECK(figures(aligned, "Lambda", c) < eigenvalue);
    CHECK(figures(aligned, "SmoothnessEnergy", c) > eigenvalue);
    CHECK(figures(aligned, "SystemResidual", c) > 0.0);
    CHECK(figures(aligned, "SystemResidual", c) < 1e-6);
    CHECK(std::abs(figures(shifted, "Lambda", c) - (eigenvalue - 3.5)) < 1e-9);
  }
  CHECK(figures(smooth, "Eigenvalue", 0) != figures(smooth, "Eigenvalue", 1));
}

/// The field follows the vectors of the array that is named, with the weights of the other one.
void TestGuidance()
{
  auto mesh = WithArrays();
  const auto normals = Normals(mesh);
  const auto worst = [&](vtkPolyData* field, int degree, bool upperHalf)
  {
    vtkDataArray* around = mesh->GetPointData()->GetArray("around");
    double largest = 0.0;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double vector[3];
      around->GetTuple(i, vector);
      const double* normal = normals[static_cast<size_t>(i)].data();
      const double height = vtkMath::Dot(vector, normal);
      for (int c = 0; c < 3; ++c)
      {
        vector[c] -= height * normal[c];
      }
      // There is no direction at the poles.
      if (vtkMath::Norm(vector) > 1e-6 && (!upperHalf || mesh->GetPoint(i)[2] > 0.1))
      {
        double smallest = PolyMeshes::Pi;
        for (int k = 0; k < degree; ++k)
        {
          double d[3];
          Direction(field, k)->GetTuple(i, d);
          smallest = std::min(smallest, vtkMath::AngleBetweenVectors(vector, d));
        }
        largest = std::max(largest, smallest);
      }
    }
    return vtkMath::DegreesFromRadians(largest);
  };
  for (const int degree : { 1, 3, 4 })
  {
    const auto aligned = [degree](vtkDirectionField* filter)
    {
      filter->SetDegree(degree);
      filter->SetAlignment(vtkDirectionField::ALIGN_POINT_VECTORS);
      filter->SetGuidanceVectors("around");
      filter->SetAlignmentStrength(1.0);
    };
    const auto weighted = [&](vtkDirectionField* filter)
    {
      aligned(filter);
      filter->SetAlignmentStrength(0.9);
      filter->SetGuidanceWeights("upper");
    };
    const auto constrained = [degree](vtkDirectionField* filter)
    {
      filter->SetDegree(degree);
      filter->SetGuidanceVectors("around");
      filter->SetGuidanceWeights("upper");
      filter->ConstrainGuidanceOn();
    };
    CHECK(worst(FieldOf(mesh, aligned), degree, false) < 0.01);
    auto withWeights = FieldOf(mesh, weighted);
    CHECK(worst(withWeights, degree, false) > 1.0);
    auto hard = FieldOf(mesh, constrained);
    CHECK(worst(hard, degree, true) < 0.01);
    vtkDataArray* kind = hard->GetPointData()->GetArray("ConstraintKind");
    REQUIRE(kind);
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      CHECK(mesh->GetPoint(i)[2] > 0.1 || kind->GetTuple1(i) == 0.0);
    }
    CHECK(kind->GetRange()[1] == 5.0);
  }

  // No name, an empty one and ParaView's "None" are the same.
  const auto aligned = [](const char* weights)
  {
    return [weights](vtkDirectionField* filter)
    {
      filter->SetAlignment(vtkDirectionField::ALIGN_POINT_VECTORS);
      filter->SetGuidanceVectors("around");
      filter->SetGuidanceWeights(weights);
    };
  };
  mesh->GetPointData()->RemoveArray("labels");
  auto unweighted = FieldOf(mesh, aligned(nullptr));
  CHECK(IsSame(unweighted->GetPointData(), FieldOf(mesh, aligned(""))->GetPointData()));
  CHECK(IsSame(unweighted->GetPointData(), FieldOf(mesh, aligned("None"))->GetPointData()));
  CHECK(!IsSame(unweighted->GetPointData(), FieldOf(mesh, aligned("upper"))->GetPointData()));
  // But "None" is the name of an array if there is one.
  mesh->GetPointData()->GetArray("upper")->SetName("None");
  CHECK(!IsSame(unweighted->GetPointData(), FieldOf(mesh, aligned("None"))->GetPointData()));
}

void TestGuidanceErrors()
{
  auto mesh = WithArrays();
  const auto given = [](const char* vectors, const char* weights, bool constrain)
  {
    return [=](vtkDirectionField* filter)
    {
      filter->SetGuidanceVectors(vectors);
      filter->SetGuidanceWeights(weights);
      filter->SetConstrainGuidance(constrain);
      filter->SetAlignment(
        constrain ? vtkDirectionField::ALIGN_NONE : vtkDirectionField::ALIGN_POINT_VECTORS);
    };
  };
  for (const bool constrain : { false, true })
  {
    TestError(mesh, given("absent", nullptr, constrain), { "\"absent\"", "Guidance Vectors" });
    TestError(mesh, given("pairs", nullptr, constrain), { "\"pairs\"", "3 components" });
    TestError(mesh, given("labels", nullptr, constrain), { "\"labels\"" });
    TestError(mesh, given("around", "absent", constrain), { "\"absent\"", "Guidance Weights" });
    TestError(mesh, given("around", "pairs", constrain), { "\"pairs\"", "1 component" });
    for (const char* none : { static_cast<const char*>(nullptr), "", "None" })
    {
      TestError(mesh, given(none, nullptr, constrain), { "Guidance Vectors" });
      TestError(mesh, given(none, "upper", constrain), { "Guidance Vectors" });
    }
  }

  // An array that nothing asks for may be missing.
  auto field = FieldOf(mesh,
    [](vtkDirectionField* filter)
    {
      filter->SetGuidanceVectors("absent");
      filter->SetGuidanceWeights("absent");
    });
  CHECK(FieldValue(field, "IndexSum") == 8);
}

/// Curvature has directions for lines and crosses alone.
void TestDegrees()
{
  for (const int degree : { 1, 3, 6, 16 })
  {
    const auto align = [degree](vtkDirectionField* filter)
    {
      filter->SetDegree(degree);
      filter->SetAlignment(vtkDirectionField::ALIGN_PRINCIPAL_CURVATURE);
    };
    const auto constrain = [degree](vtkDirectionField* filter)
    {
      filter->SetDegree(degree);
      filter->ConstrainCurvatureOn();
    };
    TestError(PolyMeshes::Pebble(1), align, { "Degree", "2 or 4", "Point Vectors" });
    TestError(PolyMeshes::Pebble(1), constrain, { "Degree", "2 or 4" });
  }
}

/// Options that change nothing: one warning for all of them, and the field without them.
void TestNotes()
{
  const auto check =
    [](vtkPolyData* mesh, const Settings& settings, std::initializer_list<const char*> words)
  {
    vtkNew<vtkDirectionField> filter, plain;
    vtkNew<Messages> messages;
    messages->Observe(filter);
    filter->SetInputData(mesh);
    plain->SetInputData(mesh);
    settings(filter);
    filter->Update();
    plain->Update();
    CHECK(messages->IsOneWarning(words));
    CHECK(!filter->GetOutput()->GetPointData()->HasArray("ConstraintKind"));
    CHECK(LargestAngle(filter->GetOutput(), plain->GetOutput(), 4) == 0.0);
  };
  auto mesh = WithArrays();
  check(mesh, [](vtkDirectionField* filter) { filter->ConstrainBoundaryOn(); },
    { "Turn Constrain Boundary off: it changes nothing", "no boundary" });
  check(mesh,
    [](vtkDirectionField* filter)
    {
      filter->ConstrainSharpEdgesOn();
      filter->SetFeatureAngle(170.0);
    },
    { "Lower the Feature Angle: Constrain Sharp Edges changes nothing" });
  check(mesh,
    [](vtkDirectionField* filter)
    {
      filter->SetGuidanceVectors("zero");
      filter->SetAlignment(vtkDirectionField::ALIGN_POINT_VECTORS);
    },
    { "Choose another Alignment: this one changes nothing" });
}

/// Each constraint that changes nothing has a warning of its own, which begins with the remedy.
void TestIdleConstraints()
{
  vtkNew<vtkDirectionField> filter;
  vtkNew<Messages> messages;
  messages->Observe(filter);
  filter->SetInputData(WithArrays());
  filter->SetGuidanceVectors("zero");
  filter->ConstrainGuidanceOn();
  filter->ConstrainBoundaryOn();
  filter->ConstrainSharpEdgesOn();
  filter->SetFeatureAngle(170.0);
  filter->ConstrainCurvatureOn();
  filter->SetCurvatureTolerance(1000.0);
  filter->Update();
  CHECK(messages->Errors.empty());
  const std::vector<std::string> remedies = { "Choose other Guidance Vectors or Weights:",
    "Turn Constrain Boundary off:", "Lower the Feature Angle:", "Lower the Curvature Tolerance:" };
  CHECK(messages->Warnings.size() == remedies.size());
  for (std::size_t i = 0; i < remedies.size(); ++i)
  {
    // After the filter's name and address.
    CHECK(messages->Warnings[i].find(": " + remedies[i]) != std::string::npos);
    CHECK(messages->Warnings[i].find("changes nothing") != std::string::npos);
  }
}
}

int TestDirectionFieldAlignment(int, char*[])
{
  TestArrays();
  TestFieldData();
  TestGuidance();
  TestGuidanceErrors();
  TestDegrees();
  TestNotes();
  TestIdleConstraints();
  return Result();
}
