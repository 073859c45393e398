// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress.h"

#include <utility>

#include "arrays.h"
#include "running_call.h"
#include "wirewarp/error.h"

namespace wirewarp::bindings {

PythonProgress::PythonProgress(py::object callback) : callback_(std::move(callback)) {
  if (!callback_.is_none() && PyCallable_Check(callback_.ptr()) == 0) {
    throw wrong_type("progress", "a function of a stage and a fraction", type_name(callback_));
  }
}

bool PythonProgress::report(const std::string& stage, double fraction) {
  if (python_is_ending()) return false;
  const py::gil_scoped_acquire gil;
  if (raised_) return false;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (callback_.is_none()) return true;
    const py::object answer = callback_(stage, fraction);
    if (answer.is_none()) return true;  // The callback only shows progress.
    return static_cast<bool>(py::bool_(answer));
  } catch (const py::error_already_set&) {
    raised_ = std::current_exception();
    return false;
  }
}

void PythonProgress::rethrow() const {
  if (raised_) std::rethrow_exception(raised_);
}

}  // namespace wirewarp::bindings
