// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * "Show direction field" as a button in a toolbar of its own; ParaView asks for a class for each place.
 */

#ifndef ShowDirectionFieldToolBar_h
#define ShowDirectionFieldToolBar_h

#include "ShowDirectionFieldActions.h"

class ShowDirectionFieldToolBar : public ShowDirectionFieldActions
{
  Q_OBJECT

public:
  using ShowDirectionFieldActions::ShowDirectionFieldActions;
};

#endif
