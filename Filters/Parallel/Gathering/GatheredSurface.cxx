// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Gathering/GatheredSurface.h"

#include "Gathering/CellMatching.h"
#include "Gathering/GatheredArrays.h"
#include "PieceMatching.h"

#include "vtkCellArray.h"
#include "vtkDataObject.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <utility>

namespace DirectionFields::Parallel
{
namespace
{
/// The numbers that points have over all processes, from each process's own numbers: below the
/// number of its own points from `first` on, the others from `beyond` on.
void CountOn(Gathered<vtkIdType>& numbers, const std::vector<vtkIdType>& first,
  const std::vector<vtkIdType>& beyond)
{
  for (std::size_t p = 0; p + 1 < numbers.First.size() && !numbers.Values.empty(); ++p)
  {
    const vtkIdType own = first[p + 1] - first[p];
    for (vtkIdType k = numbers.First[p]; k < numbers.First[p + 1]; ++k)
    {
      vtkIdType& number = numbers.Values[k];
      number += number < own ? first[p] : beyond[p] - own;
    }
  }
}

/// For each point of the pieces its point of the surface.
void Renumber(const std::vector<vtkIdType>& numbers, std::vector<vtkIdType>& corners)
{
  for (vtkIdType& corner : corners)
  {
    corner = numbers[static_cast<std::size_t>(corner)];
  }
}

vtkSmartPointer<vtkCellArray> MakeCells(const GatheredCells& cells)
{
  vtkNew<vtkIdTypeArray> offsets;
  const vtkIdType count = cells.First.back();
  offsets->SetNumberOfValues(count + 1);
  vtkIdType offset = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    offsets->SetValue(i, offset);
    offset += cells.Sizes.Values.empty() ? 3 : cells.Sizes.Values[i];
  }
  offsets->SetValue(count, offset);
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(static_cast<vtkIdType>(cells.Corners.Values.size()));
  std::copy(cells.Corners.Values.begin(), cells.Corners.Values.end(), corners->GetPointer(0));
  auto array = vtkSmartPointer<vtkCellArray>::New();
  array->SetData(offsets, corners);
  return array;
}

/// For each number of the surface's points the first point of the pieces with it.
std::vector<vtkIdType> FirstOfEach(const JoinedPoints& joined)
{
  std::vector<vtkIdType> first(static_cast<std::size_t>(joined.Count));
  for (std::size_t i = joined.Number.size(); i-- > 0;)
  {
    first[joined.Number[i]] = static_cast<vtkIdType>(i);
  }
  return first;
}

/// Numbers the surface's points as their ids do, as before the surface was cut into pieces: the
/// order of points decides where geometry does not, such as on the sign of vectors along sharp
/// edges.
void OrderByGlobalIds(const std::vector<vtkIdType>& globalIds, JoinedPoints& joined)
{
  const std::vector<vtkIdType> first = FirstOfEach(joined);
  std::vector<vtkIdType> order(first.size());
  std::iota(order.begin(), order.end(), vtkIdType(0));
  std::sort(order.begin(), order.end(),
    [&](vtkIdType a, vtkIdType b)
    { return std::pair(globalIds[first[a]], a) < std::pair(globalIds[first[b]], b); });
  std::vector<vtkIdType> place(first.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    place[order[i]] = static_cast<vtkIdType>(i);
  }
  Renumber(place, joined.Number);
}

/// Appends numbers first ... last - 1, shifted, to a list.
void AppendRange(vtkIdType first, vtkIdType last, vtkIdType shift, std::vector<vtkIdType>& list)
{
  for (vtkIdType i = first; i < last; ++i)
  {
    list.push_back(i + shift);
  }
}

/// Sets the lists of the way back.
void ListParts(const JoinedPoints& joined, const std::vector<vtkIdType>& firstPoint,
  const std::vector<vtkIdType>& copiedPoints, const std::vector<vtkIdType>& firstCopied,
  const GatheredCells& polys, const GatheredCells& strips,
  const std::vector<vtkIdType>& copiedCells, const GatheredCells& ghosts, GatheredSurface& gathered)
{
  gathered.FirstPointOf.assign(1, 0);
  gathered.FirstCellOf.assign(1, 0);
  for (std::size_t p = 0; p + 1 < firstPoint.size(); ++p)
  {
    std::vector<vtkIdType>& points = gathered.PointsOf;
    points.insert(points.end(), joined.Number.begin() + firstPoint[p],
      joined.Number.begin() + firstPoint[p + 1]);
    points.insert(points.end(), copiedPoints.begin() + firstCopied[p],
      copiedPoints.begin() + firstCopied[p + 1]);
    gathered.FirstPointOf.push_back(static_cast<vtkIdType>(points.size()));
    gathered.OwnPointsOf.push_back(firstPoint[p + 1] - firstPoint[p]);

    std::vector<vtkIdType>& cells = gathered.CellsOf;
    AppendRange(polys.First[p], polys.First[p + 1], 0, cells);
    AppendRange(strips.First[p], strips.First[p + 1], polys.First.back(), cells);
    cells.insert(cells.end(), copiedCells.begin() + ghosts.First[p],
      copiedCells.begin() + ghosts.First[p + 1]);
    gathered.FirstCellOf.push_back(static_cast<vtkIdType>(cells.size()));
    gathered.OwnCellsOf.push_back(
      polys.First[p + 1] - polys.First[p] + strips.First[p + 1] - strips.First[p]);
  }
}

/// The points of the surface, of double precision if any piece's are, each where its first piece
/// has it.
vtkSmartPointer<vtkPoints> MakePoints(
  const std::vector<double>& coordinates, const std::vector<vtkIdType>& first, bool areDouble)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(areDouble ? VTK_DOUBLE : VTK_FLOAT);
  points->SetNumberOfPoints(static_cast<vtkIdType>(first.size()));
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), coordinates.data() + 3 * first[i]);
  }
  return points;
}

