// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that unchanged charts use their shape from the cache. tests/bindings/test_cache.py has more tests.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "base/planar.h"
#include "newton/cache/chart_key.h"
#include "test_meshes.h"
#include "wirewarp/cache.h"

namespace wirewarp::test_reuse {
namespace {

FlattenInput two_domes() {
  FlattenInput input = test::make_grid(16, 8, [](double s, double t) {
    return Eigen::Vector3d(4 * s, 2 * t, 0.3 * std::abs(std::sin(2 * kPi * s)) * std::sin(3 * t));
  });
  test::add_seam(input, test::grid_column(16, 8, 8));
  test::add_wire(input, test::grid_column(16, 8, 4));
  test::add_wire(input, test::grid_column(16, 8, 12), 0.02);
  return input;
}

FlattenInput tube() {
  FlattenInput input = test::cylinder_tube(8, 4, 1, 6);
  test::add_wire(input, test::tube_ring(8, 2));
  return input;
}

std::string key_of(const FlattenInput& input, std::size_t chart) {
  const Charts charts = test::charts_of(input);
  return solution_key({&charts.charts.at(chart)}, {});
}

TEST(SolutionKey, ChangesIfAndOnlyIfInputOfTheShapeChanges) {
  const FlattenInput input = two_domes();
  FlattenInput changed = input;
  EXPECT_EQ(key_of(changed, 0), key_of(input, 0));
  changed.wires[1].tolerance = 0.03;
  EXPECT_EQ(key_of(changed, 0), key_of(input, 0));
  EXPECT_NE(key_of(changed, 1), key_of(input, 1));
  changed = input;
  changed.vertices(0, 2) = std::nextafter(changed.vertices(0, 2), 1);
  EXPECT_NE(key_of(changed, 0), key_of(input, 0));
  EXPECT_EQ(key_of(changed, 1), key_of(input, 1));
  changed = input;
  // Adds a slit, which does not change the faces.
  test::add_seam(changed, {test::grid_row(16, 4)[6], test::grid_row(16, 4)[7]});
  EXPECT_NE(key_of(changed, 0), key_of(input, 0));
  EXPECT_EQ(key_of(changed, 1), key_of(input, 1));
  changed = input;
  std::swap(changed.wires[0], changed.wires[1]);
  EXPECT_EQ(key_of(changed, 0), key_of(input, 0)) << "the number of a wire does not matter";
  changed.faces.row(0) << input.faces(0, 1), input.faces(0, 2), input.faces(0, 0);
  EXPECT_NE(key_of(changed, 0), key_of(input, 0));
}

TEST(SolutionKey, DiffersIfAnyNumberOfTheOptionsDiffers) {
  const FlattenInput input = two_domes();
  const Chart chart = test::chart_of(input);
  const std::vector<std::function<void(Options&)>> changes = {
      [](Options& o) { o.fairness = 0.1; },
      [](Options& o) { o.max_factorizations = 50; },
      [](Options& o) { o.cloth->weft = 0.5; },
      [](Options& o) { o.cloth->warp = 0.5; },
      [](Options& o) { o.cloth->shear = 0.1; },
      [](Options& o) { o.cloth->squeeze = 0.1; },
      [](Options& o) { o.cloth->locking = 0.5; },
      [](Options& o) { o.orientation = Orientation::up; },
      [](Options& o) { o.grain = 0; },
      [](Options& o) { o.grain_angle = 0.5; },
      [](Options& o) {
        o.up = {0, 1, 0};
      },
  };
  std::set<std::string> keys;
  for (unsigned made = 0; made < 1U << changes.size(); ++made) {  // every subset of the changes
    Options options;
    options.cloth.emplace();
    for (std::size_t i = 0; i < changes.size(); ++i) {
      if ((made >> i & 1U) != 0) changes[i](options);
    }
    keys.insert(solution_key({&chart}, options));
  }
  EXPECT_EQ(keys.size(), std::size_t{1} << changes.size());
}

TEST(Cache, ThreadsMayShareIt) {
  const FlattenInput input = two_domes();
  const FlattenResult alone = flatten(input);
  Cache cache;
  flatten(input, {}, {}, &cache);
  std::vector<FlattenResult> results(4);
  std::vector<std::thread> threads;
  for (FlattenResult& result : results) {
    threads.emplace_back([&] {
      for (int i = 0; i < 3; ++i) result = flatten(input, {}, {}, &cache);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const FlattenResult& result : results) {
    EXPECT_EQ(result.reused_pieces, 2);
    EXPECT_EQ(result.corner_uv, alone.corner_uv);
  }
}

TEST(Cache, IsNotChangedByRefusedInput) {
  Cache cache;
  flatten(two_domes(), {}, {}, &cache);
  FlattenInput bad = two_domes();
  bad.wires[0].tolerance = -1;
  EXPECT_THROW(flatten(bad, {}, {}, &cache), FlattenError);
  EXPECT_EQ(cache.size(), 2);
  cache.clear();
  EXPECT_EQ(cache.size(), 0);
}

TEST(Cache, KeepsNothingOfAStoppedSearch) {
  const FlattenInput input = tube();
  int questions = 0;
  const FlattenResult whole = flatten(input, {}, [&](const std::string&, double) { return ++questions > 0; });
  ASSERT_TRUE(whole.pieces.at(0).error);
  ASSERT_FALSE(whole.pieces[0].error->elements.proposed_seams.empty());
  constexpr int kMoments = 50;  // all moments would take 20 s
  for (int moment = 0; moment <= kMoments; ++moment) {
    const int last = (questions - 1) * moment / kMoments;
    Cache cache;
    int asked = 0;
    flatten(
        input, {}, [&](const std::string&, double) { return asked++ < last; }, &cache);
    const FlattenResult again = flatten(input, {}, {}, &cache);
    ASSERT_TRUE(again.pieces.at(0).error) << last;
    EXPECT_EQ(again.pieces[0].error->elements.proposed_seams, whole.pieces[0].error->elements.proposed_seams) << last;
  }
}

}  // namespace
}  // namespace wirewarp::test_reuse
