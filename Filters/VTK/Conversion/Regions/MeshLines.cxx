// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Conversion/Regions/MeshLines.h"

#include "Conversion/Input/FieldArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkLongLongArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSignedCharArray.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <limits>
#include <utility>

namespace DirectionFields
{
namespace
{
constexpr const char* NamesOfChains = "ChainNames";
constexpr const char* OffsetsOfChains = "ChainOffsets";
constexpr const char* PointsOfChains = "ChainPoints";
constexpr const char* NameOfRegions = "RegionArray";

vtkNew<vtkStringArray> MakeTexts(const char* name, const std::vector<std::string>& texts)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& text : texts)
  {
    array->InsertNextValue(text);
  }
  return array;
}

std::vector<std::string> NamesOf(const std::vector<MeshChain>& chains)
{
  std::vector<std::string> names;
  for (const MeshChain& chain : chains)
  {
    names.push_back(chain.Name);
  }
  return names;
}

/// The regions' values, if they are all integers.
bool AreIntegers(const std::vector<std::string>& names, std::vector<long long>& values)
{
  return std::all_of(names.begin(), names.end(),
    [&values](const std::string& name)
    {
      const char* const end = name.data() + name.size();
      const auto [last, error] = std::from_chars(name.data(), end, values.emplace_back());
      return error == std::errc() && last == end;
    });
}

/// The lower or the higher region beside each chain, as numbers or texts.
void AddRegionsBeside(const char* name, std::size_t side, const std::vector<MeshChain>& chains,
  const std::vector<std::string>& names, vtkCellData* data)
{
  std::vector<long long> values;
  if (AreIntegers(names, values))
  {
    const auto regionOf = [&](std::size_t i)
    {
      const Index region = chains[i].Regions[side];
      return region == None ? -1 : values[static_cast<std::size_t>(region)];
    };
    using Ints = std::numeric_limits<int>;
    if (std::all_of(values.begin(), values.end(),
          [](long long value) { return value >= Ints::min() && value <= Ints::max(); }))
    {
      data->AddArray(MakeValues<vtkIntArray>(name, chains.size(), regionOf));
    }
    else
    {
      data->AddArray(MakeValues<vtkLongLongArray>(name, chains.size(), regionOf));
    }
    return;
  }
  std::vector<std::string> texts;
  for (const MeshChain& chain : chains)
  {
    const Index region = chain.Regions[side];
    const std::string text = region == None ? "" : names[static_cast<std::size_t>(region)];
    texts.push_back(
      text.size() > 1 && text.front() == '"' ? text.substr(1, text.size() - 2) : text);
  }
  data->AddArray(MakeTexts(name, texts));
}

bool IsInteger(vtkDataArray* array)
{
  return array && array->GetNumberOfComponents() == 1 && array->GetDataType() != VTK_FLOAT &&
    array->GetDataType() != VTK_DOUBLE;
}

