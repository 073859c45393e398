// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of cuts that are suggested for one of several pieces, and of parts of the search for cuts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/planar.h"
#include "base/work_meter.h"
#include "cuts/propose/canonical_order.h"
#include "cuts/propose/cut_sets.h"
#include "cuts/propose/mirror_image.h"
#include "cuts/propose/smooth_paths.h"
#include "disguise.h"
#include "test_meshes.h"
#include "wirewarp/propose.h"

namespace wirewarp::test_cut_search {
namespace {

/// Returns a hill cut into three pieces side by side, with a wire across all three pieces. One side of a seam is longer
/// than the other side.
FlattenInput three_pieces() {
  const int n = 8;
  FlattenInput input = test::hill(n);
  for (const int column : {n / 4, 3 * n / 4}) test::add_seam(input, test::grid_column(n, n, column));
  test::add_wire(input, test::grid_row(n, n / 2), 0.02);
  input.eases.push_back({(VertexPairs(1, 2) << n / 4, n / 4 + n + 1).finished(), 0.05});
  return input;
}

/// Expects that suggested cuts of the middle piece have the energy of a run of the whole model.
void expect_energy_of_the_whole_model(const FlattenInput& input, const Options& options) {
  CutOptions cut_options;
  cut_options.count = 2;
  cut_options.piece = 1;
  const std::vector<int> own = flatten(input, options).pieces[1].source_face;
  for (const auto& propose : {propose_darts, propose_seams}) {
    for (const DartProposal& cut : propose(input, options, cut_options, {})) {
      double energy = 0, area = 0;
      for (const Piece& piece : flatten(test::with_seams(input, cut.edges), options).pieces) {
        if (std::count(own.begin(), own.end(), piece.source_face[0]) == 0) continue;
        EXPECT_FALSE(piece.error);
        energy += (options.cloth ? piece.metrics.cloth_energy : piece.metrics.arap_energy) * piece.metrics.area_3d;
        area += piece.metrics.area_3d;
      }
      EXPECT_NEAR(cut.energy, energy / area, 1e-6 * cut.energy_before);
    }
  }
}

TEST(CutsBesideNeighbors, HaveTheEnergyOfTheWholeModelWithAnElasticSeam) {
  FlattenInput input = three_pieces();
  test::add_wire(input, test::grid_column(8, 8, 2), 0.03);
  expect_energy_of_the_whole_model(input, {});
}

TEST(CutsBesideNeighbors, HaveTheEnergyOfTheWholeModelOfAStretchedFabric) {
  Options options;
  options.cloth.emplace();
  options.cloth->stretch = {0.1, 0.05};
  options.grain = 0;
  expect_energy_of_the_whole_model(three_pieces(), options);
}

TEST(CutsBesideNeighbors, HaveTheEnergyOfTheWholeModelOfThickMaterial) {
  Options options;
  options.thickness = 0.05;
  options.surface = Surface::inside;
  expect_energy_of_the_whole_model(three_pieces(), options);
}

/// Returns a regular polygon with a vertex in its center, so that walks around the outline look the same from every
/// start.
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

TEST(CutSetSearch, PrefersTheShortestSetForEachFabric) {
  std::vector<DartProposal> sets;
  for (const double strain : {0.045, 0.06, 0.09, 0.12, 0.19, 0.3}) sets.emplace_back().strain = strain;
  const auto chosen = [&](int count) {
    CutOptions cut_options;
    cut_options.count = count;
    std::vector<double> strains;
    for (const DartProposal& set : chosen_by_limit(sets, cut_options)) strains.push_back(set.strain);
    return strains;
  };
  EXPECT_EQ(chosen(1), (std::vector{0.045}));
  EXPECT_EQ(chosen(3), (std::vector{0.045, 0.09, 0.19}));
  EXPECT_EQ(chosen(5), (std::vector{0.045, 0.06, 0.09, 0.19, 0.3}));
  EXPECT_EQ(chosen(9), (std::vector{0.045, 0.06, 0.09, 0.12, 0.19, 0.3}));
}

TEST(CutSetSearch, IgnoresRoundingErrorsOfStrains) {
  for (const double limit : {0.05, 0.1, 0.2}) {
    DartProposal set;
    set.strain = limit + 0.5 * kStrainError;
    EXPECT_EQ(limit_of_set(set, {}), limit);
    set.strain = limit + 2 * kStrainError;
    EXPECT_EQ(limit_of_set(set, {}), 2 * limit);
  }
}

TEST(CutSetSearch, AllowsStrainsUpToThatOfPlushOrTwiceTheTarget) {
  using Strains = std::vector<double>;
  EXPECT_EQ(allowed_strains(0.05, 0.05), (Strains{0.05, 0.1, 0.2}));  // 0.2 is the strain of plush
  EXPECT_EQ(allowed_strains(0.15, 0.05), Strains{0.15});              // by ratio, 0.15 is nearer to 0.2 than 0.3 is
  EXPECT_EQ(allowed_strains(0.13, 0.05), (Strains{0.13, 0.26}));      // by ratio, 0.26 is nearer to 0.2 than 0.13 is
  EXPECT_EQ(allowed_strains(0.2, 0.2), (Strains{0.2, 0.4}));          // 0.4 is twice the target
  EXPECT_EQ(allowed_strains(0.01, 0.01), (Strains{0.01, 0.02, 0.04}));
}

TEST(CanonicalOrder, TakesWorkProportionalToARegularOutlineAndCanBeStopped) {
  const int corners = 60'000;
  const Chart chart = test::chart_of(regular_polygon(corners));
  int asked = 0;
  in_canonical_order(chart, StopToken([&](const char*) { return ++asked > 0; }));
  EXPECT_GE(asked, 2 * corners / static_cast<int>(WorkMeter::work_per_question));
  EXPECT_LE(asked, 8 * corners / static_cast<int>(WorkMeter::work_per_question));
  EXPECT_THROW(in_canonical_order(chart, StopToken([](const char*) { return false; })), Stopped);
}

TEST(MirrorImage, PathsAcrossFacesWithoutMirrorImagesHaveNoMirrorImage) {
  // A roof whose vertices, rows and columns have mirror images. Faces have no mirror images if all diagonals have one
  // direction.
  const int n = 8;
  const auto roof = [](double s, double t) { return Eigen::Vector3d(2 * s - 1, 3 * t, 0.5 - std::abs(s - 0.5)); };
  FlattenInput grid = test::make_grid(n, n, roof);
  for (const bool are_alternate : {false, true}) {
    if (are_alternate) test::alternate_diagonals(grid, n);
    const Chart chart = test::chart_of(grid);
    std::vector<VertexHandle> image;
    for (const VertexHandle v : chart.mesh.vertices()) {
      const int at = chart.source_vertex[v.idx()], column = at % (n + 1), mirrored_at = at + n - 2 * column;
      image.emplace_back(test::position_in(chart.source_vertex, mirrored_at));
    }
    // Tries all paths from a corner of a face across the opposite edge to the far corner of the next face.
    int num_mirrored = 0, num_refused = 0;
    for (const HalfedgeHandle h : chart.mesh.halfedges()) {
      if (chart.mesh.is_boundary(chart.mesh.edge_handle(h))) continue;
      const HalfedgeHandle across = chart.mesh.opposite_halfedge_handle(h);
      const auto apex = [&](HalfedgeHandle side) {
        return chart.mesh.to_vertex_handle(chart.mesh.next_halfedge_handle(side));
      };
      const MeshPath path{PathPoint::at_vertex(apex(h)), PathPoint::on_edge(h, 0.3),
                          PathPoint::at_vertex(apex(across))};
      const MeshPath found = mirrored(chart, image, path);
      if (found.empty()) {
        ++num_refused;
        continue;
      }
      ++num_mirrored;
      ASSERT_EQ(found.size(), 3U);
      const HalfedgeHandle crossed = found[1].half_edge;
      EXPECT_EQ(std::minmax(found[0].vertex, found[2].vertex),
                std::minmax(apex(crossed), apex(chart.mesh.opposite_halfedge_handle(crossed))));
    }
    EXPECT_EQ(num_refused > 0, !are_alternate);
    EXPECT_EQ(num_mirrored > 0, are_alternate);
  }
}

constexpr int kN = 14;
constexpr int kMiddle = 6;

bool is_inside(int i, int j) { return i > 0 && j > 0 && i < kN && j < kN; }

/// Returns whether paths may use a vertex. The open vertices are two lanes, one from the left and one from below, and
/// the area above and to the right of the lanes' crossing.
bool is_open(int i, int j) {
  if (!is_inside(i, j)) return false;
  return (i >= kMiddle && j >= kMiddle) || (j == kMiddle && i < kMiddle) || (i == kMiddle && j < kMiddle);
}

/// Returns whether an edge is a diagonal beside the crossing. Paths must not take this shortcut.
bool is_diagonal_of_the_crossing(int i, int j, int other_i, int other_j) {
  const auto is_near = [](int a, int b) { return a + b <= 2 * kMiddle && a <= kMiddle && b <= kMiddle; };
  return i != other_i && j != other_j && (is_near(i, j) || is_near(other_i, other_j));
}

TEST(SmoothPaths, PathsThatCrossThemselvesAreRejected) {
  FlattenInput input = test::flat_rectangle(kN, kN, kN, kN);
  test::alternate_diagonals(input, kN);
  const Chart chart = test::chart_of(input);
  const auto column = [&](VertexHandle v) { return chart.source_vertex[v.idx()] % (kN + 1); };
  const auto row = [&](VertexHandle v) { return chart.source_vertex[v.idx()] / (kN + 1); };
  const auto at = [&](int i, int j) { return VertexHandle(test::position_in(chart.source_vertex, i + (kN + 1) * j)); };
  Forbidden forbidden{std::vector<char>(chart.mesh.n_vertices(), 0), std::vector<char>(chart.mesh.n_edges(), 0)};
  for (const VertexHandle v : chart.mesh.vertices()) forbidden.vertices[v.idx()] = is_open(column(v), row(v)) ? 0 : 1;
  for (const EdgeHandle e : chart.mesh.edges()) {
    const HalfedgeHandle h = chart.mesh.halfedge_handle(e, 0);
    const VertexHandle a = chart.mesh.from_vertex_handle(h), b = chart.mesh.to_vertex_handle(h);
    forbidden.edges[e.idx()] = is_diagonal_of_the_crossing(column(a), row(a), column(b), row(b)) ? 1 : 0;
  }
  const SmoothPathFinder finder(chart, forbidden);
  const SmoothPaths paths = finder.paths_from(at(1, kMiddle));
  EXPECT_TRUE(paths.arrival[at(kMiddle, 1).idx()].is_valid())
      << "straight through, around a loop and down the other lane";
  EXPECT_TRUE(finder.path_to(paths, at(kMiddle, 1)).empty());
  EXPECT_EQ(finder.path_to(paths, at(kMiddle + 3, kMiddle)).size(), kMiddle + 2U);
}

}  // namespace
}  // namespace wirewarp::test_cut_search
