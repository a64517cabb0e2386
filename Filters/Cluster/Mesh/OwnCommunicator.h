// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef OwnCommunicator_h
#define OwnCommunicator_h

#include "vtkMPI.h"
#include "vtkMPICommunicator.h"
#include "vtkMultiProcessController.h"

namespace DirectionFields::Parallel
{
/// A communicator of the solver's own, whose messages meet no others.
class OwnCommunicator
{
public:
  explicit OwnCommunicator(vtkMultiProcessController* controller)
  {
    auto* const communicator = vtkMPICommunicator::SafeDownCast(controller->GetCommunicator());
    this->IsThere = communicator != nullptr;
    if (this->IsThere)
    {
      MPI_Comm_dup(*communicator->GetMPIComm()->GetHandle(), &this->Handle);
    }
  }
  ~OwnCommunicator()
  {
    if (this->IsThere)
    {
      MPI_Comm_free(&this->Handle);
    }
  }
  OwnCommunicator(const OwnCommunicator&) = delete;
  OwnCommunicator& operator=(const OwnCommunicator&) = delete;

  MPI_Comm Handle = MPI_COMM_NULL;
  bool IsThere = false;
};
}

#endif
