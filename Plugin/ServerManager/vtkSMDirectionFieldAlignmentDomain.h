// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMDirectionFieldAlignmentDomain
 * @brief the alignments that a direction field of the chosen degree can have
 *
 * An enumeration whose entries may be bound to degrees: an Entry with the attribute `degrees`, a
 * list of numbers, is offered only while the required property of the function Degree has one of
 * them.
 *
 * @code{xml}
 * <DirectionFieldAlignmentDomain name="enum">
 *   <Entry text="None" value="0" />
 *   <Entry text="Principal Curvature" value="1" degrees="2 4" />
 *   <RequiredProperties>
 *     <Property function="Degree" name="Degree" />
 *   </RequiredProperties>
 * </DirectionFieldAlignmentDomain>
 * @endcode
 */

#ifndef vtkSMDirectionFieldAlignmentDomain_h
#define vtkSMDirectionFieldAlignmentDomain_h

#include "vtkDirectionFieldsServerManagerModule.h" // For export macro
#include "vtkSMEnumerationDomain.h"

#include <string> // For std::string
#include <vector> // For std::vector

class VTKDIRECTIONFIELDSSERVERMANAGER_EXPORT vtkSMDirectionFieldAlignmentDomain
  : public vtkSMEnumerationDomain
{
public:
  static vtkSMDirectionFieldAlignmentDomain* New();
  vtkTypeMacro(vtkSMDirectionFieldAlignmentDomain, vtkSMEnumerationDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Takes the degree's unchecked value, so that the panel follows before it is applied.
   */
  void Update(vtkSMProperty* property) override;

protected:
  vtkSMDirectionFieldAlignmentDomain();
  ~vtkSMDirectionFieldAlignmentDomain() override;

  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;

private:
  vtkSMDirectionFieldAlignmentDomain(const vtkSMDirectionFieldAlignmentDomain&) = delete;
  void operator=(const vtkSMDirectionFieldAlignmentDomain&) = delete;

  struct BoundEntry
  {
    std::string Text;
    int Value;
    /// Empty for all degrees.
    std::vector<int> Degrees;
  };
  std::vector<BoundEntry> All;
};

#endif
