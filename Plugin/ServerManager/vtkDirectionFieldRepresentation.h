// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDirectionFieldRepresentation
 * @brief shows a surface together with the directions of its field
 *
 * Beside the surface it draws the glyphs that vtkDirectionFieldGlyphs makes of it with its defaults,
 * in a colour of their own, and as orange lines the edges that the field was made to follow: sharp
 * edges, boundaries, edges of more than two triangles. They are made where the data are, of each
 * block and of each process's piece, and only while the representation is shown. Data without a
 * field look as a surface does.
 */

#ifndef vtkDirectionFieldRepresentation_h
#define vtkDirectionFieldRepresentation_h

#include "vtkDirectionFieldsServerManagerModule.h" // For export macro
#include "vtkGeometryRepresentationWithFaces.h"
#include "vtkNew.h"          // For the actors
#include "vtkSmartPointer.h" // For the filters

#include <cstddef>
#include <vector>

class vtkActor;
class vtkAppendPolyData;
class vtkDirectionFieldGlyphs;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderer;

class VTKDIRECTIONFIELDSSERVERMANAGER_EXPORT vtkDirectionFieldRepresentation
  : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkDirectionFieldRepresentation* New();
  vtkTypeMacro(vtkDirectionFieldRepresentation, vtkGeometryRepresentationWithFaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output) override;
  void SetVisibility(bool visible) override;

protected:
  vtkDirectionFieldRepresentation();
  ~vtkDirectionFieldRepresentation() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  /// What is drawn beside the surface.
  struct Part
  {
    vtkNew<vtkPolyData> Data;
    vtkNew<vtkPolyDataMapper> Mapper;
    vtkNew<vtkActor> Actor;
  };

  /// Makes what is drawn of a block; false where it has no directions.
  bool AddBlock(
    vtkPolyData* block, std::size_t number, vtkAppendPolyData* glyphs, vtkAppendPolyData* lines);

  /// One for each block that has directions; they keep their places while the directions change.
  std::vector<vtkSmartPointer<vtkDirectionFieldGlyphs>> Filters;
  Part Glyphs;
  Part Lines;

  vtkDirectionFieldRepresentation(const vtkDirectionFieldRepresentation&) = delete;
  void operator=(const vtkDirectionFieldRepresentation&) = delete;
};

#endif