std::vector<vtkIdType> PerPoint(std::vector<vtkIdType> first)
{
  for (vtkIdType& value : first)
  {
    value /= 3;
  }
  return first;
}

/// A surface on its way from the processes to one of them.
class Travel
{
public:
  Travel(vtkPolyData* polyData, const SurfacePiece& piece, const std::vector<std::string>& arrays,
    const std::vector<std::string>& cellArrays)
    : Piece(piece)
    , Polys(piece.Polys, Announced)
    , Strips(piece.Strips, Announced)
    , Ghosts(piece.Ghosts, Announced)
  {
    const auto add = [this](std::size_t value)
    { return this->Announced.Add(static_cast<vtkIdType>(value)); };
    this->Size = add(piece.Polys.Cells.size() + piece.Strips.Corners.size());
    this->Cells = add(piece.Polys.Cells.size() + piece.Strips.Cells.size());
    this->HasPoints = add(piece.HasPoints);
    this->HasDoublePoints = add(piece.HasDoublePoints);
    this->LacksIds = add(piece.HasPoints && !piece.HasGlobalIds);
    this->PointValues = add(piece.Own.Coordinates.size());
    this->CopiedValues = add(piece.GhostPoints.Coordinates.size());
    this->Ids = add(piece.Own.GlobalIds.size());
    this->CopiedIds = add(piece.GhostPoints.GlobalIds.size());
    this->BorderNumbers = add(piece.BorderEdges.size());
    for (const std::string& name : arrays)
    {
      this->Arrays.push_back(TravellingArray::OfPoints(polyData, piece, name, this->Announced));
    }
    for (const std::string& name : cellArrays)
    {
      for (const PieceCells* const cells : { &piece.Polys, &piece.Strips })
      {
        this->CellArrays.push_back(
          TravellingArray::OfCells(polyData, piece, *cells, name, this->Announced));
      }
    }
  }

