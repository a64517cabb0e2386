// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSMDirectionFieldAlignmentDomain.h"

#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include <algorithm>
#include <sstream>

vtkStandardNewMacro(vtkSMDirectionFieldAlignmentDomain);

//------------------------------------------------------------------------------
vtkSMDirectionFieldAlignmentDomain::vtkSMDirectionFieldAlignmentDomain() = default;
vtkSMDirectionFieldAlignmentDomain::~vtkSMDirectionFieldAlignmentDomain() = default;

//------------------------------------------------------------------------------
void vtkSMDirectionFieldAlignmentDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Entries of all degrees: " << this->All.size() << "\n";
}

//------------------------------------------------------------------------------
int vtkSMDirectionFieldAlignmentDomain::ReadXMLAttributes(
  vtkSMProperty* property, vtkPVXMLElement* element)
{
  // Checks the entries, too.
  if (!this->Superclass::ReadXMLAttributes(property, element))
  {
    return 0;
  }
  this->All.clear();
  for (unsigned int i = 0; i < element->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* nested = element->GetNestedElement(i);
    if (std::string(nested->GetName()) != "Entry")
    {
      continue;
    }
    BoundEntry entry;
    entry.Text = nested->GetAttributeOrEmpty("text");
    nested->GetScalarAttribute("value", &entry.Value);
    std::istringstream degrees(nested->GetAttributeOrEmpty("degrees"));
    for (int degree; degrees >> degree;)
    {
      entry.Degrees.push_back(degree);
    }
    this->All.push_back(entry);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkSMDirectionFieldAlignmentDomain::Update(vtkSMProperty* vtkNotUsed(property))
{
  vtkSMProperty* required = this->GetRequiredProperty("Degree");
  if (!required)
  {
    return;
  }
  const int degree = vtkSMUncheckedPropertyHelper(required).GetAsInt();
  std::vector<const BoundEntry*> offered;
  for (const BoundEntry& entry : this->All)
  {
    if (entry.Degrees.empty() ||
      std::find(entry.Degrees.begin(), entry.Degrees.end(), degree) != entry.Degrees.end())
    {
      offered.push_back(&entry);
    }
  }
  // The degree may change without a change in what it allows.
  bool same = offered.size() == this->GetNumberOfEntries();
  for (size_t i = 0; same && i < offered.size(); ++i)
  {
    same = offered[i]->Value == this->GetEntryValue(static_cast<unsigned int>(i));
  }
  if (!same)
  {
    this->RemoveAllEntries();
    for (const BoundEntry* entry : offered)
    {
      this->AddEntry(entry->Text.c_str(), entry->Value);
    }
    this->DomainModified();
  }
}
