// SPDX-License-Identifier: GPL-3.0-or-later
// Handles calls that run in the core, without the GIL, while Python ends in another thread. Python would unwind such a
// thread when it asks for the GIL again, which C++ does not survive. So the end of Python cancels these calls and waits
// for them. Their threads, which are daemon threads by then, do not return to Python: Python 3.11 aborts if they print.
#pragma once

#include <pybind11/pybind11.h>

namespace wirewarp::bindings {

namespace py = pybind11;

/// Work in a thread that does not need the GIL. The end of Python cancels it and waits for it.
class RunningWork {
 public:
  RunningWork();
  ~RunningWork();
  RunningWork(const RunningWork&) = delete;
  RunningWork& operator=(const RunningWork&) = delete;
};

/// A call that releases the GIL itself, or whose arguments may release it while they are read, as numpy and __array__()
/// may. Functions and constructors have it as their py::call_guard. Its constructor and its destructor need the GIL.
class RunningCall {
 public:
  /// Does not return in a daemon thread once Python is ending.
  RunningCall();
  /// Does not return in a daemon thread once Python is ending.
  ~RunningCall();
  RunningCall(const RunningCall&) = delete;
  RunningCall& operator=(const RunningCall&) = delete;
};

/// Whether another thread is ending Python and waits for the calls of this thread. These calls should end, if possible
/// without the GIL.
bool python_is_ending();

/// Returns the number of forks between the process that loaded the module and this one. A fork does not copy threads.
int num_forks();

/// Makes the end of Python wait for the running calls.
void bind_running_calls();

}  // namespace wirewarp::bindings
