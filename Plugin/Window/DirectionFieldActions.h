// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The actions "Show direction field", "Remesh to quads", "Draw strokes" and "Edit singularities" of ParaView's window.
 * The first two do what directionfields.show_active() and directionfields.remesh_active() do in a
 * script; with quads selected that are on show, the latter saves them. The others switch
 * StrokeTool and SingularityTool on, of which one is on at a time.
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
