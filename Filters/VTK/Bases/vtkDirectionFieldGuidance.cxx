// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDirectionFieldGuidance.h"

//------------------------------------------------------------------------------
vtkDirectionFieldGuidance::~vtkDirectionFieldGuidance()
{
  this->SetGuidanceVectors(nullptr);
  this->SetGuidanceWeights(nullptr);
  this->SetGuidanceStrengths(nullptr);
}
