// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef FieldFiles_h
#define FieldFiles_h

#include "vtkDirectionFieldReader.h"
#include "vtkDirectionFieldWriter.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

/// Fields that are written to files and read back.
namespace FieldFiles
{
inline std::string ReadFile(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  return std::string((std::istreambuf_iterator<char>(stream)), {});
}

inline void WriteFile(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
}

inline void Remove(const std::string& name)
{
  for (const char* ending : { ".rosy", ".ffield", ".rawfield", ".sing", ".sharp", ".obj" })
  {
    std::remove((name + ending).c_str());
  }
}

/// Writes a field. Returns whether that went well.
inline bool Write(vtkPolyData* field, const std::string& path, bool onPoints = false)
{
  vtkNew<vtkDirectionFieldWriter> writer;
  writer->SetInputData(field);
  writer->SetFileName(path.c_str());
  writer->SetFieldOn(onPoints ? vtkDirectionFieldWriter::POINTS : vtkDirectionFieldWriter::CELLS);
  writer->Write();
  return writer->GetErrorCode() == vtkErrorCode::NoError;
}

inline vtkSmartPointer<vtkPolyData> Read(vtkPolyData* mesh, const std::string& path)
{
  vtkNew<vtkDirectionFieldReader> reader;
  reader->SetInputData(mesh);
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

inline int SumOfIndices(vtkPolyData* field)
{
  vtkDataArray* indices = field->GetCellData()->GetArray("SingularityIndex");
  int sum = 0;
  for (vtkIdType i = 0; indices && i < indices->GetNumberOfTuples(); ++i)
  {
    sum += static_cast<int>(indices->GetComponent(i, 0));
  }
  return sum;
}
}

#endif