  void Gather(Processes& processes, int wanted, GatheredSurface& gathered)
  {
    this->Announced.Exchange(processes);
    const std::vector<vtkIdType> sizes = this->Announced.Of(this->Size);
    const auto largest = std::max_element(sizes.begin(), sizes.end());
    const int to = wanted >= 0 ? wanted : static_cast<int>(largest - sizes.begin());
    gathered.Process = to;
    gathered.Pieces = static_cast<int>(this->Announced.Sum(this->HasPoints));
    gathered.Cells = this->Announced.Sum(this->Cells);
    this->AreDouble = this->Announced.Sum(this->HasDoublePoints) > 0;
    this->UseIds = this->Announced.Sum(this->LacksIds) == 0;
    processes.Together([&] { this->Expect(processes.Own() == to); });

    const auto gather = [&](const auto& own, auto& list)
    { processes.Gather(own, list.Lengths, list.Values, to); };
    gather(this->Piece.Own.Coordinates, this->Coordinates);
    gather(this->Piece.GhostPoints.Coordinates, this->CopiedCoordinates);
    gather(this->Piece.BorderEdges, this->Border);
    if (this->UseIds)
    {
      gather(this->Piece.Own.GlobalIds, this->GlobalIds);
      gather(this->Piece.GhostPoints.GlobalIds, this->CopiedGlobalIds);
    }
    for (TravellingCells* const cells : { &this->Polys, &this->Strips, &this->Ghosts })
    {
      cells->Gather(processes, to);
    }
    for (std::vector<TravellingArray>* const arrays : { &this->Arrays, &this->CellArrays })
    {
      for (TravellingArray& array : *arrays)
      {
        array.Gather(processes, to);
      }
    }
  }

  /// On the process that has everything.
  void Arrive(GatheredSurface& gathered)
  {
    Pieces pieces;
    pieces.FirstPoint = PerPoint(this->Coordinates.First);
    pieces.Coordinates = std::move(this->Coordinates.Values);
    pieces.GlobalIds = std::move(this->GlobalIds.Values);
    const std::vector<vtkIdType> firstCopied = PerPoint(this->CopiedCoordinates.First);
    // Copied points are numbered after all others.
    std::vector<vtkIdType> beyond = firstCopied;
    for (vtkIdType& value : beyond)
    {
      value += pieces.FirstPoint.back();
    }
    GatheredCells& polys = this->Polys.All;
    GatheredCells& strips = this->Strips.All;
    GatheredCells& ghosts = this->Ghosts.All;
    for (Gathered<vtkIdType>* const numbers :
      { &this->Border, &polys.Corners, &strips.Corners, &ghosts.Corners })
    {
      CountOn(*numbers, pieces.FirstPoint, beyond);
    }
    pieces.BorderEdges = std::move(this->Border.Values);
    const double tolerance = ToleranceOf(pieces);
    if (!AreGlobalIdsRight(pieces, tolerance))
    {
      pieces.GlobalIds.clear();
    }
    JoinedPoints joined = JoinPieces(pieces, tolerance);
    if (!pieces.GlobalIds.empty())
    {
      OrderByGlobalIds(pieces.GlobalIds, joined);
    }
    gathered.SharedPoints = joined.Shared;
    for (const auto& [point, place] : joined.Moved)
    {
      std::copy_n(pieces.Coordinates.data() + 3 * place, 3, pieces.Coordinates.data() + 3 * point);
    }
    const std::vector<vtkIdType> first = FirstOfEach(joined);
    std::vector<vtkIdType> copiedPoints = FindPoints(
      pieces, { this->CopiedCoordinates.Values, this->CopiedGlobalIds.Values }, tolerance);
    for (vtkIdType& point : copiedPoints)
    {
      point = point < 0 ? point : joined.Number[point];
    }
    Renumber(joined.Number, polys.Corners.Values);
    Renumber(joined.Number, strips.Corners.Values);
    std::vector<vtkIdType> numbers = joined.Number;
    numbers.insert(numbers.end(), copiedPoints.begin(), copiedPoints.end());
    Renumber(numbers, ghosts.Corners.Values);
    const std::vector<vtkIdType> copiedCells = FindCells(polys, ghosts);
    gathered.LostCopies = std::count(copiedCells.begin(), copiedCells.end(), -1);
    ListParts(joined, pieces.FirstPoint, copiedPoints, firstCopied, polys, strips, copiedCells,
      ghosts, gathered);
    gathered.Surface = vtkSmartPointer<vtkPolyData>::New();
    gathered.Surface->SetPoints(MakePoints(pieces.Coordinates, first, this->AreDouble));
    gathered.Surface->SetPolys(MakeCells(polys));
    gathered.Surface->SetStrips(MakeCells(strips));
    for (const TravellingArray& array : this->Arrays)
    {
      array.AddTo(gathered.Surface, first);
    }
    for (std::size_t k = 0; k < this->CellArrays.size(); k += 2)
    {
      AddCells(this->CellArrays[k], this->CellArrays[k + 1], gathered.Surface);
    }
  }

private:
  /// Makes room.
  void Expect(bool isThere)
  {
    const Announcements& announced = this->Announced;
    Parallel::Expect(announced, this->PointValues, isThere, this->Coordinates);
    Parallel::Expect(announced, this->CopiedValues, isThere, this->CopiedCoordinates);
    Parallel::Expect(announced, this->BorderNumbers, isThere, this->Border);
    if (this->UseIds)
    {
      Parallel::Expect(announced, this->Ids, isThere, this->GlobalIds);
      Parallel::Expect(announced, this->CopiedIds, isThere, this->CopiedGlobalIds);
    }
    for (TravellingCells* const cells : { &this->Polys, &this->Strips, &this->Ghosts })
    {
      cells->Expect(announced, isThere);
    }
    for (TravellingArray& array : this->Arrays)
    {
      array.Expect(announced, isThere);
    }
    for (TravellingArray& array : this->CellArrays)
    {
      array.Expect(announced, isThere);
    }
  }

