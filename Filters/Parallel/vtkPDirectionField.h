// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPDirectionField
 * @brief globally optimal n-direction field of a surface whose pieces lie on several processes
 *
 * vtkPDirectionField gives the field that vtkDirectionField gives of the whole surface, on each process that of
 * its own cells: directions, indices, field data and singularities are those of one process, up to the
 * tolerance of the solver. With one process it is vtkDirectionField.
 *
 * The surface may lie on one process, or in pieces, with or without ghost cells and global ids; some processes
 * may have none of it. Points of several pieces are the same point where their global ids are equal (the active
 * global ids of the point data, where all pieces have such and they agree with the places), else where they
 * lie on the borders of their pieces and are not farther from each other than 5e-7 of the largest coordinate.
 * Seams within a piece stay what they are; MergePoints joins them, as with one process. Seams between pieces
 * that have no global ids are joined always, for nothing tells them from a cut.
 *
 * The pieces are gathered on the process with the largest one, which computes the field while the others wait
 * without taking processor time, and the results are scattered. That process needs memory for the whole
 * surface, about 670 bytes a triangle; see GatherLimit. A surface that is on one process already stays there.
 *
 * An error on one process is an error of all, with the same text, and all outputs are empty. Whoever is asked
 * to stop stops all. All processes must execute the filter, as pvserver and pvbatch do.
 *
 * @section Input Input
 * In addition to vtkDirectionField's: of a composite dataset each block is a surface of its own, whose pieces are
 * the blocks at the same place of the tree on all processes. Cells that vtkGhostType marks as duplicates do not
 * take part themselves, but have the field of the cells that they are copies of; zero where no process has these.
 *
 * @section Output Output
 * As that of vtkDirectionField. Field data are those of the whole surface on each process; components are
 * ordered by the gathered cells, which are those of the first process, of the second one and so on. Each
 * singularity is on the process that has its cell. In addition, with several processes,
 * - field data `Distribution`: vtkIdType, one tuple of named components: Used (0: the surface was on one process,
 *   1: it was gathered), Pieces (the number of processes that had a piece of it), SharedPoints (points that
 *   several pieces have in common).
 */

#ifndef vtkPDirectionField_h
#define vtkPDirectionField_h

#include "vtkDirectionField.h"
#include "vtkDirectionFieldsFiltersParallelModule.h" // For export macro

#include <string>
#include <vector>

class vtkMultiProcessController;

// VTK's class wrapper does not know namespaces named at once.
namespace DirectionFields
{
namespace Parallel
{
class Processes;
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
   * The processes that have pieces of the surface. Default: the global controller when the filter is made. Null:
   * this process only. To be set before the filter has an input.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  ///@{
  /**
   * Polygons and strips of the whole surface beyond which a warning says how much memory gathering takes on one
   * process. Range 0 to 715827882, the most triangles that can be processed; default 20 million, for which that
   * process needs 14 GB where all are triangles.
   */
  vtkSetClampMacro(GatherLimit, vtkIdType, 0, 715827882);
  vtkGetMacro(GatherLimit, vtkIdType);
  ///@}

protected:
  vtkPDirectionField();
  ~vtkPDirectionField() override;

  vtkExecutive* CreateDefaultExecutive() override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPDirectionField(const vtkPDirectionField&) = delete;
  void operator=(const vtkPDirectionField&) = delete;

  bool HasSeveralProcesses() const;
  /// The field of one surface. Throws DirectionFields::Parallel::ProcessesError on all processes.
  void ComputePiece(DirectionFields::Parallel::Processes& processes, vtkInformation* request,
    vtkPolyData* input, vtkPolyData* output, vtkPolyData* singularities);
  /// The same where one process has all polygons.
  void ComputeOnOne(DirectionFields::Parallel::Processes& processes, int process,
    vtkInformation* request, vtkPolyData* input, vtkPolyData* output, vtkPolyData* singularities);
  /// Lets one process compute the field while the others wait.
  void ComputeWhole(DirectionFields::Parallel::Processes& processes, int process,
    vtkInformation* request, vtkPolyData* input, vtkPolyData* output, vtkPolyData* singularities);
  /// Adds what was done to the field data.
  void AddDistribution(int used, const DirectionFields::Parallel::GatheredSurface& gathered,
    vtkPolyData* output) const;

  vtkMultiProcessController* Controller;
  vtkIdType GatherLimit;
};

#endif
