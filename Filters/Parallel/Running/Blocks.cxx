// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Running/Blocks.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace DirectionFields::Parallel
{
namespace
{
using Objects = std::vector<vtkSmartPointer<vtkDataObject>>;

enum Kind
{
  NOTHING,
  SURFACE,
  PARTITIONS,
  BLOCKS,
  COLLECTION
};

Kind KindOf(vtkDataObject* object)
{
  if (vtkPolyData::SafeDownCast(object))
  {
    return SURFACE;
  }
  if (vtkPartitionedDataSet::SafeDownCast(object))
  {
    return PARTITIONS;
  }
  if (vtkMultiBlockDataSet::SafeDownCast(object))
  {
    return BLOCKS;
  }
  return vtkPartitionedDataSetCollection::SafeDownCast(object) ? COLLECTION : NOTHING;
}

unsigned int ChildrenOf(vtkDataObject* object)
{
  if (auto* const partitions = vtkPartitionedDataSet::SafeDownCast(object))
  {
    return partitions->GetNumberOfPartitions();
  }
  if (auto* const blocks = vtkMultiBlockDataSet::SafeDownCast(object))
  {
    return blocks->GetNumberOfBlocks();
  }
  auto* const collection = vtkPartitionedDataSetCollection::SafeDownCast(object);
  return collection ? collection->GetNumberOfPartitionedDataSets() : 0;
}

vtkDataObject* ChildOf(vtkDataObject* object, unsigned int k)
{
  if (k >= ChildrenOf(object))
  {
    return nullptr;
  }
  if (auto* const partitions = vtkPartitionedDataSet::SafeDownCast(object))
  {
    return partitions->GetPartitionAsDataObject(k);
  }
  if (auto* const blocks = vtkMultiBlockDataSet::SafeDownCast(object))
  {
    return blocks->GetBlock(k);
  }
  return vtkPartitionedDataSetCollection::SafeDownCast(object)->GetPartitionedDataSet(k);
}

/// Puts a child where its input is, with the same name.
void SetChild(vtkDataObject* input, unsigned int k, vtkDataObject* child, vtkDataObject* parent)
{
  if (auto* const partitions = vtkPartitionedDataSet::SafeDownCast(parent))
  {
    partitions->SetPartition(k, child);
    auto* const given = vtkPartitionedDataSet::SafeDownCast(input);
    if (given->HasMetaData(k))
    {
      partitions->GetMetaData(k)->Copy(given->GetMetaData(k));
    }
  }
  else if (auto* const blocks = vtkMultiBlockDataSet::SafeDownCast(parent))
  {
    blocks->SetBlock(k, child);
    auto* const given = vtkMultiBlockDataSet::SafeDownCast(input);
    if (given->HasMetaData(k))
    {
      blocks->GetMetaData(k)->Copy(given->GetMetaData(k));
    }
  }
  else if (auto* const collection = vtkPartitionedDataSetCollection::SafeDownCast(parent))
  {
    collection->SetPartitionedDataSet(k, vtkPartitionedDataSet::SafeDownCast(child));
    auto* const given = vtkPartitionedDataSetCollection::SafeDownCast(input);
    if (given->HasMetaData(k))
    {
      collection->GetMetaData(k)->Copy(given->GetMetaData(k));
    }
  }
}

/// The outputs of a part of the tree; null ones where this process does not have the part.
Objects Visit(
  Processes& processes, vtkDataObject* given, std::size_t outputs, const SurfaceWork& work)
{
  Objects results(outputs);
  const int kind = static_cast<int>(processes.Largest(KindOf(given)));
  vtkDataObject* const input = KindOf(given) == kind ? given : nullptr;
  if (kind == SURFACE)
  {
    vtkNew<vtkPolyData> empty;
    std::vector<vtkPolyData*> surfaces;
    for (vtkSmartPointer<vtkDataObject>& result : results)
    {
      vtkNew<vtkPolyData> surface;
      result = surface;
      surfaces.push_back(surface);
    }
    work(input ? vtkPolyData::SafeDownCast(input) : empty.Get(), surfaces);
  }
  else if (kind != NOTHING)
  {
    const auto children = static_cast<unsigned int>(processes.Largest(ChildrenOf(input)));
    for (vtkSmartPointer<vtkDataObject>& result : results)
    {
      result = input ? vtkSmartPointer<vtkDataObject>::Take(input->NewInstance()) : nullptr;
    }
    for (unsigned int k = 0; k < children; ++k)
    {
      const Objects parts = Visit(processes, ChildOf(input, k), outputs, work);
      for (std::size_t i = 0; i < outputs && k < ChildrenOf(input); ++i)
      {
        SetChild(input, k, parts[i], results[i]);
      }
    }
  }
  return input ? results : Objects(outputs);
}
}

void ForEachSurface(Processes& processes, vtkDataObject* input,
  const std::vector<vtkDataObject*>& outputs, const SurfaceWork& work)
{
  const Objects results = Visit(processes, input, outputs.size(), work);
  for (std::size_t i = 0; i < outputs.size(); ++i)
  {
    if (results[i] && outputs[i])
    {
      outputs[i]->ShallowCopy(results[i]);
    }
  }
}

void AcceptBlocks(vtkInformation* port)
{
  port->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  for (const char* const type :
    { "vtkMultiBlockDataSet", "vtkPartitionedDataSet", "vtkPartitionedDataSetCollection" })
  {
    port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), type);
  }
}
}
