// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The actions of direction fields as entries of the menu Tools, and a menu of presets: it does what
 * directionfields.apply_preset() does in a script. ParaView asks for a class for each place.
 */

#ifndef DirectionFieldMenu_h
#define DirectionFieldMenu_h

#include "DirectionFieldActions.h"

class DirectionFieldMenu : public DirectionFieldActions
{
  Q_OBJECT

public:
  explicit DirectionFieldMenu(QObject* parent);
};

#endif
