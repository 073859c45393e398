// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts that are proposed for one piece of several: their figures include what the other pieces bring about.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

#include "disguise.h"
#include "test_meshes.h"
#include "wirewarp/propose.h"

namespace wirewarp::test_cuts_beside_neighbors {
namespace {

/// Pieces that are not cut count, too: elastic seams and a stretched cloth make their lengths depend on one another.
struct Neighbors {
  const char* name;
  FlattenInput input;
  Options options;
};

/// For the names of tests in a report.
void PrintTo(const Neighbors& test, std::ostream* out) { *out << test.name; }

/// A hill of three pieces side by side, a wire across all of them, and one side of a seam longer than its mate.
FlattenInput three_pieces(int n) {
  FlattenInput input = test::make_grid(n, n, [](double s, double t) {
    const double x = 2 * s - 1, y = 2 * t - 1;
    return Eigen::Vector3d(x, y, 0.5 * std::exp(-3 * ((x - 0.2) * (x - 0.2) + 2 * (y + 0.1) * (y + 0.1))));
  });
  test::alternate_diagonals(input, n);
  for (const int column : {n / 4, 3 * n / 4}) test::add_seam(input, test::grid_column(n, n, column));
  test::add_wire(input, test::grid_row(n, n / 2), 0.02);
  input.eases.push_back({(VertexPairs(1, 2) << n / 4, n / 4 + n + 1).finished(), 0.05});
  return input;
}

Neighbors with_elastic_seam(int n) {
  Neighbors test{"elastic_seam", three_pieces(n), {}};
  test::add_wire(test.input, test::grid_column(n, n, n / 4), 0.03);
  return test;
}

Neighbors with_stretched_cloth(int n) {
  Neighbors test{"stretched_cloth", three_pieces(n), {}};
  test.options.cloth.emplace();
  test.options.cloth->stretch = {0.1, 0.05};
  test.options.grain = 0;
  return test;
}

Neighbors with_thick_material(int n) {
  Neighbors test{"thick_material", three_pieces(n), {}};
  test.options.thickness = 0.05;
  test.options.surface = Surface::inside;
  return test;
}

class CutsBesideNeighbors : public testing::TestWithParam<Neighbors> {};

TEST_P(CutsBesideNeighbors, HaveTheFiguresOfAFreshRunOfTheWholeModel) {
  const auto& [name, input, options] = GetParam();
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

INSTANTIATE_TEST_SUITE_P(Models, CutsBesideNeighbors,
                         testing::Values(with_elastic_seam(8), with_stretched_cloth(8), with_thick_material(8)),
                         [](const testing::TestParamInfo<Neighbors>& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace wirewarp::test_cuts_beside_neighbors
