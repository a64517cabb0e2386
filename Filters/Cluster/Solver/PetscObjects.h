// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef PetscObjects_h
#define PetscObjects_h

#include "Mesh/Messages.h"

#include <petscksp.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace DirectionFields::Parallel
{
/// The type that callbacks return; newer releases have an enumeration.
constexpr auto NoError = static_cast<PetscErrorCode>(0);

/// Throws std::runtime_error where a function of PETSc has failed, on all processes alike.
inline void Require(PetscErrorCode code)
{
  if (code != NoError)
  {
    const char* text = nullptr;
    PetscErrorMessage(code, &text, nullptr);
    throw std::runtime_error(std::string("The distributed solver has failed: PETSc says \"") +
      (text ? text : "unknown") + "\".");
  }
}

/// An object of PETSc that is destroyed with its owner.
template <typename T, PetscErrorCode (*Destroy)(T*)>
class Owned
{
public:
  Owned() = default;
  ~Owned() { Destroy(&this->Object); }
  Owned(Owned&& other) noexcept
    : Object(std::exchange(other.Object, nullptr))
  {
  }
  Owned& operator=(Owned&& other) noexcept
  {
    std::swap(this->Object, other.Object);
    return *this;
  }
  operator T() const { return this->Object; } // NOLINT(google-explicit-constructor)
  /// Where a function of PETSc puts a new object; an object that was there is destroyed.
  T* New()
  {
    Destroy(&this->Object);
    return &this->Object;
  }

private:
  T Object = nullptr;
};

using OwnedMat = Owned<Mat, MatDestroy>;
using OwnedVec = Owned<Vec, VecDestroy>;
using OwnedKsp = Owned<KSP, KSPDestroy>;
using OwnedIndices = Owned<IS, ISDestroy>;
using OwnedScatter = Owned<VecScatter, VecScatterDestroy>;
using OwnedRandom = Owned<PetscRandom, PetscRandomDestroy>;

/// Starts PETSc on the processes of a communicator that have not started it; all of them call it.
/// It is ended with the program, by the system: whoever has started MPI ends it, and may have done
/// so before any destructor runs.
///
/// A failure on one process only within PETSc, such as too little memory, ends all processes with
/// PETSc's message.
void StartPetsc(MPI_Comm communicator);

/// Ends all processes where there is too little memory on this one while the others are in
/// functions of PETSc, which nothing can wake them from.
void EndAllForMemory(const char* message);
}

#endif
