// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The examples of direction fields in the menu Help: each does what directionfields.open_example()
 * does in a script.
 */

#ifndef ExampleMenu_h
#define ExampleMenu_h

#include <QActionGroup>

class ExampleMenu : public QActionGroup
{
  Q_OBJECT

public:
  explicit ExampleMenu(QObject* parent);
};

#endif
