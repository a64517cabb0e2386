// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Included before what ParaView generates for the plugin. ParaView 6 looks for Python algorithms in the
// Python modules of a plugin: it runs each of them once, outside of its package, and what it finds takes
// the place of the plugin's XML. There are none in these; this stands in for ParaView's header.
#include <string>
#include <vector>

#define vtkPVPythonAlgorithmPlugin_h

namespace
{
struct vtkPVPythonAlgorithmPlugin
{
  static bool InitializeFromStringAndGetXMLs(
    const char*, const char*, const std::vector<std::string>&)
  {
    return true;
  }
};
}
