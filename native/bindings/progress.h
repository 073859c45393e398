// SPDX-License-Identifier: GPL-3.0-or-later
// A Python progress callback behind the core's Progress: takes the GIL for the call and carries what Python raises
// past the core, which only hears "cancel".
#pragma once

#include <pybind11/pybind11.h>

#include <exception>
#include <string>

namespace wirewarp::bindings {

namespace py = pybind11;

class PythonProgress {
 public:
  /// callback: callable(stage, fraction) or None. Throws invalid_type.
  explicit PythonProgress(py::object callback);

  /// False cancels: the callback returned something false other than None, or Python raised (Ctrl-C too).
  bool report(const std::string& stage, double fraction);

  /// Raises what Python raised during the run, if it did. Needs the GIL.
  void rethrow() const;

 private:
  py::object callback_;
  std::exception_ptr raised_;
};

}  // namespace wirewarp::bindings
