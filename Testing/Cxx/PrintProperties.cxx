// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints defaults and ranges of the filters' properties as JSON, by the names that the filters have in
// ParaView, for comparison with the server manager's. Switches and names of arrays have no range, names that
// are not set are null.

#include "vtkAbaqusMeshWriter.h"
#include "vtkPCompareDirectionFields.h"
#include "vtkPDirectionField.h"
#include "vtkPDirectionFieldGlyphs.h"
#include "vtkPDirectionFieldReader.h"
#include "vtkPDirectionFieldSingularities.h"
#include "vtkPDirectionFieldStreamlines.h"
#include "vtkPDirectionFieldWriter.h"
#include "vtkPFieldAlignedRemesh.h"
#include "vtkPGuidanceCurves.h"
#include "vtkPStripePattern.h"

#include "vtkNew.h"

#include <DirectionFields/OptionTable.h>

#include <iomanip>
#include <iostream>
#include <limits>
#include <string>

namespace
{
void PrintValue(double value)
{
  std::cout << value;
}

void PrintValue(const char* value)
{
  std::cout << (value ? '"' + std::string(value) + '"' : "null");
}

/// The properties of one filter.
class Properties
{
public:
  explicit Properties(const char* filter)
  {
    std::cout << (AnyFilter ? ",\n" : "{\n") << "\"" << filter << "\": ";
    AnyFilter = true;
  }
  ~Properties() { std::cout << "}"; }
  Properties(const Properties&) = delete;
  Properties& operator=(const Properties&) = delete;

  template <class Value>
  void Print(const char* name, Value value)
  {
    this->Begin(name);
    PrintValue(value);
    std::cout << "}";
  }

  void Print(const char* name, double value, double least, double most)
  {
    this->Begin(name);
    std::cout << value << ", \"min\": " << least << ", \"max\": " << most << "}";
  }

private:
  void Begin(const char* name)
  {
    std::cout << (this->Any ? ",\n  \"" : "{\n  \"") << name << "\": {\"default\": ";
    this->Any = true;
  }

  bool Any = false;
  static bool AnyFilter;
};
bool Properties::AnyFilter = false;
}

