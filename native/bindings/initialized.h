// SPDX-License-Identifier: GPL-3.0-or-later
// cls.__new__(cls) makes an object without a value, for which pybind11 would return uninitialized memory. Here every
// use of such an object except __init__ raises TypeError.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <type_traits>

#include "wirewarp/cache.h"
#include "wirewarp/cut_mesh.h"
#include "wirewarp/flatten.h"
#include "wirewarp/propose.h"

namespace wirewarp::bindings {

class Job;

template <class T>
inline constexpr bool is_bound =
    std::disjunction_v<std::is_same<T, Wire>, std::is_same<T, Cloth>, std::is_same<T, Ease>, std::is_same<T, Options>,
                       std::is_same<T, Cache>, std::is_same<T, Job>, std::is_same<T, WireReport>,
                       std::is_same<T, HelperWire>, std::is_same<T, BoundaryReport>, std::is_same<T, SeamReport>,
                       std::is_same<T, Metrics>, std::is_same<T, PieceReport>, std::is_same<T, Piece>,
                       std::is_same<T, FlattenResult>, std::is_same<T, DartProposal>, std::is_same<T, SeamProposal>,
                       std::is_same<T, SurfacePath>, std::is_same<T, CutSources>>;

}  // namespace wirewarp::bindings

namespace pybind11::detail {

template <class T>
class type_caster<T, std::enable_if_t<wirewarp::bindings::is_bound<T>>> : public type_caster_base<T> {
 public:
  bool load(handle source, bool convert) {
    if (isinstance<T>(source)) {
      auto* const object = reinterpret_cast<instance*>(source.ptr());
      if (object->get_value_and_holder(get_type_info(typeid(T))).value_ptr() == nullptr) {
        throw type_error(std::string(str(type::handle_of(source).attr("__name__"))) + ".__init__() was not called");
      }
    }
    return type_caster_base<T>::load(source, convert);
  }
};

}  // namespace pybind11::detail
