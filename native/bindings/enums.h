// SPDX-License-Identifier: GPL-3.0-or-later
// The strings that stand for the enums of the public API in Python.
#pragma once

#include <iterator>

#include "wirewarp/options.h"
#include "wirewarp/result.h"

namespace wirewarp::bindings {

template <class Enum>
struct Named {
  Enum value;
  const char* name;
};

inline constexpr Named<Method> kMethods[] = {{Method::wirewarping, "wirewarping"}};

inline constexpr Named<NodeWeight> kNodeWeights[] = {{NodeWeight::length, "length"}, {NodeWeight::uniform, "uniform"}};

inline constexpr Named<Inner> kInners[] = {{Inner::minimum, "minimum"}, {Inner::least_norm, "least-norm"}};

inline constexpr Named<WireKind> kWireKinds[] = {{WireKind::boundary, "boundary"},
                                                 {WireKind::rigid, "rigid"},
                                                 {WireKind::elastic, "elastic"},
                                                 {WireKind::super_elastic, "super_elastic"}};

inline constexpr Named<Termination> kTerminations[] = {{Termination::converged, "converged"},
                                                       {Termination::failed, "failed"},
                                                       {Termination::cancelled, "cancelled"},
                                                       {Termination::measured, "measured"}};

/// The string of a value; every value of an enum is in its table.
template <class Enum, std::size_t N>
const char* name_of(Enum value, const Named<Enum> (&names)[N]) {
  for (const Named<Enum>& entry : names) {
    if (entry.value == value) return entry.name;
  }
  throw std::logic_error("an enum value has no name");
}

}  // namespace wirewarp::bindings
