// SPDX-License-Identifier: GPL-3.0-or-later
// The Python module wirewarp._wirewarp: one layer over the public headers.
#include "bind.h"
#include "errors.h"

PYBIND11_MODULE(_wirewarp, module) {
  using namespace wirewarp::bindings;
  module.doc() = "The compiled part of wirewarp; use the package.";
  module.attr("__version__") = WIREWARP_VERSION;
  bind_errors(module);
  bind_options(module);
  bind_wire(module);
  bind_results(module);
  bind_cache(module);
  bind_flatten(module);
}
