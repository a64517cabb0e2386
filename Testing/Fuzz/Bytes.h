// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_Bytes_h
#define DirectionFields_Bytes_h

#include "Types.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

/// Bytes of an input; zeros where it ends.
class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size)
    : Data(data)
    , Size(size)
  {
  }

  bool AtEnd() const { return this->Next >= this->Size; }
  void Skip(std::size_t position) { this->Next = position; }
  unsigned At(std::size_t i) const { return i < this->Size ? this->Data[i] : 0; }
  unsigned Take() { return this->At(this->Next++); }

private:
  const std::uint8_t* Data;
  std::size_t Size;
  std::size_t Next = 0;
};

/// Numbers that break computations.
inline double Special(unsigned byte)
{
  using Limits = std::numeric_limits<double>;
  constexpr double values[] = { Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(),
    Limits::max(), -Limits::max(), Limits::min(), Limits::denorm_min(), 1e300, -1e200, 1e155, 1e100,
    1e-100, 1e-155, 1e30, 1e9, -1e-9 };
  return values[byte % 16];
}

/// Bytes from here on stand for values that no option may have.
constexpr unsigned FirstInvalid = 250;

/// 0 is the default, the next go through the range, the last are out of it or nearly so.
inline double Real(unsigned byte, double standard, double least, double most)
{
  if (byte >= FirstInvalid)
  {
    const double values[] = { least - 1e-9, most + 1e-9, Special(0), Special(1), Special(2),
      Special(3) };
    return values[byte - FirstInvalid];
  }
  return byte == 0 ? standard : least + (most - least) * (byte - 1) / (FirstInvalid - 2);
}

inline int Whole(unsigned byte, int standard, int least, int most)
{
  if (byte >= FirstInvalid)
  {
    const int values[] = { least - 1, most + 1, std::numeric_limits<int>::min(),
      std::numeric_limits<int>::max(), least, most };
    return values[byte - FirstInvalid];
  }
  return byte == 0 ? standard : least + static_cast<int>(byte - 1) % (most - least + 1);
}

/// Mostly small numbers, so that points meet.
inline double ReadNumber(Bytes& bytes)
{
  const unsigned byte = bytes.Take();
  if (byte < 240)
  {
    return (static_cast<int>(byte) - 120) / 16.0;
  }
  return byte < 248 ? Special(bytes.Take()) : (bytes.Take() - 128.0) * std::pow(4.0, byte - 256.0);
}

inline DirectionFields::Vector3 ReadVector(Bytes& bytes)
{
  const double x = ReadNumber(bytes);
  const double y = ReadNumber(bytes);
  return { x, y, ReadNumber(bytes) };
}

#endif
