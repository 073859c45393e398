// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/solve/charts_progress.h"

#include <algorithm>
#include <map>

namespace wirewarp {
namespace {

// The range of a stage, as fractions of the chart's time. The number of steps is unknown, so each step advances by a
// part of the remaining range. All values are rough, because they only affect the progress bar.
struct Span {
  double begin, end;
};

Span span_of(const std::string& stage) {
  static const std::map<std::string, Span> spans{{"wires", {0.0, 0.1}},
                                                 {"interior", {0.1, 0.6}},
                                                 {"lengths", {0.6, 1.0}},
                                                 {"start", {0.0, 0.15}},
                                                 {"shape", {0.15, 1.0}}};
  return spans.at(stage);
}

constexpr double kPerStep = 0.05;  // 14 steps pass half of the range

}  // namespace

ChartsProgress::ChartsProgress(ProgressReport& report, const std::vector<Chart>& charts, double begin, double end)
    : report_(report), begin_(begin), end_(end), share_done_(charts.size(), 0) {
  double num_faces = 0;
  for (const Chart& chart : charts) num_faces += static_cast<double>(chart.source_face.size());
  for (const Chart& chart : charts) {
    part_of_all_.push_back(static_cast<double>(chart.source_face.size()) / num_faces);
  }
}

bool ChartsProgress::go_on(std::size_t chart, const char* stage) {
  {
    const std::lock_guard lock(mutex_);
    const Span span = span_of(stage);
    const double share = share_done_[chart];
    const bool has_begun = span.begin <= share;
    advance(chart, has_begun ? share + kPerStep * std::max(0.0, span.end - share) : span.begin);
    stage_ = stage;
  }
  return std::this_thread::get_id() == caller_ ? report() : !report_.is_cancelled();
}

void ChartsProgress::finish(std::size_t chart) {
  {
    const std::lock_guard lock(mutex_);
    advance(chart, 1);
  }
  if (std::this_thread::get_id() == caller_)
    report();  // reported here, because charts from the cache and failed charts may take no steps
}

bool ChartsProgress::report() {
  std::string stage;
  double done = 0;
  {
    const std::lock_guard lock(mutex_);
    stage = stage_;
    done = std::min(done_, 1.0);
  }
  return report_.go_on(stage, begin_ + (end_ - begin_) * done);
}

/// The caller must have locked mutex_.
void ChartsProgress::advance(std::size_t chart, double share) {
  done_ += part_of_all_[chart] * (share - share_done_[chart]);
  share_done_[chart] = share;
}

}  // namespace wirewarp
