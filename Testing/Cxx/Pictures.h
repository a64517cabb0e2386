// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Pictures_h
#define Pictures_h

#include "Checks.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkImageDifference.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWindowToImageFilter.h"

#include <iostream>
#include <string>

/// Pictures by a parallel projection, and their comparison with baselines.
namespace Pictures
{
/// A square picture without antialiasing, seen from view.Position towards view.FocalPoint with
/// view.ViewUp above; view.Scale is half its height.
template <typename View>
vtkSmartPointer<vtkImageData> Draw(vtkRenderer* renderer, const View& view, int size)
{
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(size, size);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetPosition(view.Position);
  camera->SetFocalPoint(view.FocalPoint);
  camera->SetViewUp(view.ViewUp);
  camera->SetParallelScale(view.Scale);
  renderer->ResetCameraClippingRange();
  window->Render();

  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->Update();
  return grab->GetOutput();
}

/// How much pictures may differ, in percent of the greatest possible difference.
struct Limits
{
  /// The picture of a correct field differs by less than this on any machine.
  double Most;
  /// The picture of a field turned by 10 degrees differs by more than this.
  double LeastTurned;
};

/// Writes the picture and compares it with the baseline: percent of the greatest possible
/// difference, averaged over the image. Pixels may not move, as vtkTesting lets them, for a glyph
/// that turns moves its pixels little; they are averaged with their neighbours, for the edges of
/// polygons.
inline void CheckPicture(vtkImageData* image, const std::string& baseline,
  const std::string& output, bool turned, const Limits& limits)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(output.c_str());
  writer->SetInputData(image);
  writer->Write();
  vtkNew<vtkPNGReader> reader;
  if (!reader->CanReadFile(baseline.c_str()))
  {
    std::cerr << "No baseline " << baseline << "; the picture is " << output << std::endl;
    CHECK(false);
    return;
  }
  reader->SetFileName(baseline.c_str());
  vtkNew<vtkImageDifference> comparison;
  comparison->SetInputData(image);
  comparison->SetImageConnection(reader->GetOutputPort());
  comparison->AllowShiftOff();
  comparison->AveragingOn();
  comparison->SetThreshold(16);
  comparison->Update();
  const int* size = image->GetDimensions();
  const double difference = 100.0 * comparison->GetThresholdedError() / (size[0] * size[1]);
  std::cout << "Difference: " << difference << " %, picture: " << output << std::endl;
  CHECK(turned ? difference > limits.LeastTurned : difference < limits.Most);
}
}

#endif
