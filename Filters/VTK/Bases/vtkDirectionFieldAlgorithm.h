// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDirectionFieldAlgorithm
 * @brief base of the filters for direction fields
 *
 * vtkDirectionFieldAlgorithm runs a filter with the threads that it may use, reports its errors,
 * and empties its outputs where it has one or was stopped. Filters that take composite datasets as
 * a whole get outputs of the same class.
 *
 * Every output has a line in its field data that says what the filter has made, `Summary`, and
 * `Warnings` where there are any. Reports of the filters before it are not passed on.
 */

#ifndef vtkDirectionFieldAlgorithm_h
#define vtkDirectionFieldAlgorithm_h

#include "vtkDirectionFieldsFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string>
#include <vector>

namespace DirectionFields
{
class Progress;
}

class VTKDIRECTIONFIELDSFILTERS_EXPORT vtkDirectionFieldAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkDirectionFieldAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether the outputs have the figures of the computation in their field data, beside Summary and
   * Warnings, and arrays for few. Default on; in ParaView, whose menus list them all, off.
   */
  vtkSetMacro(Diagnostics, bool);
  vtkGetMacro(Diagnostics, bool);
  vtkBooleanMacro(Diagnostics, bool);
  ///@}

  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

protected:
  vtkDirectionFieldAlgorithm() = default;
  ~vtkDirectionFieldAlgorithm() override = default;

  /// The data of all ports; null for an optional input that is missing.
  using Ports = std::vector<vtkDataObject*>;

  /**
   * Fills the outputs. Throws a std::exception with a sentence for the user, or
   * DirectionFields::Stopped.
   */
  virtual void Execute(
    const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress) = 0;

  /**
   * Called after Execute to release everything that is not kept for the next execution.
   */
  virtual void Release(bool hasFailed);

  ///@{
  /**
   * The threads to execute with, by default as many as VTK's backend has; advice where there is too
   * little memory, the beginning of a sentence; and whether the filter takes composite datasets as
   * a whole, by default not.
   */
  virtual int ThreadsToUse() const;
  virtual const char* MemoryAdvice() const;
  virtual bool TakesBlocks() const { return false; }
  ///@}

  ///@{
  /**
   * For filters of several processes. CheckInput throws a std::exception with a sentence for the
   * user where the input contradicts itself. Compute fills the outputs, or empties them and returns
   * false with the error, which is empty where somebody stopped the filter.
   */
  static void CheckInput(vtkPolyData* input);
  bool Compute(const Ports& inputs, const Ports& outputs, std::string& error);
  bool IsStopped();
  ///@}

  /// Throws DirectionFields::Stopped where a computation was aborted, or the filter is to stop.
  void ThrowIfStopped(bool wasAborted);
  void Warn(const std::vector<std::string>& warnings);
  /// Says in one line what the outputs are.
  static void Summarize(const std::string& summary, const Ports& outputs);

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  bool Diagnostics = true;

private:
  vtkDirectionFieldAlgorithm(const vtkDirectionFieldAlgorithm&) = delete;
  void operator=(const vtkDirectionFieldAlgorithm&) = delete;
};

#endif
