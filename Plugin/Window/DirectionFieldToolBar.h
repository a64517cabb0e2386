// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Puts the actions of direction fields first into the toolbar that ParaView makes of the filters'
 * category in Menu.xml, so that there is one toolbar, and takes the least needed filter out. ParaView
 * fills that anew whenever filters come or go.
 */

#ifndef DirectionFieldToolBar_h
#define DirectionFieldToolBar_h

#include <QList>
#include <QObject>

class QAction;

class DirectionFieldToolBar : public QObject
{
  Q_OBJECT

public:
  explicit DirectionFieldToolBar(QObject* parent = nullptr);

  /// Called by ParaView once its window is there and the plugin is loaded.
  void startup();

  /// Called by ParaView before it ends.
  void shutdown() {}

private slots:
  void insertButtons();

private:
  QList<QAction*> Buttons;
  QAction* Separator = nullptr;
  bool IsPlaced = false;
};

#endif
