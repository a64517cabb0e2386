// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPDirectionFieldWriter
 * @brief writes the field of a surface whose pieces lie on several processes
 *
 * vtkPDirectionFieldWriter writes the files that vtkDirectionFieldWriter writes for the whole
 * surface, from one process: vtkPGatheredSurface brings the pieces there. Points of several pieces
 * have one row. With global ids points have the order of the whole surface. The rows of cells are
 * those of the first process's, of the second one's and so on, and so are the triangles of the mesh
 * beside the file.
 *
 * All processes call Write; an error on one of them is an error of all. With one process it is
 * vtkDirectionFieldWriter.
 */

#ifndef vtkPDirectionFieldWriter_h
#define vtkPDirectionFieldWriter_h

#include "vtkDirectionFieldWriter.h"
#include "vtkDirectionFieldsFiltersParallelModule.h" // For export macro

class vtkMultiProcessController;
class vtkPGatheredSurface;

// VTK's class wrapper does not know namespaces named at once.
namespace DirectionFields
{
namespace Parallel
{
class Processes;
}
}

class VTKDIRECTIONFIELDSFILTERSPARALLEL_EXPORT vtkPDirectionFieldWriter
  : public vtkDirectionFieldWriter
{
public:
  static vtkPDirectionFieldWriter* New();
  vtkTypeMacro(vtkPDirectionFieldWriter, vtkDirectionFieldWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The processes that have pieces of the surface. Default: the global controller when the writer
   * is made. Null: this process only. To be set before the writer has an input.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  ///@{
  /**
   * A surface of more polygons than this is gathered with a warning, which says how much memory
   * that takes. Range 0 to 715827882, default 20000000, as of vtkPDirectionField.
   */
  void SetGatherLimit(vtkIdType limit);
  vtkIdType GetGatherLimit();
  vtkIdType GetGatherLimitMinValue();
  vtkIdType GetGatherLimitMaxValue();
  ///@}

protected:
  vtkPDirectionFieldWriter();
  ~vtkPDirectionFieldWriter() override;

  vtkExecutive* CreateDefaultExecutive() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkPDirectionFieldWriter(const vtkPDirectionFieldWriter&) = delete;
  void operator=(const vtkPDirectionFieldWriter&) = delete;

  bool HasSeveralProcesses();
  /// Throws DirectionFields::Parallel::ProcessesError on all processes.
  void WriteGathered(DirectionFields::Parallel::Processes& processes);

  vtkPGatheredSurface* Gather;
};

#endif
