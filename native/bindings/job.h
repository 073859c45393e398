// SPDX-License-Identifier: GPL-3.0-or-later
// Work of the core in its own thread. The work is pure C++ and never needs the GIL.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "running_call.h"
#include "wirewarp/flatten.h"

namespace wirewarp::bindings {

namespace py = pybind11;

/// Makes the Python object of a job's result. Called with the GIL.
using MakeResult = std::function<py::object()>;

/// The work of a job. It runs without the GIL and owns no Python object.
using Work = std::function<MakeResult(const Progress&)>;

class Job {
 public:
  /// used: Python objects that the work reads, kept alive as long as the job; or None.
  explicit Job(Work work, py::object used = py::none());

  /// Cancels running work and waits for its end. Called with the GIL.
  ~Job();
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  void cancel() { cancelled_ = true; }
  bool is_done() const;
  std::pair<std::string, double> progress() const;

  /// Waits for the result. Throws the exceptions of the work. If a signal raises an exception in Python, cancels the
  /// work and throws this exception.
  py::object result();

 private:
  void check_process() const;
  void run();
  void wait();
  bool wait_for(std::chrono::milliseconds time);

  const Work work_;
  const py::object used_;
  const int num_forks_ = num_forks();
  std::atomic<bool> cancelled_{false};
  mutable std::mutex mutex_;  // guards is_done_, stage_ and fraction_; ended_ waits with mutex_
  std::unique_ptr<std::condition_variable> ended_ = std::make_unique<std::condition_variable>();
  bool is_done_ = false;
  std::string stage_;
  double fraction_ = 0;
  MakeResult make_result_;  // make_result_ and error_ are written before is_done_ is set, and read afterwards
  std::exception_ptr error_;
  py::object python_result_;
  std::thread thread_;  // the last member, because the thread uses all other members
};

/// Returns work whose result is the value that `find` returns. find: called with a Progress.
template <class Find>
Work work_that(Find find) {
  return [find = std::move(find)](const Progress& progress) -> MakeResult {
    const auto found = std::make_shared<decltype(find(progress))>(find(progress));
    return [found] { return py::cast(std::move(*found)); };
  };
}

}  // namespace wirewarp::bindings
