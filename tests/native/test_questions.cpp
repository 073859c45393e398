// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that after every fixed amount of work, not of time, the caller is asked whether to continue. This holds for any
// size of the input and any number of charts.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "base/work_meter.h"
#include "result/pack_boxes.h"
#include "surface/mesh/overlap.h"
#include "test_meshes.h"
#include "warp/topology/process_topology.h"

namespace wirewarp::test_questions {
namespace {

/// Returns a flat sheet of n by n squares, which seams cut apart.
FlattenInput confetti(int n) {
  FlattenInput input = test::flat_rectangle(n, n, n, n);
  input.seams.resize(2 * n * (n + 1), 2);
  int row = 0;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i < n; ++i) {
      input.seams.row(row++) << i + (n + 1) * j, i + 1 + (n + 1) * j;
      input.seams.row(row++) << j + (n + 1) * i, j + (n + 1) * (i + 1);
    }
  }
  return input;
}

std::map<std::string, int> questions(const FlattenInput& input) {
  std::map<std::string, int> asked;
  flatten(input, {}, [&](const std::string& stage, double) {
    ++asked[stage];
    return true;
  });
  return asked;
}

/// Counts polls, and answers no from poll number `limit` on.
struct Asked {
  int times = 0;
  StopToken stop{[this](const char*) { return ++times < limit; }};
  int limit = 1'000'000;
};

TEST(Questions, AreAskedAtLeastInProportionToTheFaces) {
  const int few = 40, many = 110;
  const std::map<std::string, int> before = questions(confetti(few)), after = questions(confetti(many));
  const int faces = 2 * many * many;
  EXPECT_GE(after.at("charts"), faces / static_cast<int>(WorkMeter::work_per_question));
  EXPECT_GE(after.at("measure"), 2 * faces / static_cast<int>(WorkMeter::work_per_question));
  EXPECT_GE(after.at("start"), 1);
  EXPECT_GE(before.at("charts"), 1);
}

TEST(Questions, ARefusalEndsARunOfManyChartsInAnyStage) {
  const FlattenInput input = confetti(100);
  for (const std::string last : {"charts", "start", "measure"}) {
    int asked_after = 0;
    bool is_over = false;
    const FlattenResult result = flatten(input, {}, [&](const std::string& stage, double) {
      asked_after += is_over;
      is_over = is_over || stage == last;
      return !is_over;
    });
    EXPECT_EQ(asked_after, 0) << last;
    ASSERT_EQ(result.pieces.size(), 10'000U) << last;
    EXPECT_EQ(result.pieces.back().error.value().code, ErrorCode::cancelled) << last;
    EXPECT_EQ(result.pieces.back().source_vertex.size(), 4U) << last;
    EXPECT_EQ(result.pieces.back().report.termination, Termination::cancelled) << last;
  }
}

TEST(Questions, AreAskedAmongOverlapsOfACrumpledPiece) {
  const int n = 800;  // number of triangles, which all overlap: 320,000 pairs
  Triangles faces(n, 3);
  Positions2 uv(3 * n, 2);
  for (int f = 0; f < n; ++f) {
    faces.row(f) << 3 * f, 3 * f + 1, 3 * f + 2;
    uv.middleRows(3 * f, 3) << 0, 0, 1, 0, 0, 1 + 1e-3 * f;
  }
  Asked asked;
  find_overlapping_faces(faces, std::vector<bool>(n, true), uv, kRelativeOverlapDepth, asked.stop);
  EXPECT_GE(asked.times, n * (n / 2) / static_cast<int>(WorkMeter::work_per_question));
  Asked refused;
  refused.limit = 3;
  EXPECT_THROW(find_overlapping_faces(faces, std::vector<bool>(n, true), uv, kRelativeOverlapDepth, refused.stop),
               Stopped);
  EXPECT_EQ(refused.times, 3);
}

TEST(Questions, AreAskedWhileBoxesArePacked) {
  Positions2 sizes(3000, 2);
  for (int i = 0; i < sizes.rows(); ++i) sizes.row(i) << 1 + (i * 37) % 101, 1 + (i * 53) % 97;
  Asked asked;
  pack_boxes(sizes, 0.1, asked.stop);
  EXPECT_GE(asked.times, 16 * sizes.rows() / static_cast<int>(WorkMeter::work_per_question));
}

TEST(Questions, AreAskedWhileWiresAreExtended) {
  const int n = 41, num_wires = 30;
  FlattenInput input = test::flat_rectangle(n - 1, n - 1, 1, 1);
  // Each wire is one edge far from the other wires, so at least one of its ends is extended.
  for (int i = 0; i < num_wires; ++i) {
    const int v = 3 + 6 * (i % 6) + n * (3 + 7 * (i / 6));
    test::add_wire(input, {v, v + n});
  }
  const Chart chart = test::chart_of(input);
  Asked asked;
  EXPECT_TRUE(process_topology(chart, asked.stop));
  EXPECT_GE(asked.times, num_wires * n * n / static_cast<int>(WorkMeter::work_per_question));
  Asked refused;
  refused.limit = 2;
  EXPECT_THROW(process_topology(chart, refused.stop), Stopped);
  EXPECT_EQ(refused.times, 2);
}

TEST(Questions, ARefusalOfTheFirstQuestionCancels) {
  const FlattenResult result = flatten(test::quarter_sphere(4), {}, [](const std::string&, double) { return false; });
  ASSERT_TRUE(result.pieces[0].error.has_value());
  EXPECT_EQ(result.pieces[0].error->code, ErrorCode::cancelled);
  EXPECT_EQ(result.pieces[0].report.termination, Termination::cancelled);
}

TEST(Questions, TheLastStageOfASmallRunIsNotCanceled) {
  bool was_cancelled = false;
  const FlattenResult result = flatten(test::quarter_sphere(4), {}, [&](const std::string& stage, double) {
    was_cancelled = was_cancelled || stage == "measure";
    return stage != "measure";
  });
  EXPECT_TRUE(was_cancelled);
  EXPECT_FALSE(result.pieces[0].error.has_value());
  EXPECT_TRUE(result.corner_uv.allFinite());
}

}  // namespace
}  // namespace wirewarp::test_questions
