// SPDX-License-Identifier: GPL-3.0-or-later
// Binds wirewarp.Job, and wirewarp.start, which runs flatten() as a job.
#include "job.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "arguments.h"
#include "bind.h"
#include "errors.h"

namespace wirewarp::bindings {
namespace {

/// Interval at which result() lets Python handle Ctrl-C while it waits. Nobody notices a delay of 50 ms.
constexpr std::chrono::milliseconds kSignalPeriod(50);

}  // namespace

Job::Job(Work work, py::object used) : work_(std::move(work)), used_(std::move(used)) {
  // The work is registered in this thread, because Python may end before the new thread starts.
  thread_ = std::thread([this, running = std::make_unique<RunningWork>()] { run(); });
}

Job::~Job() {
  if (num_forks() != num_forks_) {
    thread_.detach();  // the thread does not exist in this forked process, so its end cannot be waited for
    [[maybe_unused]] const auto* const left_alone = ended_.release();
    return;
  }
  cancelled_ = true;
  PyThreadState* const state = PyEval_SaveThread();  // Python continues while this thread waits
  thread_.join();
  PyEval_RestoreThread(state);
}

bool Job::is_done() const {
  check_process();
  const std::lock_guard lock(mutex_);
  return is_done_;
}

std::pair<std::string, double> Job::progress() const {
  check_process();
  const std::lock_guard lock(mutex_);
  return {stage_, fraction_};
}

py::object Job::result() {
  check_process();
  wait();
  if (error_) std::rethrow_exception(error_);
  if (!python_result_) python_result_ = make_result_();
  return python_result_;
}

/// Throws in a forked process, because neither threads nor their mutexes survive a fork.
void Job::check_process() const {
  if (num_forks() == num_forks_) return;
  throw std::runtime_error("this job runs in the process that started it, not in one forked from it");
}

void Job::run() {
  const auto report = [this](const std::string& stage, double fraction) {
    const std::lock_guard lock(mutex_);
    stage_ = stage;
    fraction_ = fraction;
    return !cancelled_ && !python_is_ending();
  };
  try {
    make_result_ = work_(report);
  } catch (...) {
    error_ = std::current_exception();
  }
  {
    const std::lock_guard lock(mutex_);
    is_done_ = true;
  }
  ended_->notify_all();
}

void Job::wait() {
  const RunningCall running;
  while (!wait_for(kSignalPeriod)) {
    if (PyErr_CheckSignals() == 0) continue;
    cancel();
    throw py::error_already_set();
  }
}

bool Job::wait_for(std::chrono::milliseconds time) {
  const py::gil_scoped_release no_gil;
  std::unique_lock lock(mutex_);
  // Waits by the system clock, because waiting by the steady clock needs glibc 2.30.
  return ended_->wait_until(lock, std::chrono::system_clock::now() + time, [this] { return is_done_; });
}

namespace {

std::unique_ptr<Job> start(const py::object& vertices, const py::object& faces, const py::object& seams,
                           const py::object& wires, const py::object& options, const py::object& cache,
                           const py::object& eases) {
  auto find = [input = read_input(vertices, faces, seams, wires, eases), checked_options = read_options(options),
               solved_before = read_cache(cache)](const Progress& progress) {
    return flatten(input, checked_options, progress, solved_before);
  };
  return std::make_unique<Job>(work_that(std::move(find)), cache);
}

constexpr const char* kJobDoc =
    R"(A run of the core in its own thread, while Python continues.

start(), start_darts(), start_seams(), start_plan() and start_simplify() return a Job. If the last reference to a job is
deleted, or if Python ends, the job is canceled, and Python waits for its end.)";

constexpr const char* kStartDoc =
    R"(Starts flatten() with these arguments and returns a Job immediately.

The arrays are copied. Raises FlattenError if an argument has the wrong type; Job.result() raises all other errors.)";

}  // namespace

void bind_job(py::module_& module) {
  py::class_<Job> job(module, "Job", py::module_local(), kJobDoc);
  job.attr("__module__") = package_name();
  job.def("progress", &Job::progress,
          "Returns (stage, fraction), the last progress that the run reported; ('', 0.0) before the first report.");
  job.def("cancel", &Job::cancel, "Cancels unfinished work as soon as the core checks for cancellation.");
  job.def("is_done", &Job::is_done, "Returns whether result() would return immediately.");
  job.def("result", &Job::result,
          "Waits for the result and returns it. Raises the exception of the run. Ctrl-C cancels the run and raises "
          "KeyboardInterrupt.");
  job.def("__repr__", [](const Job& self) { return "Job(" + std::string(self.is_done() ? "done" : "running") + ")"; });
  job.def("__reduce_ex__", [](const Job&, int) -> py::object {
    throw py::type_error("a Job cannot be copied or pickled: its thread runs in this process");
  });
  module.def("start", &start, py::call_guard<RunningCall>(), py::arg("vertices"), py::arg("faces"), py::kw_only(),
             py::arg("seams") = py::none(), py::arg("wires") = py::tuple(), py::arg("options") = py::none(),
             py::arg("cache") = py::none(), py::arg("eases") = py::tuple(), kStartDoc);
}

}  // namespace wirewarp::bindings
