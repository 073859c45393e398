// SPDX-License-Identifier: GPL-3.0-or-later
// wirewarp.start: flatten() in a thread of its own, which is C++ and never needs the GIL.
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "arguments.h"
#include "bind.h"
#include "errors.h"
#include "running_call.h"
#include "wirewarp/flatten.h"

namespace wirewarp::bindings {
namespace {

/// How often result() lets Python look for Ctrl-C while it waits.
constexpr std::chrono::milliseconds kSignalPeriod(50);

}  // namespace

class Job {
 public:
  /// cache: a Cache or None, kept alive as long as the job.
  Job(FlattenInput input, const Options& options, py::object cache)
      : input_(std::move(input)), options_(options), cache_(std::move(cache)), solved_before_(read_cache(cache_)) {
    // Counted from here on: Python may end before the thread begins.
    thread_ = std::thread([this, running = std::make_unique<RunningWork>()] { run(); });
  }

  /// Cancels what still runs and waits for it. With the GIL.
  ~Job() {
    if (num_forks() != num_forks_) {
      thread_.detach();  // it is not in this process, nor is who waits for it, for whom destroying would wait
      [[maybe_unused]] const auto* const left_alone = ended_.release();
      return;
    }
    cancelled_ = true;
    PyThreadState* const state = PyEval_SaveThread();  // Python goes on meanwhile
    thread_.join();
    PyEval_RestoreThread(state);
  }
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  void cancel() { cancelled_ = true; }

  bool is_done() const {
    check_process();
    const std::lock_guard lock(mutex_);
    return is_done_;
  }

  std::pair<std::string, double> progress() const {
    check_process();
    const std::lock_guard lock(mutex_);
    return {stage_, fraction_};
  }

  /// Waits. Throws what flatten() threw, and what a signal raises in Python, which cancels.
  py::object result() {
    check_process();
    wait();
    if (error_) std::rethrow_exception(error_);
    if (!python_result_) python_result_ = py::cast(std::move(*result_));
    return python_result_;
  }

 private:
  /// A thread, and a mutex that it may hold, are not forked.
  void check_process() const {
    if (num_forks() == num_forks_) return;
    throw std::runtime_error("this job runs in the process that started it, not in one forked from it");
  }

  void run() {
    const auto report = [this](const std::string& stage, double fraction) {
      const std::lock_guard lock(mutex_);
      stage_ = stage;
      fraction_ = fraction;
      return !cancelled_ && !python_is_ending();
    };
    try {
      result_ = flatten(input_, options_, report, solved_before_);
    } catch (...) {
      error_ = std::current_exception();
    }
    {
      const std::lock_guard lock(mutex_);
      is_done_ = true;
    }
    ended_->notify_all();
  }

  void wait() {
    const RunningCall running;
    while (!wait_for(kSignalPeriod)) {
      if (PyErr_CheckSignals() == 0) continue;
      cancel();
      throw py::error_already_set();
    }
  }

  bool wait_for(std::chrono::milliseconds time) {
    const py::gil_scoped_release no_gil;
    std::unique_lock lock(mutex_);
    // By the system's clock: waiting by the steady one needs glibc 2.30.
    return ended_->wait_until(lock, std::chrono::system_clock::now() + time, [this] { return is_done_; });
  }

  const FlattenInput input_;
  const Options options_;
  const py::object cache_;
  Cache* const solved_before_;
  const int num_forks_ = num_forks();
  std::atomic<bool> cancelled_{false};
  mutable std::mutex mutex_;  // of the four below
  std::unique_ptr<std::condition_variable> ended_ = std::make_unique<std::condition_variable>();
  bool is_done_ = false;
  std::string stage_;
  double fraction_ = 0;
  std::optional<FlattenResult> result_;  // this and the next are written before is_done_, and read after it
  std::exception_ptr error_;
  py::object python_result_;
  std::thread thread_;  // last: it uses all of them
};

namespace {

std::unique_ptr<Job> start(const py::object& vertices, const py::object& faces, const py::object& seams,
                           const py::object& wires, const py::object& options, const py::object& cache,
                           const py::object& eases) {
  return std::make_unique<Job>(read_input(vertices, faces, seams, wires, eases), read_options(options), cache);
}

constexpr const char* kJobDoc =
    R"(A run of flatten() in a thread of the core, which goes on while Python does something else.

start() makes one. When nobody holds it any more it is cancelled, and waited for; so it is when Python ends.)";

constexpr const char* kStartDoc =
    R"(Starts flatten() with these arguments and returns a Job at once.

The arrays are copied. Raises FlattenError where an argument has the wrong type; Job.result() raises all else.)";

}  // namespace

void bind_job(py::module_& module) {
  py::class_<Job> job(module, "Job", py::module_local(), kJobDoc);
  job.attr("__module__") = package_name();
  job.def(
      "progress", &Job::progress,
      "(stage, fraction): how far it is, as flatten() tells its callback; ('', 0.0) before it tells the first time.");
  job.def("cancel", &Job::cancel, "Cancels the pieces that are not flat yet, as soon as the core asks.");
  job.def("is_done", &Job::is_done, "Whether result() returns at once.");
  job.def("result", &Job::result,
          "Waits for the FlattenResult and returns it. Raises what flatten() raises; Ctrl-C cancels and is raised.");
  job.def("__repr__", [](const Job& self) { return "Job(" + std::string(self.is_done() ? "done" : "running") + ")"; });
  job.def("__reduce_ex__", [](const Job&, int) -> py::object {
    throw py::type_error("a Job cannot be copied or pickled: its thread runs in this process");
  });
  module.def("start", &start, py::arg("vertices"), py::arg("faces"), py::kw_only(), py::arg("seams") = py::none(),
             py::arg("wires") = py::tuple(), py::arg("options") = py::none(), py::arg("cache") = py::none(),
             py::arg("eases") = py::tuple(), kStartDoc);
}

}  // namespace wirewarp::bindings
