// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints default and range of each property of vtkDirectionFieldGlyphs as JSON, for the comparison
// with the server manager's. Switches have no range.

#include "vtkDirectionFieldGlyphs.h"

#include "vtkNew.h"

#include <iomanip>
#include <iostream>
#include <limits>

#define PRINT(name)                                                                                \
  std::cout << "  \"" #name "\": {\"default\": " << filter->Get##name()                            \
            << ", \"min\": " << filter->Get##name##MinValue()                                      \
            << ", \"max\": " << filter->Get##name##MaxValue() << "},\n"

int main()
{
  vtkNew<vtkDirectionFieldGlyphs> filter;
  std::cout << std::setprecision(std::numeric_limits<double>::max_digits10) << "{\n";
  PRINT(GlyphType);
  PRINT(GlyphMode);
  PRINT(Side);
  PRINT(Spacing);
  PRINT(MaximumNumberOfGlyphs);
  PRINT(Scale);
  PRINT(Offset);
  std::cout << "  \"FollowSurface\": {\"default\": " << filter->GetFollowSurface() << "}\n}\n";
  return 0;
}
