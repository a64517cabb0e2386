// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Names the filters that are made in ParaView's window after what they make and what of: "Field of
 * bunny.ply" where ParaView says "DirectionField1", so that lists of pipeline objects, as the dialog
 * for inputs, tell the fields of two meshes apart. The button names its filters so, too.
 */

#ifndef FilterNames_h
#define FilterNames_h

#include <QObject>

class pqPipelineSource;

class FilterNames : public QObject
{
  Q_OBJECT

public:
  explicit FilterNames(QObject* parent = nullptr);

  /// Called by ParaView once its window is there and the plugin is loaded.
  void startup();

  /// Called by ParaView before it ends.
  void shutdown() {}

private slots:
  void name(pqPipelineSource* source);
};

#endif
