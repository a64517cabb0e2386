// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMDirectionFieldRepresentationProxy
 * @brief a display of geometry whose legend looks as the filter's hints say
 *
 * ParaView's own legend of three steps has ticks, labels of their values and the range, which mean
 * nothing there. See vtkSMDirectionFieldDisplay for the hints. An array to color by may have no
 * values yet, as where a field has no singularities.
 */

#ifndef vtkSMDirectionFieldRepresentationProxy_h
#define vtkSMDirectionFieldRepresentationProxy_h

#include "vtkDirectionFieldsServerManagerModule.h" // For export macro
#include "vtkSMPVRepresentationProxy.h"

class VTKDIRECTIONFIELDSSERVERMANAGER_EXPORT vtkSMDirectionFieldRepresentationProxy
  : public vtkSMPVRepresentationProxy
{
public:
  static vtkSMDirectionFieldRepresentationProxy* New();
  vtkTypeMacro(vtkSMDirectionFieldRepresentationProxy, vtkSMPVRepresentationProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Shows or hides the legend. One that is made here gets the properties of the hints' Legend.
   */
  bool SetScalarBarVisibility(vtkSMProxy* view, bool visible) override;

protected:
  vtkSMDirectionFieldRepresentationProxy();
  ~vtkSMDirectionFieldRepresentationProxy() override;

  // VTK's wrapper of classes does not know the test.
#ifndef __VTK_WRAP__
#if !__has_include("vtkSMColorMapEditorHelper.h")
  /**
   * Leaves the range of the color map where the array has no values, at which ParaView up to 5.12
   * warns. Newer ones do not ask the representation.
   */
  using vtkSMPVRepresentationProxy::RescaleTransferFunctionToDataRange;
  bool RescaleTransferFunctionToDataRange(
    vtkPVArrayInformation* info, bool extend, bool force) override;
#endif
#endif

private:
  vtkSMDirectionFieldRepresentationProxy(const vtkSMDirectionFieldRepresentationProxy&) = delete;
  void operator=(const vtkSMDirectionFieldRepresentationProxy&) = delete;
};

#endif
