// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that a run makes no factorization and no substitution after it is canceled.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "count_fronts.h"
#include "energy/free_boundary_arap.h"
#include "flatten.h"
#include "newton/minimize.h"
#include "newton/starts.h"
#include "test_meshes.h"

namespace wirewarp::test_cancelling {
namespace {

/// The largest numbers of fronts visited between two polls of the caller.
struct WorkBetweenQuestions {
  void answer() {
    const FrontCounts now = count_fronts();
    factored = std::max(factored, now.factored - last.factored);
    substituted = std::max(substituted, now.substituted_forward - last.substituted_forward);
    last = now;
  }
  FrontCounts last = count_fronts();
  long factored = 0, substituted = 0;
};

/// Returns the number of fronts of one Newton system.
long fronts_of(const FlattenInput& input) {
  const Chart chart = test::chart_of(input);
  const Positions2 start = free_boundary_arap(chart, kFreeSteps).uv;
  const long before = count_fronts().factored;
  Budget one(1);
  minimize({chart, 0.1}, {}, {start}, {one});
  return count_fronts().factored - before;
}

TEST(Cancelling, EndsARunAtOnceInEveryStage) {
  for (const double tolerance : {0.0, 1e-4}) {
    const FlattenInput input = test::saddle_of_wires(3, tolerance);
    const long fronts = fronts_of(input);
    // The search for tolerances makes all wires elastic, which takes two substitutions for each wire.
    const auto num_wires = static_cast<long>(input.wires.size());
    for (const Method method : {Method::refined, Method::wirewarp_plus_plus}) {
      Options options;
      options.method = method;
      WorkBetweenQuestions whole;
      int questions = 0;
      const FlattenResult refused = flatten(input, options, [&](const std::string& stage, double) {
        whole.answer();
        questions += stage != "measure";
        return true;
      });
      ASSERT_TRUE(refused.pieces.at(0).error);
      EXPECT_EQ(refused.pieces[0].error->code, ErrorCode::infeasible_lengths);
      EXPECT_LE(whole.factored, 3 * fronts) << "for the embedding in a circle, and for the free shape";
      EXPECT_LE(whole.substituted, (35 + 2 * num_wires) * fronts)
          << "for steps to exact lengths, and two for each wire";
      for (int last = 0; last < questions; last += 1 + questions / 20) {
        int asked = 0;
        WorkBetweenQuestions after;
        const FlattenResult result = flatten(input, options, [&](const std::string&, double) {
          after = {};
          return asked++ < last;
        });
        after.answer();
        EXPECT_EQ(asked, last + 1);
        ASSERT_TRUE(result.pieces.at(0).error);
        EXPECT_EQ(result.pieces[0].error->code, ErrorCode::cancelled) << last;
        EXPECT_EQ(after.factored, 0) << last;
        EXPECT_EQ(after.substituted, 0) << last;
      }
    }
  }
}

}  // namespace
}  // namespace wirewarp::test_cancelling
