// SPDX-License-Identifier: GPL-3.0-or-later
// Adapts a Python progress callback to the core's Progress. The adapter takes the GIL for each call. If the callback
// raises an exception, the adapter keeps it and cancels the core's work. After the core has returned, rethrow() raises
// this exception.
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

  /// Returns false to cancel the work. This happens if the callback returns a false value other than None, or if Python
  /// raises an exception. Ctrl-C raises an exception, too.
  bool report(const std::string& stage, double fraction);

  /// Raises the exception that Python raised during the run, if any. Needs the GIL.
  void rethrow() const;

 private:
  py::object callback_;
  std::exception_ptr raised_;
};

}  // namespace wirewarp::bindings
