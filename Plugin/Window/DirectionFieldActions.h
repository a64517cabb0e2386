// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The actions "Show direction field" and "Remesh to quads" of ParaView's window. They do what
 * directionfields.show_active() and directionfields.remesh_active() do in a script; with quads
 * selected that are on show, the latter saves them.
 */

#ifndef DirectionFieldActions_h
#define DirectionFieldActions_h

#include <QActionGroup>

class DirectionFieldActions : public QActionGroup
{
  Q_OBJECT

public:
  explicit DirectionFieldActions(QObject* parent);

private slots:
  void show();
  void remesh();

private:
  QAction* newAction(const char* name, const QString& text, const QString& tip);
};

#endif
