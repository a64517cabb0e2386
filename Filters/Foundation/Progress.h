// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Progress_h
#define DirectionFields_Progress_h

#include <algorithm>
#include <functional>

namespace DirectionFields
{
/// Called with the fraction done, 0 to 1; false stops the computation.
using ProgressFunction = std::function<bool(double)>;

/// Progress throws this where the caller's function has said false. The public entries catch it.
struct Stopped
{
};

/// How a computation tells its caller how far it is, and learns that it is to stop. A part of a
/// computation gets a part of the range: it reports 0 to 1 and knows nothing of the rest.
class Progress
{
public:
  /// Nobody listens: nothing is reported and nothing stops.
  Progress() = default;
  /// @param function must outlive this object and all its parts; an empty one never stops
  explicit Progress(const ProgressFunction& function)
    : Function(&function)
  {
  }

  /// The part of this range from one fraction to another.
  Progress Part(double begin, double end) const
  {
    Progress part = *this;
    part.Begin = this->At(begin);
    part.End = this->At(end);
    part.Done = part.Begin;
    return part;
  }

  /// Reports the fraction done. Throws Stopped.
  void Report(double fraction) const
  {
    this->Done = this->At(fraction);
    this->RequireToGoOn();
  }

  /// Asks whether to go on without having got further. Throws Stopped.
  void RequireToGoOn() const
  {
    if (this->Listens() && !(*this->Function)(this->Done))
    {
      throw Stopped();
    }
  }

  /// Whether somebody could stop the computation.
  bool Listens() const { return this->Function != nullptr && *this->Function; }

private:
  double At(double fraction) const
  {
    return this->Begin + std::clamp(fraction, 0.0, 1.0) * (this->End - this->Begin);
  }

  const ProgressFunction* Function = nullptr;
  double Begin = 0.0;
  double End = 1.0;
  mutable double Done = 0.0;
};
}

#endif
