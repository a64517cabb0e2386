// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDirectionFieldFile.h"

#include "vtkDirectionFieldReader.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkObjectFactory.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkSmartPointer.h"
#include "vtkXMLPolyDataReader.h"
#include "vtksys/SystemTools.hxx"

#include <locale.h> // For uselocale, which C++ does not have

#include <string>

vtkStandardNewMacro(vtkDirectionFieldFile);

namespace
{
/// Lets this thread read numbers with a decimal point, which files have: VTK's readers of meshes
/// take them as the user's locale writes them.
class DecimalPoint
{
public:
  DecimalPoint()
    : Own(newlocale(LC_NUMERIC_MASK, "C", duplocale(uselocale(nullptr))))
    , Before(uselocale(Own))
  {
  }
  ~DecimalPoint()
  {
    uselocale(this->Before);
    freelocale(this->Own);
  }
  DecimalPoint(const DecimalPoint&) = delete;
  DecimalPoint& operator=(const DecimalPoint&) = delete;

private:
  locale_t Own;
  locale_t Before;
};

template <typename ReaderT>
vtkSmartPointer<vtkAlgorithm> Reader(const std::string& path)
{
  const auto reader = vtkSmartPointer<ReaderT>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

/// A reader of the mesh whose file has this name but for the ending; null if there is none.
vtkSmartPointer<vtkAlgorithm> MeshBeside(const std::string& name)
{
  const auto has = [&](const char* ending)
  { return vtksys::SystemTools::FileExists(name + ending, /*isFile=*/true); };
  return has(".obj") ? Reader<vtkOBJReader>(name + ".obj")
    : has(".ply")    ? Reader<vtkPLYReader>(name + ".ply")
    : has(".stl")    ? Reader<vtkSTLReader>(name + ".stl")
    : has(".vtp")    ? Reader<vtkXMLPolyDataReader>(name + ".vtp")
                     : nullptr;
}
}

//------------------------------------------------------------------------------
vtkDirectionFieldFile::vtkDirectionFieldFile()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkDirectionFieldFile::~vtkDirectionFieldFile()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkDirectionFieldFile::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "FieldOn: " << this->FieldOn << "\n";
}

//------------------------------------------------------------------------------
int vtkDirectionFieldFile::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const std::string path = this->FileName ? this->FileName : "";
  const std::string name = path.substr(0, path.rfind('.'));
  const vtkSmartPointer<vtkAlgorithm> mesh = MeshBeside(name);
  if (!mesh)
  {
    vtkErrorMacro(<< "A direction field needs its mesh: put " << name
                  << ".obj, .ply, .stl or .vtp beside " << path
                  << ", or open the mesh and apply Read Direction Field to it.");
    // With a failure the pipeline would add words of its own.
    return 1;
  }
  const DecimalPoint point;
  vtkNew<vtkDirectionFieldReader> reader;
  reader->SetInputConnection(mesh->GetOutputPort());
  reader->SetFileName(path.c_str());
  reader->SetFieldOn(this->FieldOn);
  reader->Update();
  for (int port = 0; port < 2; ++port)
  {
    vtkPolyData::GetData(outputVector, port)->ShallowCopy(reader->GetOutput(port));
  }
  return 1;
}
