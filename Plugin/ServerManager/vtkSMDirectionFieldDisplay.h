// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMDirectionFieldDisplay
 * @brief how the output of a filter looks when it is shown for the first time
 *
 * The helper of DirectionFieldRepresentation, which ParaView runs where it creates a display, in
 * the window as in scripts, but not where it loads a state. It gives the display the properties
 * that the hints of the filter name for the output port shown:
 *
 * @code{xml}
 * <Hints>
 *   <Representation port="1" view="RenderView" type="DirectionFieldRepresentation" />
 *   <DirectionFieldDisplay port="1">
 *     <Property name="Specular" values="0.4" />
 *     <Property name="ColorArrayName" values="0;;;0;SingularityIndex" />
 *     <Glyph name="SphereSource">
 *       <Property name="ThetaResolution" values="24" />
 *     </Glyph>
 *     <ColorMap array="SingularityIndex">
 *       <Property name="ColorSpace" values="5" />
 *     </ColorMap>
 *     <Legend array="SingularityIndex">
 *       <Property name="Title" values="Singularities" />
 *     </Legend>
 *   </DirectionFieldDisplay>
 * </Hints>
 * @endcode
 *
 * The values of a property have semicolons between them. A Glyph is chosen among those that the
 * display offers. A ColorMap is given to an array that has none; with symmetric="1" once
 * the array is there, and it reaches as far as its values to both sides of 0, of which its RGBPoints
 * are parts. A coloring by such an array goes and comes with the array. The Legend is given to the legend of an array where one is shown for the first time
 * (vtkSMDirectionFieldRepresentationProxy). Nothing is changed that the caller has set, or that the
 * user has saved as a default of this display or of this color map.
 */

#ifndef vtkSMDirectionFieldDisplay_h
#define vtkSMDirectionFieldDisplay_h

#include "vtkDirectionFieldsServerManagerModule.h" // For export macro
#include "vtkSMProxyInitializationHelper.h"

class VTKDIRECTIONFIELDSSERVERMANAGER_EXPORT vtkSMDirectionFieldDisplay
  : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMDirectionFieldDisplay* New();
  vtkTypeMacro(vtkSMDirectionFieldDisplay, vtkSMProxyInitializationHelper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Gives the display `proxy`, whose input is connected, what its filter's hints name.
   */
  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

protected:
  vtkSMDirectionFieldDisplay();
  ~vtkSMDirectionFieldDisplay() override;

private:
  vtkSMDirectionFieldDisplay(const vtkSMDirectionFieldDisplay&) = delete;
  void operator=(const vtkSMDirectionFieldDisplay&) = delete;
};

#endif
