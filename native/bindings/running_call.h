// SPDX-License-Identifier: GPL-3.0-or-later
// Python may end while another thread is in the core, which has let go of the GIL: such a thread would be unwound when
// it asks for the GIL again, which C++ does not survive. So the end of Python cancels these calls and waits for them.
// Their threads, which are daemons by then, do not return to Python: what they print there, Python 3.11 aborts on.
#pragma once

#include <pybind11/pybind11.h>

namespace wirewarp::bindings {

namespace py = pybind11;

/// Work that the end of Python cancels and waits for, in a thread that does not need the GIL.
class RunningWork {
 public:
  RunningWork();
  ~RunningWork();
  RunningWork(const RunningWork&) = delete;
  RunningWork& operator=(const RunningWork&) = delete;
};

/// A call that lets go of the GIL, from before until it holds it again. Made and ended with the GIL.
class RunningCall {
 public:
  /// Does not return to a daemon thread once Python is ending.
  RunningCall();
  /// The same.
  ~RunningCall();
  RunningCall(const RunningCall&) = delete;
  RunningCall& operator=(const RunningCall&) = delete;
};

/// Another thread ends Python and waits for the calls of this one: they are to end, without the GIL where they can.
bool python_is_ending();

/// How many forks lie between the process that loaded the module and this one. Threads are not forked.
int num_forks();

/// Lets the end of Python wait for the running calls.
void bind_running_calls();

}  // namespace wirewarp::bindings