#define VALUE(name) properties.Print(#name, filter->Get##name())
#define RANGE(name)                                                                                \
  properties.Print(                                                                                \
    #name, filter->Get##name(), filter->Get##name##MinValue(), filter->Get##name##MaxValue())

namespace
{
void PrintDirectionField()
{
  Properties properties("DirectionField");
  vtkNew<vtkPDirectionField> filter;
#define PRINT_FLAG(name, ...) VALUE(name);
#define PRINT_RANGE(name, ...) RANGE(name);
  DIRECTIONFIELDS_OPTIONS(PRINT_FLAG, PRINT_RANGE, PRINT_RANGE)
#undef PRINT_FLAG
#undef PRINT_RANGE
  VALUE(KeepStages);
  RANGE(Distribution);
  RANGE(GatherLimit);
  VALUE(CellDirections);
  VALUE(GuidanceVectors);
  VALUE(GuidanceWeights);
  VALUE(GuidanceStrengths);
  RANGE(TensorDirection);
  RANGE(TensorStrength);
  RANGE(TensorScale);
}

void PrintGlyphs()
{
  Properties properties("DirectionFieldGlyphs");
  vtkNew<vtkPDirectionFieldGlyphs> filter;
  RANGE(GatherLimit);
  RANGE(GlyphType);
  RANGE(GlyphMode);
  RANGE(Side);
  RANGE(Spacing);
  RANGE(MaximumNumberOfGlyphs);
  RANGE(Scale);
  RANGE(Offset);
  VALUE(FollowSurface);
}

void PrintStreamlines()
{
  Properties properties("DirectionFieldStreamlines");
  vtkNew<vtkPDirectionFieldStreamlines> filter;
  RANGE(GatherLimit);
  RANGE(SeedType);
  RANGE(SeparatingDistance);
  RANGE(SeparatingDistanceRatio);
  RANGE(MaximumStreamlineLength);
  RANGE(MinimumStreamlineLength);
  RANGE(IntegrationDirection);
  RANGE(MaximumNumberOfLines);
  RANGE(Offset);
  VALUE(StopAtCrossings);
}

void PrintRemesh()
{
  Properties properties("FieldAlignedRemesh");
  vtkNew<vtkPFieldAlignedRemesh> filter;
  RANGE(GatherLimit);
  RANGE(Element);
  VALUE(PureQuads);
  RANGE(SizeMode);
  RANGE(NumberOfFaces);
  RANGE(EdgeLength);
  VALUE(AddIrregularPairs);
  RANGE(BoundarySpacing);
  RANGE(SizeSource);
  RANGE(MaximumError);
  VALUE(KeepThinParts);
  VALUE(KeepFeatures);
  VALUE(KeepSoftFeatures);
  RANGE(FeatureAngle);
  RANGE(Alignment);
  RANGE(AlignmentStrength);
  RANGE(SingularityCost);
  RANGE(SmoothingIterations);
  RANGE(MinimumScaledJacobian);
  RANGE(MaximumAspectRatio);
  RANGE(MaximumWarpage);
  VALUE(KeepStages);
  RANGE(NumberOfThreads);
  VALUE(SizingArray);
  VALUE(RegionArray);
  VALUE(ConservedArray);
  RANGE(Gradation);
}

void PrintStripes()
{
  Properties properties("StripePattern");
  vtkNew<vtkPStripePattern> filter;
  RANGE(GatherLimit);
  RANGE(StripeDirection);
  RANGE(Spacing);
  RANGE(LineOffset);
  VALUE(Bands);
  VALUE(TextureCoordinates);
  VALUE(SpacingArray);
}

void PrintEdit()
{
  Properties properties("EditSingularities");
  vtkNew<vtkPDirectionFieldSingularities> filter;
  RANGE(GatherLimit);
  RANGE(SingularityMode);
  RANGE(Objective);
  VALUE(BalanceAutomatically);
  VALUE(RefineWhereNeeded);
  VALUE(KeepConstraints);
  RANGE(Alignment);
  RANGE(AlignmentStrength);
  VALUE(KeepStages);
  VALUE(GuidanceVectors);
  VALUE(GuidanceWeights);
}

void PrintReader()
{
  Properties properties("ReadDirectionField");
  vtkNew<vtkPDirectionFieldReader> filter;
  RANGE(GatherLimit);
  RANGE(FieldOn);
}

void PrintWriter()
{
  Properties properties("DirectionFieldWriter");
  vtkNew<vtkPDirectionFieldWriter> filter;
  RANGE(GatherLimit);
  RANGE(FieldOn);
  RANGE(FeatureAngle);
  RANGE(MinimumFeatureLength);
}

void PrintMeshWriter()
{
  Properties properties("AbaqusMeshWriter");
  vtkNew<vtkAbaqusMeshWriter> filter;
  VALUE(RegionArray);
  VALUE(DirectionArray);
  VALUE(SecondOrder);
  RANGE(Thickness);
}

void PrintCurves()
{
  Properties properties("GuidanceFromCurves");
  vtkNew<vtkPGuidanceCurves> filter;
  RANGE(GatherLimit);
  RANGE(Degree);
  RANGE(Radius);
  RANGE(Falloff);
  RANGE(MaximumDistance);
}

void PrintComparison()
{
  Properties properties("CompareDirectionFields");
  vtkNew<vtkPCompareDirectionFields> filter;
  RANGE(GatherLimit);
  VALUE(MatchSingularities);
  VALUE(DivergenceAndCurl);
}
}

int main()
{
  std::cout << std::setprecision(std::numeric_limits<double>::max_digits10);
  PrintDirectionField();
  PrintGlyphs();
  PrintStreamlines();
  PrintRemesh();
  PrintStripes();
  PrintEdit();
  PrintReader();
  PrintWriter();
  PrintMeshWriter();
  PrintCurves();
  PrintComparison();
  std::cout << "\n}\n";
  return 0;
}
