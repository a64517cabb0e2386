// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * "Show direction field" as an entry of the menu Tools; ParaView asks for a class for each place.
 */

#ifndef ShowDirectionFieldMenu_h
#define ShowDirectionFieldMenu_h

#include "ShowDirectionFieldActions.h"

class ShowDirectionFieldMenu : public ShowDirectionFieldActions
{
  Q_OBJECT

public:
  using ShowDirectionFieldActions::ShowDirectionFieldActions;
};

#endif
