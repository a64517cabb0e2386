# directionfields_precompile_vtk(TARGET): to read VTK's headers, and Eigen's, takes half of the compiler's time. Each
# target has definitions of its own, and so headers of its own.
function (directionfields_precompile_vtk target)
  target_precompile_headers(${target} PRIVATE
    <vtkCellArray.h> <vtkCellData.h> <vtkDoubleArray.h> <vtkFloatArray.h> <vtkIdTypeArray.h>
    <vtkInformation.h> <vtkInformationVector.h> <vtkIntArray.h> <vtkNew.h> <vtkPointData.h>
    <vtkPolyData.h> <vtkSmartPointer.h> <Eigen/Geometry>
    <algorithm> <complex> <functional> <memory> <string> <vector>)
endfunction ()
