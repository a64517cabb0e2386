// Compiles where vtkAlgorithm has CheckAbort (VTK 9.2 and newer).
#include "vtkAlgorithm.h"

int main()
{
  return vtkAlgorithm::New()->CheckAbort() ? 1 : 0;
}
