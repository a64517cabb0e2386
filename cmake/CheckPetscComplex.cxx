// Compiles where PETSc is for complex numbers of double precision.
#include <petscksp.h>

#if !defined(PETSC_USE_COMPLEX) || !defined(PETSC_USE_REAL_DOUBLE)
#error "These are not the complex numbers of double precision that are needed."
#endif

int main()
{
  Mat adjoint = nullptr;
  return MatHermitianTranspose(adjoint, MAT_INITIAL_MATRIX, &adjoint) == 0 ? 0 : 1;
}
