// SPDX-License-Identifier: GPL-3.0-or-later
#include "running_call.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace wirewarp::bindings {
namespace {

struct RunningCalls {
  std::mutex mutex;
  std::condition_variable one_ended;
  int count = 0;
  int num_forks = 0;
  std::atomic<bool> python_is_ending{false};
  std::thread::id ending_thread;  // set while the GIL is held, before python_is_ending
};

/// Returns an object that is never destroyed, because threads may outlive static objects.
RunningCalls& running_calls() {
  static RunningCalls& calls = *new RunningCalls;
  return calls;
}

void wait_for_running_calls() {
  RunningCalls& calls = running_calls();
  calls.ending_thread = std::this_thread::get_id();
  calls.python_is_ending = true;
  const py::gil_scoped_release no_gil;
  std::unique_lock lock(calls.mutex);
  calls.one_ended.wait(lock, [&] { return calls.count == 0; });
}

void begin_work() {
  RunningCalls& calls = running_calls();
  const std::lock_guard lock(calls.mutex);
  ++calls.count;
}

void end_work() {
  RunningCalls& calls = running_calls();
  {
    const std::lock_guard lock(calls.mutex);
    --calls.count;
  }
  calls.one_ended.notify_all();
}

/// Resets the calls in a forked child, in which only the forking thread continues.
void forget_threads_of_parent() {
  RunningCalls& calls = running_calls();
  calls.count = 0;
  ++calls.num_forks;
  calls.mutex.unlock();
}

/// Number of nested calls in this thread: a call may run Python code that calls the module again. The end of Python
/// waits for the outermost call, so an inner call must return.
thread_local int depth_of_calls = 0;

/// If Python is ending, sleeps until the process ends, as Python 3.14 does with its daemon threads.
void stay_if_python_is_ending() {
  if (!python_is_ending()) return;
  PyEval_SaveThread();
  while (true) std::this_thread::sleep_for(std::chrono::hours(1));
}

}  // namespace

RunningWork::RunningWork() { begin_work(); }

RunningWork::~RunningWork() { end_work(); }

RunningCall::RunningCall() {
  if (depth_of_calls == 0) stay_if_python_is_ending();
  ++depth_of_calls;
  begin_work();
}

RunningCall::~RunningCall() {
  end_work();
  if (--depth_of_calls == 0) stay_if_python_is_ending();
}

bool python_is_ending() {
  const RunningCalls& calls = running_calls();
  return calls.python_is_ending && calls.ending_thread != std::this_thread::get_id();
}

int num_forks() { return running_calls().num_forks; }

void bind_running_calls() {
  py::module_::import("atexit").attr("register")(py::cpp_function(&wait_for_running_calls));
  const py::module_ os = py::module_::import("os");
  if (!py::hasattr(os, "register_at_fork")) return;
  os.attr("register_at_fork")(py::arg("before") = py::cpp_function([] { running_calls().mutex.lock(); }),
                              py::arg("after_in_parent") = py::cpp_function([] { running_calls().mutex.unlock(); }),
                              py::arg("after_in_child") = py::cpp_function(&forget_threads_of_parent));
}

}  // namespace wirewarp::bindings
