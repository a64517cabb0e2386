// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The action "Show direction field" of ParaView's window. It does what
 * directionfields.show_active() does in a script.
 */

#ifndef ShowDirectionFieldActions_h
#define ShowDirectionFieldActions_h

#include <QActionGroup>

class ShowDirectionFieldActions : public QActionGroup
{
  Q_OBJECT

public:
  explicit ShowDirectionFieldActions(QObject* parent);

private slots:
  void show();
};

#endif
