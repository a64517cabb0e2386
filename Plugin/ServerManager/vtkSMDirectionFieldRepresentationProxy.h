// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMDirectionFieldRepresentationProxy
 * @brief a display of geometry whose legend looks as the filter's hints say
 *
 * ParaView's own legend of three steps has ticks, labels of their values and the range, which mean
 * nothing there. See vtkSMDirectionFieldDisplay for the hints. An array to color by may have no
 * values yet, as where a field has no singularities or follows no tensors.
 */

#ifndef vtkSMDirectionFieldRepresentationProxy_h
#define vtkSMDirectionFieldRepresentationProxy_h

#include "vtkDirectionFieldsServerManagerModule.h" // For export macro
#include "vtkSMPVRepresentationProxy.h"

#include <functional>
#include <string>

class vtkPVArrayInformation;
class vtkPVXMLElement;

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

  /**
   * Gives the arrays that are there the color maps of the hints that are symmetric about 0.
   */
  void GiveSymmetricColorMaps();

  /**
   * Takes the coloring back where its array is not there, which newer ParaViews warn of, as that of
   * singularities where a field has none, or the value along lines of one that follows no tensors.
   * It comes when the array does, unless another one was chosen meanwhile.
   */
  void ColorWhereThereAreValues();

  /**
   * Before the view draws this for the first time, takes the coloring back that ParaView has chosen,
   * where the array has the same value everywhere, as the label of the only solid of an STL file or
   * the value of a contour: it would hide the filter's own colors, and tell nothing. A coloring by
   * the filter's hints stays.
   */
  void LeaveColoringOfOneValue() { this->LeavesOneValue = true; }

  /**
   * Before the view draws this for the first time, hides what else shows the directions of the
   * field that it was made of there: the glyphs of that, and its representation Direction Field,
   * which becomes Surface. What the user turns on again later stays.
   */
  void HideDirections() { this->HidesDirections = true; }

  /**
   * The same for a filter that shows something else in place of that: the field's surface, its
   * singularities and the line that sums it up are hidden, too.
   */
  void ReplaceField() { this->HidesDirections = this->ReplacesField = true; }

  /**
   * Called by a view after its data are up to date, before it draws. What the data say of themselves
   * becomes the caption of the display, if it has one. A coloring by an array with a symmetric color
   * map goes and comes with it, and that map is stretched. A legend of the filter's hints is hidden
   * where nothing is left that has its colors, as where a field has become one without
   * singularities, and comes back when they do.
   */
  void ViewUpdated(vtkSMProxy* view) override;

protected:
  vtkSMDirectionFieldRepresentationProxy();
  ~vtkSMDirectionFieldRepresentationProxy() override;

  /**
   * Makes the sub-proxies. In place of SurfaceRepresentation, from which ParaView's display has the
   * array to color by, comes SurfaceOfDirectionField, which offers fewer of them.
   */
  int CreateSubProxiesAndProperties(
    vtkSMSessionProxyManager* manager, vtkPVXMLElement* element) override;

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
  vtkPVArrayInformation* FindArray(int association, const std::string& name);
  void HideDirectionsIn(vtkSMProxy* view);
  void ColorAwaited(vtkSMProxy* view);
  void LeaveOneValue(vtkSMProxy* view);
  void LeaveVanished(vtkSMProxy* view);
  void ForSymmetricColorMaps(
    const std::function<void(const std::string&, vtkPVXMLElement*)>& visit);
  void HideEmptyLegend(vtkSMProxy* view);
  void WriteCaption();

  /// The array to color by once there is one of that name; empty: none.
  std::string AwaitedArray;
  int AwaitedAssociation = 0;
  bool HidesDirections = false;
  bool ReplacesField = false;
  bool LeavesOneValue = false;
  bool HasHiddenLegend = false;

  vtkSMDirectionFieldRepresentationProxy(const vtkSMDirectionFieldRepresentationProxy&) = delete;
  void operator=(const vtkSMDirectionFieldRepresentationProxy&) = delete;
};

#endif
