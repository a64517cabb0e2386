// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Checks that the tests of the filters share.

#ifndef Checks_h
#define Checks_h

#include "PolyMeshes.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <cmath>
#include <cstring>
#include <iostream>
#include <string>
#include <vector>

/// Reports a failed condition and its place; the function goes on.
#define CHECK(condition)                                                                           \
  do                                                                                               \
  {                                                                                                \
    if (!(condition))                                                                              \
    {                                                                                              \
      std::cerr << __FILE__ << ":" << __LINE__ << ": failed: " #condition << std::endl;            \
      ++Checks::Failures();                                                                        \
    }                                                                                              \
  } while (false)

/// Reports a failed condition and its place, and leaves the function, whose rest needs the condition.
#define REQUIRE(condition)                                                                         \
  do                                                                                               \
  {                                                                                                \
    if (!(condition))                                                                              \
    {                                                                                              \
      std::cerr << __FILE__ << ":" << __LINE__ << ": failed: " #condition << std::endl;            \
      ++Checks::Failures();                                                                        \
      return;                                                                                      \
    }                                                                                              \
  } while (false)

namespace Checks
{
inline int& Failures()
{
  static int failures = 0;
  return failures;
}

/// The exit status of a test for ctest.
inline int Result()
{
  return Failures() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

/// Collects the errors and warnings of an algorithm, which then do not reach the screen.
class Messages : public vtkCommand
{
public:
  static Messages* New() { return new Messages; }

  void Observe(vtkAlgorithm* algorithm)
  {
    algorithm->AddObserver(vtkCommand::ErrorEvent, this);
    algorithm->AddObserver(vtkCommand::WarningEvent, this);
    // The executive repeats that its algorithm has failed.
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Executive);
  }

  void Execute(vtkObject*, unsigned long event, void* data) override
  {
    auto& list = event == vtkCommand::ErrorEvent ? this->Errors : this->Warnings;
    list.emplace_back(static_cast<const char*>(data));
  }

  /// Whether there was exactly one error and no warning, and the error has all the words.
  bool IsOneError(std::initializer_list<const char*> words) const
  {
    return this->Warnings.empty() && HasWords(this->Errors, words);
  }

  bool IsOneWarning(std::initializer_list<const char*> words) const
  {
    return this->Errors.empty() && HasWords(this->Warnings, words);
  }

  bool IsEmpty() const { return this->Errors.empty() && this->Warnings.empty(); }

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;

private:
  class Silence : public vtkCommand
  {
  public:
    static Silence* New() { return new Silence; }
    void Execute(vtkObject*, unsigned long, void*) override {}
  };

  static bool HasWords(
    const std::vector<std::string>& messages, std::initializer_list<const char*> words)
  {
    for (const std::string& message : messages)
    {
      std::cout << "Observed: " << message << std::endl;
    }
    if (messages.size() != 1)
    {
      std::cerr << messages.size() << " messages" << std::endl;
      return false;
    }
    for (const char* word : words)
    {
      if (messages[0].find(word) == std::string::npos)
      {
        std::cerr << "The message lacks: " << word << std::endl;
        return false;
      }
    }
    return true;
  }

  vtkNew<Silence> Executive;
};

inline vtkDataArray* Direction(vtkPolyData* field, int k)
{
  return field->GetPointData()->GetArray(("Direction" + std::to_string(k)).c_str());
}

inline double FieldValue(vtkPolyData* field, const char* name, vtkIdType component = 0)
{
  vtkDataArray* array = field->GetFieldData()->GetArray(name);
  return array && component < array->GetNumberOfTuples() ? array->GetTuple1(component)
                                                         : std::nan("");
}

inline int SumOfIndices(vtkDataSetAttributes* data)
{
  vtkDataArray* index = data->GetArray("SingularityIndex");
  int sum = 0;
  for (vtkIdType i = 0; index && i < index->GetNumberOfTuples(); ++i)
  {
    sum += static_cast<int>(index->GetTuple1(i));
  }
  return index ? sum : -99999;
}

/// The angle-weighted unit normal of each point of a mesh of triangles; zero at unused points.
inline std::vector<PolyMeshes::Point> Normals(vtkPolyData* mesh)
{
  std::vector<PolyMeshes::Point> normals(
    static_cast<size_t>(mesh->GetNumberOfPoints()), PolyMeshes::Point{ 0.0, 0.0, 0.0 });
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < mesh->GetPolys()->GetNumberOfCells(); ++t)
  {
    mesh->GetPolys()->GetCellAtId(t, ids);
    for (int corner = 0; corner < 3; ++corner)
    {
      const vtkIdType id = ids->GetId(corner);
      double p[3], a[3], b[3], normal[3];
      mesh->GetPoint(id, p);
      mesh->GetPoint(ids->GetId((corner + 1) % 3), a);
      mesh->GetPoint(ids->GetId((corner + 2) % 3), b);
      vtkMath::Subtract(a, p, a);
      vtkMath::Subtract(b, p, b);
      vtkMath::Cross(a, b, normal);
      vtkMath::Normalize(normal);
      const double angle = vtkMath::AngleBetweenVectors(a, b);
      for (int c = 0; c < 3; ++c)
      {
        normals[static_cast<size_t>(id)][c] += angle * normal[c];
      }
    }
  }
  for (auto& normal : normals)
  {
    vtkMath::Normalize(normal.data());
  }
  return normals;
}

