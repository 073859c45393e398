// SPDX-License-Identifier: GPL-3.0-or-later
// The Python strings of the enums of the public API.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

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

inline constexpr Named<Orientation> kOrientations[] = {{Orientation::wire, "wire"},
                                                       {Orientation::boundary, "boundary"},
                                                       {Orientation::up, "up"},
                                                       {Orientation::best, "best"},
                                                       {Orientation::grain, "grain"}};

inline constexpr Named<Surface> kSurfaces[] = {
    {Surface::inside, "inside"}, {Surface::middle, "middle"}, {Surface::outside, "outside"}};

inline constexpr Named<WireKind> kWireKinds[] = {{WireKind::boundary, "boundary"},
                                                 {WireKind::rigid, "rigid"},
                                                 {WireKind::elastic, "elastic"},
                                                 {WireKind::super_elastic, "super_elastic"}};

inline constexpr Named<Termination> kTerminations[] = {{Termination::converged, "converged"},
                                                       {Termination::stalled, "stalled"},
                                                       {Termination::failed, "failed"},
                                                       {Termination::cancelled, "cancelled"},
                                                       {Termination::measured, "measured"}};

template <class Enum, std::size_t N>
const char* name_of(Enum value, const Named<Enum> (&names)[N]) {
  for (const Named<Enum>& entry : names) {
    if (entry.value == value) return entry.name;
  }
  throw std::logic_error("an option has no name");
}

template <class Enum, std::size_t N>
Enum value_of(const std::string& name, const Named<Enum> (&names)[N]) {
  for (const Named<Enum>& entry : names) {
    if (entry.name == name) return entry.value;
  }
  throw std::invalid_argument("'" + name + "' is not a known value");
}

}  // namespace wirewarp::bindings
