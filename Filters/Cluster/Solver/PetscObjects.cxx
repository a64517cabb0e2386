// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solver/PetscObjects.h"

#include <cstdio>
#include <cstring>
#include <string>

namespace DirectionFields::Parallel
{
namespace
{
PetscErrorCode EndWhereMemoryIsShort(MPI_Comm communicator, int line, const char* function,
  const char* file, PetscErrorCode code, PetscErrorType type, const char* message, void* context)
{
  // PETSc 3.18 gives the line of the program that asked for memory as the code, and as the message
  // its function.
  const bool isMalloc = function && std::strstr(function, "Malloc");
  if (code == PETSC_ERR_MEM || (isMalloc && type == PETSC_ERROR_INITIAL))
  {
    EndAllForMemory(isMalloc ? "" : message);
  }
  return PetscReturnErrorHandler(communicator, line, function, file, code, type, message, context);
}
}

void EndAllForMemory(const char* message)
{
  std::fprintf(stderr,
    "Direction Field: take more nodes, there is too little memory for the distributed solver. %s\n",
    message ? message : "");
  // The processes of PETSC_COMM_WORLD need not be the ones that wait.
  MPI_Abort(MPI_COMM_WORLD, 1);
}

void StartPetsc(MPI_Comm communicator)
{
  PetscBool isStarted = PETSC_FALSE;
  PetscInitialized(&isStarted);
  // Some of the processes may have started it with others, for another filter. The rest start it
  // together, which its objects do not care for: each has a communicator of its own.
  MPI_Comm rest = MPI_COMM_NULL;
  MPI_Comm_split(communicator, isStarted ? MPI_UNDEFINED : 0, 0, &rest);
  if (!isStarted)
  {
    // The communicator must live as long as PETSc.
    PETSC_COMM_WORLD = rest;
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
