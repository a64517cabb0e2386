// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ExchangedValues.h"

#include "ArrayKinds.h"
#include "Mesh/Messages.h"
#include "Mesh/OwnCommunicator.h"
#include "PieceMatching.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessStream.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

namespace DirectionFields::Parallel
{
namespace
{
/// Gives an output the new arrays that other processes have: a process without points or cells
/// lacks some, such as the kinds of constraints, and all are to have the same arrays.
void AddOthersArrays(Processes& processes, const Messages& messages, vtkIdType tuples,
  vtkDataSetAttributes* input, vtkDataSetAttributes* output)
{
  std::vector<unsigned char> own;
  processes.Together(
    [&]
    {
      vtkMultiProcessStream stream;
      WriteKinds(output, input, stream);
      stream.GetRawData(own);
    });
  const Messages::Collected<unsigned char> all = messages.AllGather(own);
  processes.Together(
    [&]
    {
      for (std::size_t p = 0; p + 1 < all.First.size(); ++p)
      {
        vtkMultiProcessStream stream;
        stream.SetRawData(all.Values.data() + all.First[p],
          static_cast<unsigned int>(all.First[p + 1] - all.First[p]));
        AddZeros(ReadKinds(stream), tuples, output);
      }
    });
}

/// The arrays of numbers that an output has beyond those of its input, all of whose components make
/// a tuple. They are in the order of their names, for arrays that an input had already stay where
/// they were. Arrays without a name are the input's: the field's own have one.
class NewArrays
{
public:
  NewArrays(vtkDataSetAttributes* input, vtkDataSetAttributes* output)
  {
    for (int k = 0; k < output->GetNumberOfArrays(); ++k)
    {
      vtkDataArray* const array = output->GetArray(k);
      if (array && array->GetName() && array != input->GetArray(array->GetName()))
      {
        this->Arrays.push_back(array);
      }
    }
    std::sort(this->Arrays.begin(), this->Arrays.end(),
      [](vtkDataArray* a, vtkDataArray* b)
      { return std::string(a->GetName()) < std::string(b->GetName()); });
  }

  void Append(vtkIdType item, std::vector<double>& values) const
  {
    this->ForEachComponent(
      [&](vtkDataArray* array, int c) { values.push_back(array->GetComponent(item, c)); });
  }

  /// @return the place behind the values
  const double* Set(vtkIdType item, const double* values) const
  {
    this->ForEachComponent(
      [&](vtkDataArray* array, int c) { array->SetComponent(item, c, *values++); });
    return values;
  }

  std::size_t Width() const
  {
    std::size_t width = 0;
    this->ForEachComponent([&](vtkDataArray*, int) { ++width; });
    return width;
  }

private:
  template <typename Body>
  void ForEachComponent(const Body& body) const
  {
    for (vtkDataArray* const array : this->Arrays)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        body(array, c);
      }
    }
  }

  std::vector<vtkDataArray*> Arrays;
};

using Lists = std::vector<std::vector<double>>;

/// Gives points of several pieces the bits of their owner.
void TakeOwners(Processes& processes, const Messages& messages, const PointExchange& exchange,
  const NewArrays& arrays)
{
  Lists sent;
  processes.Together(
    [&]
    {
      sent.resize(static_cast<std::size_t>(messages.Count()));
      for (std::size_t p = 0; p < sent.size(); ++p)
      {
        for (const vtkIdType point : exchange.Sent[p])
        {
          arrays.Append(point, sent[p]);
        }
      }
    });
  const Lists received = messages.Exchange(sent);
  for (std::size_t p = 0; p < received.size(); ++p)
  {
    const double* values = received[p].data();
    for (const vtkIdType point : exchange.Received[p])
    {
      values = arrays.Set(point, values);
    }
  }
}

/// Answers to questions that all processes have asked: the number of a question on its process, the
/// number of the item that was found, and its values. Of several answers the first process's
/// counts.
class Answers
{
public:
  Answers(const Messages& messages, const NewArrays& arrays)
    : Exchange(messages)
    , Arrays(arrays)
    , Sent(static_cast<std::size_t>(messages.Count()))
  {
  }

  void Give(int process, vtkIdType question, vtkIdType number, vtkIdType item)
  {
    std::vector<double>& values = this->Sent[static_cast<std::size_t>(process)];
    values.push_back(static_cast<double>(question));
    values.push_back(static_cast<double>(number));
    this->Arrays.Append(item, values);
  }

  /// @param items the item that each question is for
  /// @return the number of the item that was found for each; -1 for none
  std::vector<vtkIdType> Take(const std::vector<vtkIdType>& items) const
  {
    const Lists received = this->Exchange.Exchange(this->Sent);
    std::vector<vtkIdType> numbers;
    this->Exchange.Together([&] { numbers.assign(items.size(), -1); });
    const std::size_t width = this->Arrays.Width() + 2;
    for (const std::vector<double>& answers : received)
    {
      for (std::size_t k = 0; k < answers.size(); k += width)
      {
        const auto question = static_cast<std::size_t>(answers[k]);
        if (numbers[question] < 0)
        {
          numbers[question] = static_cast<vtkIdType>(answers[k + 1]);
          this->Arrays.Set(items[question], answers.data() + k + 2);
        }
      }
    }
    return numbers;
  }

private:
  const Messages& Exchange;
  const NewArrays& Arrays;
  Lists Sent;
};

