// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSurfaceStrokes.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

vtkStandardNewMacro(vtkSurfaceStrokes);

namespace
{
/// The dashes and gaps of a soft stroke, over the diagonal of the box around all strokes.
constexpr double DASH = 0.03;
/// No stroke has more of them.
constexpr double MOST_DASHES = 400.0;
constexpr unsigned char ORANGE[] = { 217, 115, 13 };
constexpr unsigned char WHITE[] = { 255, 255, 255 };

using Point = std::array<double, 3>;

Point Between(const Point& a, const Point& b, double share)
{
  return { a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]),
    a[2] + share * (b[2] - a[2]) };
}

double Distance(const Point& a, const Point& b)
{
  return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

/// Appends a line, point by point.
class Line
{
public:
  Line(vtkPolyData* output, vtkUnsignedCharArray* colors)
    : Output(output)
    , Colors(colors)
  {
  }

  /// In one color.
  void AddSolid(const std::vector<Point>& points)
  {
    for (const Point& point : points)
    {
      this->Add(point, ORANGE);
    }
    this->Finish();
  }

  /// In dashes of about a length, the first and the last one whole.
  void AddDashed(const std::vector<Point>& points, double dash)
  {
    double total = 0.0;
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
    {
      total += Distance(points[k], points[k + 1]);
    }
    const double wanted = dash > 0.0 ? std::min(MOST_DASHES, total / dash) : 0.0;
    const int dashes = 2 * std::max(1, static_cast<int>(std::lround(0.5 * (wanted - 1.0)))) + 1;
    int number = 0;
    double begin = 0.0;
    this->Add(points[0], ORANGE);
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
    {
      const double length = Distance(points[k], points[k + 1]);
      while (number + 1 < dashes && begin + length > total * (number + 1) / dashes)
      {
        const double at = (total * (number + 1) / dashes - begin) / length;
        const Point end = Between(points[k], points[k + 1], std::clamp(at, 0.0, 1.0));
        this->Add(end, ColorOf(number));
        // The next one begins in its own color, at the same place.
        this->Add(end, ColorOf(++number));
      }
      begin += length;
      this->Add(points[k + 1], ColorOf(number));
    }
    this->Finish();
  }

private:
  static const unsigned char* ColorOf(int dash) { return dash % 2 == 0 ? ORANGE : WHITE; }
  void Add(const Point& point, const unsigned char* color)
  {
    this->Ids.push_back(this->Output->GetPoints()->InsertNextPoint(point.data()));
    this->Colors->InsertNextTypedTuple(color);
  }
  void Finish()
  {
    this->Output->GetLines()->InsertNextCell(
      static_cast<vtkIdType>(this->Ids.size()), this->Ids.data());
  }

  vtkPolyData* Output;
  vtkUnsignedCharArray* Colors;
  std::vector<vtkIdType> Ids;
};
}

//------------------------------------------------------------------------------
vtkSurfaceStrokes::vtkSurfaceStrokes()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkSurfaceStrokes::~vtkSurfaceStrokes() = default;

//------------------------------------------------------------------------------
void vtkSurfaceStrokes::AddPoint(double stroke, double x, double y, double z)
{
  this->Points.push_back({ stroke, x, y, z });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceStrokes::RemoveAllPoints()
{
  if (!this->Points.empty())
  {
    this->Points.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceStrokes::AddStrength(double stroke, double strength)
{
  this->Strengths.push_back({ stroke, std::clamp(strength, 0.0, 1.0) });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceStrokes::RemoveAllStrengths()
{
  if (!this->Strengths.empty())
  {
    this->Strengths.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkSurfaceStrokes::StrengthOf(double stroke) const
{
  const auto found = std::find_if(this->Strengths.rbegin(), this->Strengths.rend(),
    [stroke](const std::array<double, 2>& row) { return row[0] == stroke; });
  return found != this->Strengths.rend() ? (*found)[1] : 1.0;
}

//------------------------------------------------------------------------------
double vtkSurfaceStrokes::Dash() const
{
  vtkBoundingBox box;
  for (const std::array<double, 4>& point : this->Points)
  {
    box.AddPoint(point[1], point[2], point[3]);
  }
  return box.IsValid() ? DASH * box.GetDiagonalLength() : 0.0;
}

//------------------------------------------------------------------------------
int vtkSurfaceStrokes::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkPolyData* const output = vtkPolyData::GetData(outputVector, 0);
  vtkInformation* const information = outputVector->GetInformationObject(0);
  if (information->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIdTypeArray> strokes;
  strokes->SetName("Stroke");
  vtkNew<vtkDoubleArray> strengths;
  strengths->SetName("Strength");
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Color");
  colors->SetNumberOfComponents(3);
  output->SetPoints(points);
  output->SetLines(lines);
  const double dash = this->Dash();
  const std::size_t size = this->Points.size();
  for (std::size_t begin = 0, end = 0; begin < size; begin = end)
  {
    std::vector<Point> line;
    for (; end < size && this->Points[end][0] == this->Points[begin][0]; ++end)
    {
      line.push_back({ this->Points[end][1], this->Points[end][2], this->Points[end][3] });
    }
    if (line.size() < 2)
    {
      continue;
    }
    const double strength = this->StrengthOf(this->Points[begin][0]);
    if (strength < 1.0)
    {
      Line(output, colors).AddDashed(line, dash);
    }
    else
    {
      Line(output, colors).AddSolid(line);
    }
    strokes->InsertNextValue(static_cast<vtkIdType>(this->Points[begin][0]));
    strengths->InsertNextValue(strength);
  }
  output->GetCellData()->AddArray(strokes);
  output->GetCellData()->AddArray(strengths);
  output->GetPointData()->AddArray(colors);
  return 1;
}

//------------------------------------------------------------------------------
void vtkSurfaceStrokes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Points: " << this->Points.size() << "\n";
  os << indent << "Strengths: " << this->Strengths.size() << "\n";
}
