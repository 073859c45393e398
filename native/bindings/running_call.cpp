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
  int count = 0;  // changed with the GIL
  std::atomic<bool> python_is_ending{false};
  std::thread::id ending_thread;  // set with the GIL, before python_is_ending
};

/// Never destroyed: threads may outlive static objects.
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

/// Sleeps until the process ends where Python is ending, as Python 3.14 lets its daemon threads do.
void stay_if_python_is_ending() {
  if (!python_is_ending()) return;
  PyEval_SaveThread();
  while (true) std::this_thread::sleep_for(std::chrono::hours(1));
}

}  // namespace

RunningCall::RunningCall() {
  stay_if_python_is_ending();
  RunningCalls& calls = running_calls();
  const std::lock_guard lock(calls.mutex);
  ++calls.count;
}

RunningCall::~RunningCall() {
  RunningCalls& calls = running_calls();
  {
    const std::lock_guard lock(calls.mutex);
    --calls.count;
  }
  calls.one_ended.notify_all();
  stay_if_python_is_ending();
}

bool python_is_ending() {
  const RunningCalls& calls = running_calls();
  return calls.python_is_ending && calls.ending_thread != std::this_thread::get_id();
}

void bind_running_calls() {
  py::module_::import("atexit").attr("register")(py::cpp_function(&wait_for_running_calls));
  const py::module_ os = py::module_::import("os");
  if (!py::hasattr(os, "register_at_fork")) return;
  // Only the thread that forks goes on in the child.
  os.attr("register_at_fork")(py::arg("after_in_child") = py::cpp_function([] { running_calls().count = 0; }));
}

}  // namespace wirewarp::bindings