/// Gives the points that only copied cells have the values of other pieces' points.
/// @return their numbers; -1 where there is none
std::vector<vtkIdType> CopyPoints(Processes& processes, const Messages& messages,
  const PointExchange& exchange, const SurfacePiece& piece, const NewArrays& arrays)
{
  const auto places = messages.AllGather(piece.GhostPoints.Coordinates);
  WantedPoints wanted;
  if (exchange.UseIds)
  {
    wanted.GlobalIds = messages.AllGather(piece.GhostPoints.GlobalIds).Values;
  }
  Answers answers(messages, arrays);
  processes.Together(
    [&]
    {
      wanted.Coordinates = places.Values;
      Pieces own;
      own.FirstPoint = { 0, static_cast<vtkIdType>(piece.Own.Points.size()) };
      own.Coordinates = piece.Own.Coordinates;
      own.GlobalIds = exchange.UseIds ? piece.Own.GlobalIds : std::vector<vtkIdType>();
      const std::vector<vtkIdType> found = FindPoints(own, wanted, exchange.Tolerance);
      for (int p = 0; p < messages.Count(); ++p)
      {
        const int first = places.First[p] / 3;
        for (int k = first; k < places.First[p + 1] / 3; ++k)
        {
          if (found[k] >= 0)
          {
            answers.Give(p, k - first, exchange.Numbers[found[k]], piece.Own.Points[found[k]]);
          }
        }
      }
    });
  return answers.Take(piece.GhostPoints.Points);
}

/// Calls body(cell, sorted numbers of its corners) for polygons.
template <typename Body>
void ForEachCell(const PieceCells& cells, const std::vector<vtkIdType>& numbers, const Body& body)
{
  std::vector<vtkIdType> corners;
  std::size_t at = 0;
  for (std::size_t i = 0; i < cells.Cells.size(); ++i)
  {
    corners.clear();
    for (vtkIdType k = 0; k < cells.Size(i); ++k)
    {
      corners.push_back(numbers[cells.Corners[at++]]);
    }
    std::sort(corners.begin(), corners.end());
    body(cells.Cells[i], corners);
  }
}

/// Gives copied polygons the values of the polygons with the same corners.
/// @param numbers of own points, then of points that only copied cells have
/// @return how many of this piece's are copies of nothing
vtkIdType CopyCells(Processes& processes, const Messages& messages, const SurfacePiece& piece,
  const std::vector<vtkIdType>& numbers, const NewArrays& arrays)
{
  std::vector<vtkIdType> asked;
  std::vector<vtkIdType> cells;
  processes.Together(
    [&]
    {
      ForEachCell(piece.Ghosts, numbers,
        [&](vtkIdType cell, const std::vector<vtkIdType>& corners)
        {
          cells.push_back(cell);
          asked.push_back(static_cast<vtkIdType>(corners.size()));
          asked.insert(asked.end(), corners.begin(), corners.end());
        });
    });
  const auto all = messages.AllGather(asked);
  Answers answers(messages, arrays);
  processes.Together(
    [&]
    {
      std::map<std::vector<vtkIdType>, std::vector<std::pair<int, vtkIdType>>> wanted;
      for (int p = 0; p < messages.Count(); ++p)
      {
        vtkIdType question = 0;
        for (int k = all.First[p]; k < all.First[p + 1]; ++question)
        {
          const auto begin = all.Values.begin() + k + 1;
          const auto size = static_cast<int>(all.Values[k]);
          wanted[std::vector<vtkIdType>(begin, begin + size)].emplace_back(p, question);
          k += size + 1;
        }
      }
      ForEachCell(piece.Polys, numbers,
        [&](vtkIdType cell, const std::vector<vtkIdType>& corners)
        {
          const auto there = wanted.find(corners);
          if (there != wanted.end())
          {
            for (const auto& [process, question] : there->second)
            {
              answers.Give(process, question, 0, cell);
            }
          }
        });
    });
  const std::vector<vtkIdType> found = answers.Take(cells);
  return std::count(found.begin(), found.end(), -1);
}

vtkIdType ExchangeAll(Processes& processes, const Messages& messages, const PointExchange& exchange,
  const SurfacePiece& piece, vtkPolyData* input, vtkPolyData* output)
{
  AddOthersArrays(processes, messages, output->GetNumberOfPoints(), input->GetPointData(),
    output->GetPointData());
  AddOthersArrays(
    processes, messages, output->GetNumberOfCells(), input->GetCellData(), output->GetCellData());
  const NewArrays points(input->GetPointData(), output->GetPointData());
  const NewArrays cells(input->GetCellData(), output->GetCellData());
  TakeOwners(processes, messages, exchange, points);
  if (!messages.Any(!piece.Ghosts.Cells.empty() || !piece.GhostPoints.Points.empty()))
  {
    return 0;
  }
  const std::vector<vtkIdType> copied = CopyPoints(processes, messages, exchange, piece, points);
  std::vector<vtkIdType> numbers;
  processes.Together(
    [&]
    {
      numbers = exchange.Numbers;
      numbers.insert(numbers.end(), copied.begin(), copied.end());
    });
  const vtkIdType lost = CopyCells(processes, messages, piece, numbers, cells);
  return static_cast<vtkIdType>(messages.Sum(static_cast<double>(lost)));
}
}

vtkIdType ExchangeValues(Processes& processes, const PointExchange& exchange,
  const SurfacePiece& piece, vtkPolyData* input, vtkPolyData* output)
{
  const OwnCommunicator communicator(processes.GetController());
  const Messages messages(communicator.Handle);
  vtkIdType lost = 0;
  ShareErrors(
    processes, [&] { lost = ExchangeAll(processes, messages, exchange, piece, input, output); });
  return lost;
}
}
