// SPDX-License-Identifier: GPL-3.0-or-later
// Charts are solved on all cores: each as it is alone, and what the caller hears comes in the caller's thread.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>

#include "base/in_threads.h"
#include "test_meshes.h"

namespace wirewarp::test_charts_at_once {
namespace {

FlattenInput many_gores() { return test::sphere_of_gores(12, 4, 16); }

/// The faces of one piece alone, with the same vertices.
FlattenInput only(const FlattenInput& input, const Piece& piece) {
  FlattenInput result = input;
  result.faces.resize(static_cast<Eigen::Index>(piece.source_face.size()), 3);
  for (std::size_t f = 0; f < piece.source_face.size(); ++f) {
    result.faces.row(static_cast<Eigen::Index>(f)) = input.faces.row(piece.source_face[f]);
  }
  result.seams.resize(0, 2);  // its outline without them
  return result;
}

TEST(ChartsAtOnce, EachIsSolvedAsItIsAlone) {
  const FlattenInput input = many_gores();
  const FlattenResult all = flatten(input);
  ASSERT_EQ(all.pieces.size(), 12U);
  for (const Piece& piece : all.pieces) {
    const FlattenResult alone = flatten(only(input, piece));
    ASSERT_EQ(alone.pieces.size(), 1U);
    EXPECT_EQ(alone.pieces[0].report.objective, piece.report.objective);  // bit for bit
    EXPECT_EQ(alone.pieces[0].report.factorizations, piece.report.factorizations);
  }
}

/// Told in the caller's thread alone, from 0 to 1, and never less than before. Returns what flatten() does.
FlattenResult expect_progress(const FlattenInput& input, Method method) {
  Options options;
  options.method = method;
  const std::thread::id caller = std::this_thread::get_id();
  std::vector<double> fractions;
  bool elsewhere = false;
  FlattenResult result = flatten(input, options, [&](const std::string&, double fraction) {
    elsewhere = elsewhere || std::this_thread::get_id() != caller;
    fractions.push_back(fraction);
    return true;
  });
  EXPECT_FALSE(elsewhere);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.front(), 0);
  EXPECT_EQ(fractions.back(), 1);
  return result;
}

TEST(ChartsAtOnce, ProgressIsToldInTheCallersThreadAndNeverFalls) {
  const int n = 4;
  FlattenInput infeasible = test::quarter_sphere(n);  // a net of rigid wires
  infeasible.wires.clear();
  for (int i = 1; i < n; ++i) test::add_wire(infeasible, test::grid_column(n, 2 * n, i));
  for (int j = 1; j < 2 * n; ++j) test::add_wire(infeasible, test::grid_row(n, j));
  for (const Method method : {Method::refined, Method::wirewarp_plus_plus}) {
    expect_progress(many_gores(), method);
    const FlattenResult refused = expect_progress(infeasible, method);
    ASSERT_TRUE(refused.pieces.at(0).error);
    EXPECT_EQ(refused.pieces[0].error->code, ErrorCode::infeasible_lengths);
  }
}

TEST(ChartsAtOnce, CancellingReachesAllThreads) {
  int calls = 0;
  const FlattenResult result = flatten(many_gores(), {}, [&](const std::string&, double) { return ++calls < 2; });
  EXPECT_EQ(calls, 2);
  const auto is_cancelled = [](const Piece& piece) { return piece.error && piece.error->code == ErrorCode::cancelled; };
  // one chart a thread may have been begun, and a chart that is flat by then stays
  const auto begun = static_cast<std::ptrdiff_t>(num_cores());
  EXPECT_GE(std::count_if(result.pieces.begin(), result.pieces.end(), is_cancelled), 12 - begun);
  for (const Piece& piece : result.pieces) {
    EXPECT_TRUE(!piece.error || is_cancelled(piece)) << piece.error->what();
  }
}

TEST(ChartsAtOnce, WhatProgressThrowsArrivesAndEndsTheRun) {
  int calls = 0;
  const auto throwing = [&](const std::string&, double) -> bool {
    if (++calls < 3) return true;
    throw std::runtime_error("no more");
  };
  EXPECT_THROW(flatten(many_gores(), {}, throwing), std::runtime_error);
  EXPECT_EQ(calls, 3);
}

TEST(RunInThreads, DoesEachThingOnce) {
  std::vector<std::atomic<int>> times(1000);
  run_in_threads(times.size(), 8, [&](std::size_t i) { ++times[i]; });
  for (const std::atomic<int>& count : times) EXPECT_EQ(count, 1);
  run_in_threads(0, 8, [](std::size_t) { FAIL(); });
}

TEST(RunInThreads, WhatWorkThrowsArrives) {
  const auto work = [](std::size_t i) {
    if (i == 7) throw std::out_of_range("seven");
  };
  EXPECT_THROW(run_in_threads(100, 2, work), std::out_of_range);
}

}  // namespace
}  // namespace wirewarp::test_charts_at_once
