// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMDirectionFieldArrayDomain
 * @brief the arrays of an input that a property offers and that the input need not have
 *
 * An InputArrayDomain, optional or not, is told in the generated help as "The dataset must contain
 * a field array"; a domain of another name is not.
 */

#ifndef vtkSMDirectionFieldArrayDomain_h
#define vtkSMDirectionFieldArrayDomain_h

#include "vtkDirectionFieldsServerManagerModule.h" // For export macro
#include "vtkSMInputArrayDomain.h"

class VTKDIRECTIONFIELDSSERVERMANAGER_EXPORT vtkSMDirectionFieldArrayDomain
  : public vtkSMInputArrayDomain
{
public:
  static vtkSMDirectionFieldArrayDomain* New();
  vtkTypeMacro(vtkSMDirectionFieldArrayDomain, vtkSMInputArrayDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMDirectionFieldArrayDomain();
  ~vtkSMDirectionFieldArrayDomain() override;

private:
  vtkSMDirectionFieldArrayDomain(const vtkSMDirectionFieldArrayDomain&) = delete;
  void operator=(const vtkSMDirectionFieldArrayDomain&) = delete;
};

#endif
