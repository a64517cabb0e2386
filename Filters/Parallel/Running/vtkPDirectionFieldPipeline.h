// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPDirectionFieldPipeline
 * @brief the executive of filters that several processes must execute together
 *
 * Where a filter upstream fails on one process, pipelines do not execute the following filters
 * there, for which the other processes would wait for ever. This executive lets all processes agree
 * on whether to execute its filter.
 */

#ifndef vtkPDirectionFieldPipeline_h
#define vtkPDirectionFieldPipeline_h

#include "vtkCompositeDataPipeline.h"
#include "vtkDirectionFieldsFiltersParallelModule.h" // For export macro

class vtkInformationObjectBaseKey;

class VTKDIRECTIONFIELDSFILTERSPARALLEL_EXPORT vtkPDirectionFieldPipeline
  : public vtkCompositeDataPipeline
{
public:
  static vtkPDirectionFieldPipeline* New();
  vtkTypeMacro(vtkPDirectionFieldPipeline, vtkCompositeDataPipeline);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The processes of a filter, in its own information: a vtkMultiProcessController.
   */
  static vtkInformationObjectBaseKey* CONTROLLER();

  /**
   * The result of a pipeline's inputs, agreed on by all processes of its filter: 0 with an error
   * where any has failed. Only asks the others in the passes of an update, and where the filter has
   * several processes.
   */
  static int Agree(vtkExecutive* pipeline, vtkInformation* request, int result);

protected:
  vtkPDirectionFieldPipeline() = default;
  ~vtkPDirectionFieldPipeline() override = default;

  using vtkCompositeDataPipeline::ForwardUpstream;
  int ForwardUpstream(vtkInformation* request) override;

private:
  vtkPDirectionFieldPipeline(const vtkPDirectionFieldPipeline&) = delete;
  void operator=(const vtkPDirectionFieldPipeline&) = delete;
};

#endif
