// SPDX-License-Identifier: GPL-3.0-or-later
// Binds wirewarp.Cache, which keeps solved pieces for the next run.
#include "wirewarp/cache.h"

#include "bind.h"
#include "docs.h"
#include "errors.h"

namespace wirewarp::bindings {

void bind_cache(py::module_& module) {
  py::class_<Cache> cache(module, "Cache", py::module_local(), doc_of("Cache"));
  cache.attr("__module__") = package_name();
  cache.def(py::init<>());
  cache.def_property_readonly("size", &Cache::size, "Number of pieces in the cache.");
  cache.def("clear", &Cache::clear, "Removes all pieces.");
  cache.def("__reduce_ex__", [](const Cache&, int) -> py::object {
    throw py::type_error("a Cache cannot be copied or pickled: make a new Cache in each process");
  });
  cache.def("__repr__", [](const Cache& self) { return "Cache(size=" + std::to_string(self.size()) + ")"; });
}

}  // namespace wirewarp::bindings
