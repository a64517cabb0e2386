// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPDirectionFieldGlyphs
 * @brief draws the glyphs of a direction field on a surface whose pieces lie on several processes
 *
 * vtkPDirectionFieldGlyphs gives the glyphs that vtkDirectionFieldGlyphs draws on the whole
 * surface, for any number of processes: spread over the seams between pieces as everywhere, none
 * twice. Spacing and MaximumNumberOfGlyphs mean the whole surface. The pieces are matched and
 * gathered on one process as vtkPDirectionField does, and each glyph goes to a process that has its
 * point `PointId`, the id of that piece. With one process it is vtkDirectionFieldGlyphs.
 *
 * Field data are those of the whole surface on each process. An error on one process is an error of
 * all.
 */

#ifndef vtkPDirectionFieldGlyphs_h
#define vtkPDirectionFieldGlyphs_h

#include "vtkDirectionFieldGlyphs.h"
#include "vtkDirectionFieldsFiltersParallelModule.h" // For export macro

class vtkMultiProcessController;

// VTK's class wrapper does not know namespaces named at once.
namespace DirectionFields
{
namespace Parallel
{
class Processes;
}
}

class VTKDIRECTIONFIELDSFILTERSPARALLEL_EXPORT vtkPDirectionFieldGlyphs
  : public vtkDirectionFieldGlyphs
{
public:
  static vtkPDirectionFieldGlyphs* New();
  vtkTypeMacro(vtkPDirectionFieldGlyphs, vtkDirectionFieldGlyphs);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The processes that have pieces of the surface. Default: the global controller when the filter
   * is made. Null: this process only. To be set before the filter has an input.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

protected:
  vtkPDirectionFieldGlyphs();
  ~vtkPDirectionFieldGlyphs() override;

  vtkExecutive* CreateDefaultExecutive() override;
  bool TakesBlocks() const override { return this->HasSeveralProcesses(); }
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPDirectionFieldGlyphs(const vtkPDirectionFieldGlyphs&) = delete;
  void operator=(const vtkPDirectionFieldGlyphs&) = delete;

  bool HasSeveralProcesses() const;
  /// The glyphs of one surface. Throws DirectionFields::Parallel::ProcessesError on all processes.
  void DrawPiece(
    DirectionFields::Parallel::Processes& processes, vtkPolyData* input, vtkPolyData* output);

  vtkMultiProcessController* Controller;
};

#endif
