// SPDX-License-Identifier: GPL-3.0-or-later
// The strings that stand for the enums of the public API in Python.
#pragma once

#include <cstddef>
#include <stdexcept>

#include "wirewarp/options.h"
#include "wirewarp/result.h"

namespace wirewarp::bindings {

template <class Enum>
struct Named {
  Enum value;
  const char* name;
};

inline constexpr Named<Method> kMethods[] = {
    {Method::wirewarping, "wirewarping"}, {Method::wirewarp_plus_plus, "wirewarp++"}, {Method::refined, "refined"}};

inline constexpr Named<NodeWeight> kNodeWeights[] = {{NodeWeight::length, "length"}, {NodeWeight::uniform, "uniform"}};

inline constexpr Named<Inner> kInners[] = {{Inner::minimum, "minimum"}, {Inner::least_norm, "least-norm"}};

inline constexpr Named<PieceLayout> kPieceLayouts[] = {{PieceLayout::packed, "packed"}, {PieceLayout::row, "row"}};

inline constexpr Named<Orientation> kOrientations[] = {
    {Orientation::wire, "wire"}, {Orientation::boundary, "boundary"}, {Orientation::up, "up"}};

/// The string of a value that its table holds.
template <class Enum, std::size_t N>
const char* name_of(Enum value, const Named<Enum> (&names)[N]) {
  for (const Named<Enum>& entry : names) {
    if (entry.value == value) return entry.name;
  }
  throw std::logic_error("an option has no name");
}

constexpr const char* name_of(WireKind kind) {
  switch (kind) {
    case WireKind::boundary:
      return "boundary";
    case WireKind::rigid:
      return "rigid";
    case WireKind::elastic:
      return "elastic";
    case WireKind::super_elastic:
      return "super_elastic";
  }
  throw std::logic_error("not a WireKind");
}

constexpr const char* name_of(Termination termination) {
  switch (termination) {
    case Termination::converged:
      return "converged";
    case Termination::stalled:
      return "stalled";
    case Termination::failed:
      return "failed";
    case Termination::cancelled:
      return "cancelled";
    case Termination::measured:
      return "measured";
  }
  throw std::logic_error("not a Termination");
}

}  // namespace wirewarp::bindings