  double ToleranceOf(const Pieces& pieces) const
  {
    double largest = 0.0;
    for (const std::vector<double>* const values :
      { &pieces.Coordinates, &this->CopiedCoordinates.Values })
    {
      for (const double value : *values)
      {
        largest = std::max(largest, std::abs(value));
      }
    }
    return MatchingTolerance * largest;
  }

  const SurfacePiece& Piece;
  Announcements Announced;
  TravellingCells Polys;
  TravellingCells Strips;
  TravellingCells Ghosts;
  std::vector<TravellingArray> Arrays;
  /// For each cell array its values on polygons, then those on strips.
  std::vector<TravellingArray> CellArrays;
  Gathered<double> Coordinates;
  Gathered<double> CopiedCoordinates;
  Gathered<vtkIdType> GlobalIds;
  Gathered<vtkIdType> CopiedGlobalIds;
  Gathered<vtkIdType> Border;
  std::size_t Size;
  std::size_t Cells;
  std::size_t HasPoints;
  std::size_t HasDoublePoints;
  std::size_t LacksIds;
  std::size_t PointValues;
  std::size_t CopiedValues;
  std::size_t Ids;
  std::size_t CopiedIds;
  std::size_t BorderNumbers;
  bool AreDouble = false;
  bool UseIds = false;
};
}

GatheredSurface GatherSurface(Processes& processes, vtkPolyData* polyData,
  const std::vector<std::string>& arrays, const std::vector<std::string>& cells, int to)
{
  GatheredSurface gathered;
  std::unique_ptr<Travel> travel;
  processes.Together(
    [&]
    {
      gathered.Piece = ReadPiece(polyData);
      travel = std::make_unique<Travel>(polyData, gathered.Piece, arrays, cells);
    });
  travel->Gather(processes, to, gathered);
  processes.Together(
    [&]
    {
      if (processes.Own() == gathered.Process)
      {
        travel->Arrive(gathered);
        // The phase of a field follows the time step before.
        vtkInformation* const information = polyData->GetInformation();
        if (information->Has(vtkDataObject::DATA_TIME_STEP()))
        {
          gathered.Surface->GetInformation()->Set(
            vtkDataObject::DATA_TIME_STEP(), information->Get(vtkDataObject::DATA_TIME_STEP()));
        }
      }
    });
  return gathered;
}
}
