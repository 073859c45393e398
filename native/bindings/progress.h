// SPDX-License-Identifier: GPL-3.0-or-later
// Adapts a Python progress callback to the core's Progress: takes the GIL for the call and keeps a Python exception
// until the core, which only sees "cancel", has returned.
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

  /// Returns false to cancel: the callback returned a false value other than None, or Python raised an exception, also
  /// for Ctrl-C.
  bool report(const std::string& stage, double fraction);

  /// Raises the exception that Python raised during the run, if any. Needs the GIL.
  void rethrow() const;

 private:
  py::object callback_;
  std::exception_ptr raised_;
};

}  // namespace wirewarp::bindings
