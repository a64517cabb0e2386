// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMDirectionFieldArrayDomain
 * @brief the arrays of an input that a property offers and that the input need not have
 *
 * An InputArrayDomain, optional or not, is told in the generated help as "The dataset must contain
 * a field array"; a domain of another name is not.
 *
 * With the attribute `array_name` the input must have a point array of that name, so that menus
 * offer a filter of fields for fields only, and not for every surface that has normals.
 */

#ifndef vtkSMDirectionFieldArrayDomain_h
#define vtkSMDirectionFieldArrayDomain_h

#include "vtkDirectionFieldsServerManagerModule.h" // For export macro
#include "vtkSMInputArrayDomain.h"

#include <string>

class VTKDIRECTIONFIELDSSERVERMANAGER_EXPORT vtkSMDirectionFieldArrayDomain
  : public vtkSMInputArrayDomain
{
public:
  static vtkSMDirectionFieldArrayDomain* New();
  vtkTypeMacro(vtkSMDirectionFieldArrayDomain, vtkSMInputArrayDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Returns 1 if the first input that a property holds, or is about to, has such an array.
   */
  int IsInDomain(vtkSMProperty* property) override;

protected:
  vtkSMDirectionFieldArrayDomain();
  ~vtkSMDirectionFieldArrayDomain() override;

  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;

private:
  /// Empty for any name.
  std::string ArrayName;

  vtkSMDirectionFieldArrayDomain(const vtkSMDirectionFieldArrayDomain&) = delete;
  void operator=(const vtkSMDirectionFieldArrayDomain&) = delete;
};

#endif
