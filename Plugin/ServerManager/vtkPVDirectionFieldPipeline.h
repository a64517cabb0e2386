// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVDirectionFieldPipeline
 * @brief vtkPDirectionFieldPipeline in ParaView, whose filters have executives of its own
 */

#ifndef vtkPVDirectionFieldPipeline_h
#define vtkPVDirectionFieldPipeline_h

#include "vtkDirectionFieldsServerManagerModule.h" // For export macro
#include "vtkPVCompositeDataPipeline.h"

class VTKDIRECTIONFIELDSSERVERMANAGER_EXPORT vtkPVDirectionFieldPipeline
  : public vtkPVCompositeDataPipeline
{
public:
  static vtkPVDirectionFieldPipeline* New();
  vtkTypeMacro(vtkPVDirectionFieldPipeline, vtkPVCompositeDataPipeline);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkPVDirectionFieldPipeline() = default;
  ~vtkPVDirectionFieldPipeline() override = default;

  using vtkPVCompositeDataPipeline::ForwardUpstream;
  int ForwardUpstream(vtkInformation* request) override;

private:
  vtkPVDirectionFieldPipeline(const vtkPVDirectionFieldPipeline&) = delete;
  void operator=(const vtkPVDirectionFieldPipeline&) = delete;
};

#endif
