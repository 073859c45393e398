// SPDX-License-Identifier: GPL-3.0-or-later
// Handles calls that run in the core, without the GIL, while Python ends in another thread. When the thread of such a
// call asks for the GIL again, Python would unwind the thread, which C++ does not survive. Therefore, the end of Python
// cancels these calls and waits for them. Their threads are daemon threads by then. They do not return to Python,
// because Python 3.11 aborts if they print.
#pragma once

#include <pybind11/pybind11.h>

namespace wirewarp::bindings {

namespace py = pybind11;

/// Work in a thread that does not need the GIL. The end of Python cancels this work and waits for its end.
class RunningWork {
 public:
  RunningWork();
  ~RunningWork();
  RunningWork(const RunningWork&) = delete;
  RunningWork& operator=(const RunningWork&) = delete;
};

/// A call during which the GIL may be released, even while arguments are read. Functions and constructors of the module
/// use this class as their py::call_guard. Its constructor and destructor need the GIL.
class RunningCall {
 public:
  /// Does not return in a daemon thread once Python is ending.
  RunningCall();
  /// Does not return in a daemon thread once Python is ending.
  ~RunningCall();
  RunningCall(const RunningCall&) = delete;
  RunningCall& operator=(const RunningCall&) = delete;
};

/// Returns true if another thread is ending Python, and therefore waits for the calls of this thread. These calls
/// should then end, if possible without the GIL.
bool python_is_ending();

/// Returns the number of forks between the process that loaded the module and this process. After a fork, the new
/// process has none of the earlier threads.
int num_forks();

/// Makes the end of Python wait for the running calls.
void bind_running_calls();

}  // namespace wirewarp::bindings
