// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distributed/PetscObjects.h"

#include <cstdio>

namespace DirectionFields::Parallel
{
namespace
{
PetscErrorCode EndWhereMemoryIsShort(MPI_Comm communicator, int line, const char* function,
  const char* file, PetscErrorCode code, PetscErrorType type, const char* message, void* context)
{
  if (code == PETSC_ERR_MEM)
  {
    std::fprintf(stderr,
      "Direction Field: take more nodes, there is too little memory for the distributed solver. %s\n",
      message ? message : "");
    int size = 1;
    MPI_Comm_size(PETSC_COMM_WORLD, &size);
    if (size > 1)
    {
      MPI_Abort(PETSC_COMM_WORLD, 1);
    }
  }
  return PetscReturnErrorHandler(communicator, line, function, file, code, type, message, context);
}
}

void StartPetsc(MPI_Comm communicator)
{
  PetscBool isStarted = PETSC_FALSE;
  PetscInitialized(&isStarted);
  if (!isStarted)
  {
    // The communicator must live as long as PETSc.
    MPI_Comm_dup(communicator, &PETSC_COMM_WORLD);
    std::string name = "DirectionFields";
    std::string noSignals = "-no_signal_handler";
    std::string noFile = "-skip_petscrc";
    char* values[] = { &name[0], &noSignals[0], &noFile[0], nullptr };
    char** arguments = values;
    int count = 3;
    Require(PetscInitialize(&count, &arguments, nullptr, nullptr));
    Require(PetscPushErrorHandler(EndWhereMemoryIsShort, nullptr));
  }
}
}
