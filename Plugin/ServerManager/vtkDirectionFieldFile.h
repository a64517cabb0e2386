// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDirectionFieldFile
 * @brief a direction field of a file on the mesh of the file beside it
 *
 * For File, Open: of NAME.rosy, NAME.ffield or NAME.rawfield it reads the mesh as well, from
 * NAME.obj, NAME.ply, NAME.stl or NAME.vtp, the first of these that there is in the same folder.
 * Outputs and errors are those of vtkDirectionFieldReader; without a mesh there is an error that
 * says so, and the outputs are empty.
 */

#ifndef vtkDirectionFieldFile_h
#define vtkDirectionFieldFile_h

#include "vtkDirectionFieldsServerManagerModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKDIRECTIONFIELDSSERVERMANAGER_EXPORT vtkDirectionFieldFile : public vtkPolyDataAlgorithm
{
public:
  static vtkDirectionFieldFile* New();
  vtkTypeMacro(vtkDirectionFieldFile, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read. It ends with .rosy, .ffield or .rawfield. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * What the rows of the file are for, as in vtkDirectionFieldReader: 0 finds out, 1 cells, 2
   * points.
   * Default: 0.
   */
  vtkSetClampMacro(FieldOn, int, 0, 2);
  vtkGetMacro(FieldOn, int);
  ///@}

protected:
  vtkDirectionFieldFile();
  ~vtkDirectionFieldFile() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  char* FileName = nullptr;
  int FieldOn = 0;

  vtkDirectionFieldFile(const vtkDirectionFieldFile&) = delete;
  void operator=(const vtkDirectionFieldFile&) = delete;
};

#endif
