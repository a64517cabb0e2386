// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMDirectionFieldColorDomain
 * @brief the arrays that a display of the plugin offers to color by
 *
 * All but those that tell nothing as colors: unit vectors, namely the directions of a field, whose
 * order at a point is arbitrary, and normals; the tensors that guided a field (SurfaceTensor), whose
 * components are in the axes of space; strings; and the field data of a single surface, which would be
 * one color.
 */

#ifndef vtkSMDirectionFieldColorDomain_h
#define vtkSMDirectionFieldColorDomain_h

#include "vtkDirectionFieldsServerManagerModule.h" // For export macro
#include "vtkSMRepresentedArrayListDomain.h"

class VTKDIRECTIONFIELDSSERVERMANAGER_EXPORT vtkSMDirectionFieldColorDomain
  : public vtkSMRepresentedArrayListDomain
{
public:
  static vtkSMDirectionFieldColorDomain* New();
  vtkTypeMacro(vtkSMDirectionFieldColorDomain, vtkSMRepresentedArrayListDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMDirectionFieldColorDomain();
  ~vtkSMDirectionFieldColorDomain() override;

  bool IsFilteredArray(vtkPVDataInformation* data, int association, const char* name) override;

private:
  vtkSMDirectionFieldColorDomain(const vtkSMDirectionFieldColorDomain&) = delete;
  void operator=(const vtkSMDirectionFieldColorDomain&) = delete;
};

#endif
