// SPDX-License-Identifier: GPL-3.0-or-later
// The key of the cache did not contain which rims are the same edges of the input. So a piece with a hole got the shape
// of another piece with equal geometry whose hole was a slit.
#include <gtest/gtest.h>

#include "test_meshes.h"
#include "wirewarp/cache.h"

namespace wirewarp::cached_slit_sewn_to_another_piece_test {
namespace {

constexpr int kQuads = 8;

int vertex(int i, int j) { return i + (kQuads + 1) * j; }

FlattenInput dome() {
  return test::make_grid(kQuads, kQuads, [](double s, double t) {
    const double x = 2 * s - 1, y = 2 * t - 1;
    return Eigen::Vector3d(x, y, 0.5 * (1 - x * x) * (1 - y * y));
  });
}

FlattenInput with_slit() {
  FlattenInput input = dome();
  test::add_seam(input, test::grid_row(kQuads, 4));
  input.seams = input.seams.middleRows(2, 4).eval();  // the seam from the third vertex to the seventh
  return input;
}

/// Returns the mesh with the slit cut open: its inner vertices are doubled, as in flatten(). The lower rim is
/// sewn to a third piece.
FlattenInput with_sewn_hole() {
  const FlattenInput whole = dome();
  FlattenInput input;
  const auto is_doubled = [](int v) { return v > vertex(2, 4) && v < vertex(6, 4); };
  std::vector<int> number;  // number of the first copy of each vertex
  int count = 0;
  for (int v = 0; v < whole.vertices.rows(); ++v) {
    number.push_back(count);
    count += is_doubled(v) ? 2 : 1;
  }
  const int tip_of_flap = count;
  input.vertices.resize(count + 1, 3);
  for (int v = 0; v < whole.vertices.rows(); ++v) {
    input.vertices.row(number[v]) = whole.vertices.row(v);
    if (is_doubled(v)) input.vertices.row(number[v] + 1) = whole.vertices.row(v);
  }
  input.vertices.row(tip_of_flap) << 0, 0, 2;
  input.faces = whole.faces.unaryExpr([&](int v) { return number[v]; });
  const int first_above = 2 * kQuads * 4;  // index of the first face beyond the middle row
  for (int f = first_above; f < input.faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) input.faces(f, k) += is_doubled(whole.faces(f, k)) ? 1 : 0;
  }
  const Eigen::Index num_faces = input.faces.rows();
  input.faces.conservativeResize(num_faces + 4, 3);
  for (int i = 0; i < 4; ++i) {
    const int a = number[vertex(2 + i, 4)], b = number[vertex(3 + i, 4)];
    input.faces.row(num_faces + i) << a, b, tip_of_flap;
    test::add_seam(input, {a, b});
  }
  return input;
}

TEST(Bugs, ACachedSlitIsNotReusedForAHoleOfTheSameGeometry) {
  const FlattenInput sewn = with_sewn_hole();
  const FlattenResult alone = flatten(sewn);
  Cache cache;
  flatten(with_slit(), {}, {}, &cache);
  const FlattenResult cached = flatten(sewn, {}, {}, &cache);
  EXPECT_EQ(cached.reused_pieces, 0);
  EXPECT_TRUE(cached.corner_uv == alone.corner_uv);
}

}  // namespace
}  // namespace wirewarp::cached_slit_sewn_to_another_piece_test
