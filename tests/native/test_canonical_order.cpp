// SPDX-License-Identifier: GPL-3.0-or-later
// The order of a chart's vertices that does not depend on how the input numbers them.
#include <gtest/gtest.h>

#include <cmath>

#include "base/planar.h"
#include "base/work_meter.h"
#include "cuts/propose/canonical_order.h"
#include "test_meshes.h"

namespace wirewarp::test_canonical_order {
namespace {

/// A regular polygon around its center: wherever a walk around it begins, it looks the same.
FlattenInput regular_polygon(int corners) {
  FlattenInput input;
  input.vertices.setZero(corners + 1, 3);
  input.faces.resize(corners, 3);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * kPi * i / corners;
    input.vertices.row(i) << std::cos(angle), std::sin(angle), 0;
    input.faces.row(i) << i, (i + 1) % corners, corners;
  }
  return input;
}

TEST(CanonicalOrder, OfARegularOutlineTakesWorkInProportionToItAndCanBeStopped) {
  const int corners = 60'000;
  const Charts charts = test::charts_of(regular_polygon(corners));
  int asked = 0;
  in_canonical_order(charts.charts.at(0), StopToken([&](const char*) { return ++asked > 0; }));
  EXPECT_GE(asked, 2 * corners / static_cast<int>(WorkMeter::work_per_question));
  EXPECT_LE(asked, 8 * corners / static_cast<int>(WorkMeter::work_per_question));
  EXPECT_THROW(in_canonical_order(charts.charts.at(0), StopToken([](const char*) { return false; })), Stopped);
}

}  // namespace
}  // namespace wirewarp::test_canonical_order
