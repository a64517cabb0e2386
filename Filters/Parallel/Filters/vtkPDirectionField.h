// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPDirectionField
 * @brief globally optimal n-direction field of a surface whose pieces lie on several processes
 *
 * vtkPDirectionField gives the field that vtkDirectionField gives of the whole surface, on each
 * process that of its own cells: directions, indices, field data and singularities are those of one
 * process, up to the tolerance of the solver. With one process it is vtkDirectionField.
 *
 * The surface may lie on one process, or in pieces, with or without ghost cells and global ids;
 * some processes may have none of it. Points of several pieces are the same point where their
 * global ids are equal (the active global ids of the point data, where all pieces have such and
 * they agree with the places), else where they lie on the borders of their pieces and are not
 * farther from each other than 5e-7 of the largest coordinate. Seams within a piece stay as
 * they are; MergePoints joins them, as with one process. Seams between pieces that have no global
 * ids are joined always, for nothing tells them from a cut.
 *
 * Gathered, the pieces go to the process with the largest one, which computes the field while the
 * others wait without taking processor time, and the results are scattered. That process needs
 * memory for the whole surface, about 670 bytes a triangle. Distributed, each process keeps its
 * piece and the triangles around it, and all processes solve together. See Distribution. A surface
 * that is on one process already stays there.
 *
 * An error on one process is an error of all, with the same text, and all outputs are empty.
 * Whoever is asked to stop stops all. All processes must execute the filter, as pvserver and
 * pvbatch do.
 *
 * @section Input Input
 * In addition to vtkDirectionField's: of a composite dataset each block is a surface of its own,
 * whose pieces are the blocks at the same place of the tree on all processes. Cells that
 * vtkGhostType marks as duplicates do not take part themselves, but have the field of the cells
 * that they are copies of; zero where no process has these, which is a warning.
 *
 * @section Output Output
 * As that of vtkDirectionField. Field data are those of the whole surface on each process;
 * components are ordered by the gathered cells, which are those of the first process, of the second
 * one and so on. Each singularity is on the process that has its cell. In addition, with several
 * processes,
 * - field data `Distribution`: vtkIdType, one tuple of named components: Used (0: the surface was
 *   on one process, 1: it was gathered, 2: it was distributed), Pieces (the number of processes
 *   that had a piece of it), SharedPoints (points that several pieces have in common).
 */

#ifndef vtkPDirectionField_h
#define vtkPDirectionField_h

#include "vtkDirectionField.h"
#include "vtkDirectionFieldsFiltersParallelModule.h" // For export macro

#include <functional> // For std::function
#include <memory>     // For std::unique_ptr
#include <string>
#include <vector>

class vtkMultiProcessController;

// VTK's class wrapper does not know namespaces named at once.
namespace DirectionFields
{
namespace Parallel
{
class Processes;
struct PointExchange;
struct GatheredSurface;
}
}

class VTKDIRECTIONFIELDSFILTERSPARALLEL_EXPORT vtkPDirectionField : public vtkDirectionField
{
public:
  static vtkPDirectionField* New();
  vtkTypeMacro(vtkPDirectionField, vtkDirectionField);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The processes that have pieces of the surface. Default: the global controller when the filter
   * is made. Null: this process only. To be set before the filter has an input.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  enum DistributionType
  {
    AUTOMATIC = 0,
    GATHER = 1,
    DISTRIBUTED = 2
  };

  ///@{
  /**
   * How a surface in pieces is solved for: gathered on one process (1), distributed (2), so that
   * nothing of it is ever whole on one process, which needs a build with PETSc, or gathered up to
   * GatherLimit and distributed beyond (0, default). Where an option needs the whole surface it is
   * gathered, and a warning says why. Without PETSc distributing is an error, and beyond
   * GatherLimit a warning.
   */
  vtkSetClampMacro(Distribution, int, AUTOMATIC, DISTRIBUTED);
  vtkGetMacro(Distribution, int);
  ///@}

  ///@{
  /**
   * Polygons and strips of the whole surface up to which Automatic gathers it. Range 0 to
   * 715827882, the most triangles that one process can take; default 20 million, for which that
   * process needs 14 GB where all are triangles.
   */
  vtkSetClampMacro(GatherLimit, vtkIdType, 0, 715827882);
  vtkGetMacro(GatherLimit, vtkIdType);
  ///@}

protected:
  vtkPDirectionField();
  ~vtkPDirectionField() override;

  vtkExecutive* CreateDefaultExecutive() override;
  bool TakesBlocks() const override { return this->HasSeveralProcesses(); }
  ///@{
  /**
   * As vtkDirectionField asks for them, for the piece of this process.
   */
  DirectionFields::Result ComputeField(vtkPolyData* input, const DirectionFields::Surface& surface,
    const DirectionFields::Options& options, DirectionFields::SurfaceFigures& figures) override;
  bool IsSpeaker() const override;
  void ReadTogether(const std::function<void()>& read) override;
  int TypeOfArrays(vtkPolyData* input) const override;
  ///@}

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPDirectionField(const vtkPDirectionField&) = delete;
  void operator=(const vtkPDirectionField&) = delete;

  bool HasSeveralProcesses() const;
  /// The field of one surface. Throws DirectionFields::Parallel::ProcessesError on all processes.
  void ComputePiece(DirectionFields::Parallel::Processes& processes, vtkPolyData* input,
    vtkPolyData* output, vtkPolyData* singularities);
  /// The same where one process has all polygons.
  void ComputeOnOne(DirectionFields::Parallel::Processes& processes, int process,
    vtkPolyData* input, vtkPolyData* output, vtkPolyData* singularities);
  /// Lets one process compute the field while the others wait.
  void ComputeWhole(DirectionFields::Parallel::Processes& processes, int process,
    vtkPolyData* input, vtkPolyData* output, vtkPolyData* singularities);
  /// The same by gathering.
  /// @param warning why it is gathered, where the user asked for something else; else empty
  void ComputeGathered(DirectionFields::Parallel::Processes& processes, vtkPolyData* input,
    const std::string& warning, vtkPolyData* output, vtkPolyData* singularities);
  /// The same without gathering. False where it cannot be done, for the reason that is set.
  bool ComputeDistributed(DirectionFields::Parallel::Processes& processes, vtkPolyData* input,
    vtkPolyData* output, vtkPolyData* singularities, std::string& reason);
  /// Adds the array Distribution to the field data.
  void AddDistribution(
    int used, vtkIdType pieces, vtkIdType sharedPoints, vtkPolyData* output) const;

  vtkMultiProcessController* Controller;
  int Distribution;
  vtkIdType GatherLimit;
  /// The processes that ComputeField works with; null where it computes for this process alone.
  DirectionFields::Parallel::Processes* Together;
  /// The widest type of all pieces' points, in which all have their arrays: else a point of several
  /// pieces would have rounded directions on some of them.
  int WidestType;
  /// Why the surface cannot be distributed; empty where it can.
  std::string Reason;
  vtkIdType SharedPoints;
  std::unique_ptr<DirectionFields::Parallel::PointExchange> Exchange;
};

#endif
