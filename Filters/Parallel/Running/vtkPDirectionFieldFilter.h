// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPDirectionFieldFilter
 * @brief a filter of one process, executed on a surface whose pieces lie on several processes
 *
 * vtkPDirectionFieldFilter gives what its base class gives for the whole surface, for any number of
 * processes: the pieces are matched and gathered on one process as vtkPDirectionField does, with
 * their arrays of numbers. Results on the surface go back to the pieces; a dataset of its own, such
 * as lines or a mesh, stays on the process that has made it, and the others have it empty, with the
 * same arrays. Field data are those of the whole surface on each process. An error on one process
 * is an error of all. With one process it is its base class.
 */

#ifndef vtkPDirectionFieldFilter_h
#define vtkPDirectionFieldFilter_h

#include "vtkIndent.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkMultiProcessController.h"
#include "vtkPDirectionFieldPipeline.h"
#include "vtkPDirectionFieldRun.h"

#include <utility> // For std::move

// The wrappers for Python and for clients of a server take no templates as base classes: they read
// the base class itself, and the members that vtkPDirectionFieldFilter adds to it.
#ifdef __VTK_WRAP__
#define vtkPDirectionFieldFilterOf(base) base
#define vtkPDirectionFieldFilterMethods                                                            \
  void SetController(vtkMultiProcessController* controller);                                       \
  vtkMultiProcessController* GetController();                                                      \
  void SetGatherLimit(vtkIdType limit);                                                            \
  vtkIdType GetGatherLimit();                                                                      \
  vtkIdType GetGatherLimitMinValue();                                                              \
  vtkIdType GetGatherLimitMaxValue();
#else
#define vtkPDirectionFieldFilterOf(base) vtkPDirectionFieldFilter<base>
#define vtkPDirectionFieldFilterMethods
#endif

template <typename Base>
class vtkPDirectionFieldFilter : public Base
{
public:
  void PrintSelf(ostream& os, vtkIndent indent) override
  {
    this->Base::PrintSelf(os, indent);
    os << indent << "Controller: " << this->GetController() << "\n";
    os << indent << "GatherLimit: " << this->Run.GetGatherLimit() << "\n";
  }

  ///@{
  /**
   * The processes that have pieces of the surface. Default: the global controller when the filter
   * is made. Null: this process only. To be set before the filter has an input.
   */
  void SetController(vtkMultiProcessController* controller)
  {
    if (controller != this->Run.GetController())
    {
      this->Run.SetController(controller);
      this->GetInformation()->Set(vtkPDirectionFieldPipeline::CONTROLLER(), controller);
      this->Modified();
    }
  }
  vtkMultiProcessController* GetController() { return this->Run.GetController(); }
  ///@}

  ///@{
  /**
   * A surface of more polygons than this is gathered with a warning, which says how much memory
   * that takes. Range 0 to 715827882, the most triangles that one process can take; default
   * 20000000, as of vtkPDirectionField.
   */
  void SetGatherLimit(vtkIdType limit)
  {
    if (this->Run.SetGatherLimit(limit))
    {
      this->Modified();
    }
  }
  vtkIdType GetGatherLimit() { return this->Run.GetGatherLimit(); }
  vtkIdType GetGatherLimitMinValue() { return 0; }
  vtkIdType GetGatherLimitMaxValue() { return this->Run.LargestGatherLimit; }
  ///@}

protected:
  explicit vtkPDirectionFieldFilter(DirectionFields::Parallel::PortKinds ports)
    : Run(this, std::move(ports))
  {
    this->SetController(vtkMultiProcessController::GetGlobalController());
  }

  vtkExecutive* CreateDefaultExecutive() override { return vtkPDirectionFieldPipeline::New(); }

  bool TakesBlocks() const override
  {
    return this->Run.HasSeveralProcesses() || this->Base::TakesBlocks();
  }

  int FillInputPortInformation(int port, vtkInformation* info) override
  {
    const int isFilled = this->Base::FillInputPortInformation(port, info);
    if (this->Run.HasSeveralProcesses())
    {
      DirectionFields::Parallel::GatheringRun::FillInputPort(port, info);
    }
    return isFilled;
  }

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPDirectionFieldFilter(const vtkPDirectionFieldFilter&) = delete;
  void operator=(const vtkPDirectionFieldFilter&) = delete;

  DirectionFields::Parallel::GatheringRun Run;
};

//------------------------------------------------------------------------------
template <typename Base>
int vtkPDirectionFieldFilter<Base>::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->Run.HasSeveralProcesses())
  {
    return this->Base::RequestData(request, inputVector, outputVector);
  }
  DirectionFields::Parallel::FilterWork work;
  work.Check = [](vtkPolyData* piece) { Base::CheckInput(piece); };
  work.Compute = [this](const auto& inputs, const auto& outputs, std::string& error)
  { return this->Compute(inputs, outputs, error); };
  work.IsStopped = [this] { return this->IsStopped(); };
  return this->Run.Execute(work, inputVector, outputVector);
}

#endif
