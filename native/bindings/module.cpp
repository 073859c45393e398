// SPDX-License-Identifier: GPL-3.0-or-later
// The Python module wirewarp._wirewarp: one layer over the public headers.
#include "bind.h"
#include "errors.h"
#include "running_call.h"

PYBIND11_MODULE(in_main_interpreter, module) {
  using namespace wirewarp::bindings;
  module.doc() = "The compiled part of wirewarp. Import the package instead.";
  module.attr("__version__") = WIREWARP_VERSION;
  bind_errors(module);
  bind_cloth(module);
  bind_options(module);
  bind_wire(module);
  bind_ease(module);
  bind_results(module);
  bind_cache(module);
  bind_flatten(module);
  bind_job(module);
  bind_cut_mesh(module);
  bind_propose(module);
  bind_straighten(module);
  bind_running_calls();
}

/// Refuses subinterpreters. In a subinterpreter, pybind11 would wait forever for the GIL of the main interpreter, which
/// the caller holds.
PYBIND11_PLUGIN_IMPL(_wirewarp) {
  if (PyInterpreterState_Get() != PyInterpreterState_Main()) {
    PyErr_SetString(PyExc_ImportError, "wirewarp works in the main interpreter alone, not in a subinterpreter");
    return nullptr;
  }
  return PyInit_in_main_interpreter();
}
