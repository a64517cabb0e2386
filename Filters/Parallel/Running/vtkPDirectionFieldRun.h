// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef vtkPDirectionFieldRun_h
#define vtkPDirectionFieldRun_h

#include "vtkDirectionFieldsFiltersParallelModule.h" // For export macro
#include "vtkType.h"

#include <functional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkInformation;
class vtkInformationVector;
class vtkMultiProcessController;
class vtkPolyData;

namespace DirectionFields::Parallel
{
class Processes;
struct WholeSurface;

/// The outputs of filters differ in the way back from the gathered surface to the pieces.
enum class OutputKind
{
  /// A dataset of its own, which stays on the process that has made it.
  OfItself,
  /// The surface with more data, which go back to the pieces. Where it has other cells than before,
  /// it stays on one process as well.
  Surface,
  /// Points with a CellId of the surface, which go where that cell is.
  OfCells,
  /// Cells with a PointId of the surface, which go where that point is.
  OfPoints
};

/// The second input of a filter.
enum class OtherInput
{
  None,
  /// Points or curves, all of which the filter gets.
  Parts,
  /// Another field on the same pieces.
  Surface
};

struct PortKinds
{
  OtherInput Other = OtherInput::None;
  std::vector<OutputKind> Outputs;
  /// Whether the second input has for each block of the first one its own, which is an error on
  /// several processes.
  bool OtherBelongsToBlocks = false;
};

/// The work of a filter on one process.
struct FilterWork
{
  /// Throws where the input contradicts itself.
  std::function<void(vtkPolyData*)> Check;
  /// Returns false with an error, which is empty where somebody has stopped the filter.
  std::function<bool(
    const std::vector<vtkDataObject*>&, const std::vector<vtkDataObject*>&, std::string&)>
    Compute;
  std::function<bool()> IsStopped;
};

// The file has a name of VTK's for it is installed among VTK's headers, as those that include it.
/// Lets a filter of one process work on a surface whose pieces lie on several: gathers it on one of
/// them, executes the filter there, and brings its outputs back.
class VTKDIRECTIONFIELDSFILTERSPARALLEL_EXPORT GatheringRun
{
public:
  /// Without a controller at first.
  /// @param filter must live longer
  GatheringRun(vtkAlgorithm* filter, PortKinds ports);
  ~GatheringRun();
  GatheringRun(const GatheringRun&) = delete;
  GatheringRun& operator=(const GatheringRun&) = delete;

  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const { return this->Controller; }
  bool HasSeveralProcesses() const;

  /// Lets both inputs be composite datasets as a whole.
  /// @param info as the filter itself has filled it
  static void FillInputPort(int port, vtkInformation* info);

  /// RequestData of the filter on several processes. All of them call it.
  int Execute(
    const FilterWork& work, vtkInformationVector** inputVector, vtkInformationVector* outputVector);

  /// Beyond this number of polygons it warns.
  /// @param limit 0 to LargestGatherLimit; another one becomes the nearest of these
  /// @return whether that is another one than before
  bool SetGatherLimit(vtkIdType limit);
  vtkIdType GetGatherLimit() const { return this->GatherLimit; }
  /// The most triangles that one process can take.
  static constexpr vtkIdType LargestGatherLimit = 715827882;

private:
  void RunOnPiece(Processes& processes, const FilterWork& work, vtkPolyData* piece,
    vtkDataObject* other, const std::vector<vtkPolyData*>& outputs) const;
  void Deliver(Processes& processes, const WholeSurface& whole, vtkPolyData* piece,
    const std::vector<vtkPolyData*>& wholes, const std::vector<vtkPolyData*>& outputs) const;
  /// Warns on the process that has gathered, and in the field data.
  void Warn(const WholeSurface& whole, const std::vector<vtkPolyData*>& wholes) const;
  bool HasSurfaceOutput() const;

  vtkAlgorithm* Filter;
  PortKinds Ports;
  vtkMultiProcessController* Controller = nullptr;
  vtkIdType GatherLimit = 20000000;
};
}

#endif