/// Edges as pairs of points in order.
std::vector<std::array<Index, 2>> EdgesOf(const ShellMesh& mesh)
{
  std::vector<std::array<Index, 2>> edges;
  for (const std::array<Index, 4>& face : mesh.Faces)
  {
    const std::size_t size = face[3] == None ? 3 : 4;
    for (std::size_t c = 0; c < size; ++c)
    {
      const auto ends = std::minmax(face[c], face[(c + 1) % size]);
      edges.push_back({ ends.first, ends.second });
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}
}

namespace
{
/// The cell that each chain is along.
std::vector<GivenCell> SourcesOf(const std::vector<MeshChain>& chains, const KeptLines& kept)
{
  std::vector<GivenCell> sources;
  for (const MeshChain& chain : chains)
  {
    const std::vector<GivenCell>& given =
      chain.Kind == ChainKind::Point ? kept.OfPoints : kept.OfCurves;
    sources.push_back(chain.Source == None ? GivenCell{ nullptr, 0 }
                                           : given[static_cast<std::size_t>(chain.Source)]);
  }
  return sources;
}
}

void AddGivenPoints(const std::vector<MeshChain>& chains, vtkPolyData* output)
{
  std::vector<int> given(static_cast<std::size_t>(output->GetNumberOfPoints()), -1);
  for (const MeshChain& chain : chains)
  {
    if (chain.Kind == ChainKind::Point)
    {
      given[static_cast<std::size_t>(chain.Points[0])] = static_cast<int>(chain.Source);
    }
  }
  output->GetPointData()->AddArray(MakeScalars<vtkIntArray>("GivenPoint", given));
}

void AddChains(const std::vector<MeshChain>& given, vtkPoints* points,
  const std::vector<std::string>& names, const KeptLines& kept, vtkPolyData* output)
{
  // The vertices come first in polydata.
  std::vector<MeshChain> chains = given;
  const auto lines = static_cast<std::size_t>(std::count_if(given.begin(), given.end(),
    [](const MeshChain& chain) { return chain.Kind != ChainKind::Point; }));
  const auto numberOf = [&](std::size_t i)
  { return static_cast<int>((i + lines) % std::max<std::size_t>(given.size(), 1)); };
  std::rotate(chains.begin(), chains.begin() + static_cast<std::ptrdiff_t>(lines), chains.end());
  std::vector<Index> used;
  for (const MeshChain& chain : chains)
  {
    used.insert(used.end(), chain.Points.begin(), chain.Points.end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  vtkNew<vtkPoints> own;
  own->SetDataType(points->GetDataType());
  RequireMemoryToGrow((sizeof(double[3]) + 2 * sizeof(vtkIdType)) * used.size());
  for (const Index p : used)
  {
    own->InsertNextPoint(points->GetPoint(p));
  }
  vtkNew<vtkCellArray> lineCells;
  vtkNew<vtkCellArray> vertexCells;
  std::vector<int> kinds;
  for (const MeshChain& chain : chains)
  {
    vtkCellArray* const cells = chain.Kind == ChainKind::Point ? vertexCells : lineCells;
    cells->InsertNextCell(static_cast<int>(chain.Points.size()));
    for (const Index p : chain.Points)
    {
      cells->InsertCellPoint(std::lower_bound(used.begin(), used.end(), p) - used.begin());
    }
    kinds.push_back(static_cast<int>(chain.Kind));
  }
  output->SetPoints(own);
  output->SetLines(lineCells);
  if (vertexCells->GetNumberOfCells() > 0)
  {
    output->SetVerts(vertexCells);
  }
  output->GetPointData()->AddArray(MakeScalars<vtkIntArray>("MeshPoint", used));
  vtkCellData* const data = output->GetCellData();
  data->AddArray(MakeValues<vtkIntArray>("ChainId", chains.size(), numberOf));
  data->AddArray(MakeScalars<vtkSignedCharArray>("ChainKind", kinds));
  data->AddArray(MakeTexts("ChainName", NamesOf(chains)));
  if (!names.empty())
  {
    AddRegionsBeside("FirstRegion", 0, chains, names, data);
    AddRegionsBeside("SecondRegion", 1, chains, names, data);
  }
  if (!kept.Curves.empty() || !kept.Points.empty())
  {
    const auto sourceOf = [&](bool isPoint)
    {
      return [&chains, isPoint](std::size_t i)
      {
        const bool isOwn = (chains[i].Kind == ChainKind::Point) == isPoint;
        return isOwn && chains[i].Source != None ? static_cast<int>(chains[i].Source) : -1;
      };
    };
    data->AddArray(MakeValues<vtkIntArray>("CurveId", chains.size(), sourceOf(false)));
    data->AddArray(MakeValues<vtkIntArray>("GivenPoint", chains.size(), sourceOf(true)));
    CarryCellArrays(SourcesOf(chains, kept), data);
  }
}

void KeepChains(const std::vector<MeshChain>& chains, vtkFieldData* data)
{
  for (const char* const name : { NamesOfChains, OffsetsOfChains, PointsOfChains })
  {
    data->RemoveArray(name);
  }
  if (chains.empty())
  {
    return;
  }
  std::vector<Index> offsets = { 0 };
  std::vector<Index> points;
  for (const MeshChain& chain : chains)
  {
    points.insert(points.end(), chain.Points.begin(), chain.Points.end());
    offsets.push_back(static_cast<Index>(points.size()));
  }
  data->AddArray(MakeTexts(NamesOfChains, NamesOf(chains)));
  data->AddArray(MakeScalars<vtkIntArray>(OffsetsOfChains, offsets));
  data->AddArray(MakeScalars<vtkIntArray>(PointsOfChains, points));
}

void KeepRegionArray(const std::string& name, vtkFieldData* data)
{
  data->RemoveArray(NameOfRegions);
  if (!name.empty())
  {
    data->AddArray(MakeTexts(NameOfRegions, { name }));
  }
}

std::string KeptRegionArray(vtkFieldData* data)
{
  auto* const kept = vtkStringArray::SafeDownCast(data->GetAbstractArray(NameOfRegions));
  return kept && kept->GetNumberOfValues() == 1 ? kept->GetValue(0) : std::string();
}

std::vector<NamedSet> KeptChains(vtkFieldData* data, const ShellMesh& mesh, bool& isOther)
{
  auto* const names = vtkStringArray::SafeDownCast(data->GetAbstractArray(NamesOfChains));
  vtkDataArray* const offsets = data->GetArray(OffsetsOfChains);
  vtkDataArray* const points = data->GetArray(PointsOfChains);
  isOther = false;
  if (!names || !IsInteger(offsets) || !IsInteger(points))
  {
    return {};
  }
  isOther = true;
  if (offsets->GetNumberOfTuples() != names->GetNumberOfValues() + 1)
  {
    return {};
  }
  const std::vector<std::array<Index, 2>> edges = EdgesOf(mesh);
  std::vector<NamedSet> sets;
  for (vtkIdType chain = 0; chain < names->GetNumberOfValues(); ++chain)
  {
    const auto first = static_cast<vtkIdType>(offsets->GetComponent(chain, 0));
    const auto end = static_cast<vtkIdType>(offsets->GetComponent(chain + 1, 0));
    if (first < 0 || end < first + 1 || end > points->GetNumberOfTuples())
    {
      return {};
    }
    NamedSet set{ names->GetValue(chain), {} };
    for (vtkIdType i = first; i < end; ++i)
    {
      const auto point = static_cast<Index>(points->GetComponent(i, 0));
      if (point < 0 || point >= static_cast<Index>(mesh.Points.size()))
      {
        return {};
      }
      if (!set.Members.empty())
      {
        const auto ends = std::minmax(set.Members.back(), point);
        const std::array<Index, 2> edge = { ends.first, ends.second };
        if (!std::binary_search(edges.begin(), edges.end(), edge))
        {
          return {};
        }
      }
      set.Members.push_back(point);
    }
    sets.push_back(std::move(set));
  }
  isOther = false;
  return sets;
}
}