/// The n directions are unit, tangent and stand counter-clockwise about the normal, 2 pi / n apart.
inline void CheckDirections(vtkPolyData* field, int degree, double tolerance)
{
  const double angle = 2.0 * PolyMeshes::Pi / degree;
  const auto normals = Normals(field);
  CHECK(Direction(field, degree) == nullptr);
  for (int k = 0; k < degree; ++k)
  {
    vtkDataArray* here = Direction(field, k);
    vtkDataArray* next = Direction(field, (k + 1) % degree);
    REQUIRE(here && next);
    REQUIRE(here->GetNumberOfTuples() == field->GetNumberOfPoints());
    REQUIRE(here->GetNumberOfComponents() == 3 && next->GetNumberOfComponents() == 3);
    double worstLength = 0.0, worstNormal = 0.0, worstTurn = 0.0;
    for (vtkIdType i = 0; i < here->GetNumberOfTuples(); ++i)
    {
      const double* normal = normals[static_cast<size_t>(i)].data();
      double d[3], e[3], side[3];
      here->GetTuple(i, d);
      next->GetTuple(i, e);
      vtkMath::Cross(normal, d, side);
      worstLength = std::max(worstLength, std::abs(vtkMath::Norm(d) - 1.0));
      worstNormal = std::max(worstNormal, std::abs(vtkMath::Dot(d, normal)));
      worstTurn = std::max({ worstTurn, std::abs(vtkMath::Dot(d, e) - std::cos(angle)),
        std::abs(vtkMath::Dot(side, e) - std::sin(angle)) });
      CHECK(std::isfinite(d[0]) && std::isfinite(d[1]) && std::isfinite(d[2]));
    }
    CHECK(worstLength < tolerance);
    CHECK(worstNormal < tolerance);
    CHECK(worstTurn < tolerance);
  }
}

/// The largest angle between Direction0 of one field and the nearest direction of the other.
inline double LargestAngle(vtkPolyData* one, vtkPolyData* other, int degree)
{
  double largest = 0.0;
  for (vtkIdType i = 0; i < one->GetNumberOfPoints(); ++i)
  {
    double d[3], e[3];
    Direction(one, 0)->GetTuple(i, d);
    double smallest = PolyMeshes::Pi;
    for (int k = 0; k < degree; ++k)
    {
      Direction(other, k)->GetTuple(i, e);
      smallest = std::min(smallest, vtkMath::AngleBetweenVectors(d, e));
    }
    largest = std::max(largest, smallest);
  }
  return largest;
}

/// Whether two arrays have the same type, size and bytes.
inline bool IsSame(vtkDataArray* one, vtkDataArray* other)
{
  return one && other && one->GetDataType() == other->GetDataType() &&
    one->GetNumberOfComponents() == other->GetNumberOfComponents() &&
    one->GetNumberOfTuples() == other->GetNumberOfTuples() &&
    (one->GetNumberOfValues() == 0 ||
      std::memcmp(one->GetVoidPointer(0), other->GetVoidPointer(0),
        static_cast<size_t>(one->GetNumberOfValues()) * one->GetDataTypeSize()) == 0);
}

inline bool IsSame(vtkFieldData* one, vtkFieldData* other)
{
  if (one->GetNumberOfArrays() != other->GetNumberOfArrays() || one->GetNumberOfArrays() == 0)
  {
    return false;
  }
  for (int i = 0; i < one->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* a = one->GetAbstractArray(i);
    vtkAbstractArray* b = other->GetAbstractArray(a->GetName());
    bool same = false;
    if (auto* text = vtkStringArray::SafeDownCast(a))
    {
      auto* otherText = vtkStringArray::SafeDownCast(b);
      same = otherText && text->GetNumberOfValues() == otherText->GetNumberOfValues();
      for (vtkIdType k = 0; same && k < text->GetNumberOfValues(); ++k)
      {
        same = text->GetValue(k) == otherText->GetValue(k);
      }
    }
    else
    {
      same = IsSame(vtkDataArray::SafeDownCast(a), vtkDataArray::SafeDownCast(b));
    }
    if (!same)
    {
      return false;
    }
  }
  return true;
}
}

#endif
