// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the lengths of a fabric that is stretched when worn. A share is a flat length divided by the length on the
// surface. It depends on the edge's direction in the result without the stretch.
#include "checks.h"

namespace wirewarp::test {
namespace {

constexpr double kEven = 1e-12;  // allowed difference between equal shares
// Largest E, divided by the area, of a piece that unfolds. Other pieces may have several minima, so the shapes of these
// pieces are not compared.
constexpr double kWithoutStrain = 1e-18;
constexpr double kSamePlace = 1e-6;  // allowed distance of vertices from their expected places, in sizes of the piece

Eigen::Vector2d shares(const Judged& judged) {
  const std::array<double, 2>& stretch = judged.options.cloth->stretch;
  return {1 / (1 + stretch[0]), 1 / (1 + stretch[1])};
}

Eigen::Vector2d unstretched_uv(const Judged& judged, int face, int corner) {
  return judged.unstretched->corner_uv.block<1, 2>(face, 2 * (corner % 3)).transpose();
}

double share_of(const Judged& judged, const Side& side) {
  const Eigen::Vector2d d =
      unstretched_uv(judged, side.face, side.corner + 1) - unstretched_uv(judged, side.face, side.corner);
  return d.norm() > 0 ? d.cwiseProduct(shares(judged)).norm() / d.norm() : 1;
}

bool has_unstretched_layout(const Judged& judged, const Side& side) {
  return unstretched_uv(judged, side.face, 0).allFinite();
}

/// Returns whether every length of a piece shrinks by the share of its direction. Eases, elastic wires along the
/// outline and seams whose sides shrink differently lead to other lengths.
bool is_even(const Judged& judged, const Piece& piece) {
  const int number = judged.piece_of(piece.source_face.front());
  if (!judged.input.eases.empty()) return false;
  for (const Wire& wire : judged.input.wires) {
    for (const Edge& edge : edges_of(wire)) {
      if (judged.sides_in(edge, number).empty()) continue;
      if (wire.ease != 0 || (judged.is_outline(edge) && wire.tolerance > 0)) return false;
    }
  }
  for (const int face : piece.source_face) {
    for (int k = 0; k < 3; ++k) {
      const Edge edge = judged.edge(face, k);
      if (!judged.is_outline(edge)) continue;
      if (std::abs(stretched_share(judged, edge) - share_of(judged, {face, k})) > kEven) return false;
    }
  }
  return true;
}

}  // namespace

double stretched_share(const Judged& judged, const Edge& edge) {
  double sum = 0;
  int count = 0;
  for (const Side& side : judged.sides().at(edge)) {
    if (!has_unstretched_layout(judged, side)) continue;
    sum += share_of(judged, side);
    ++count;
  }
  return count > 0 ? sum / count : 1;
}

void check_even_stretch(Judged& judged, const Piece& piece) {
  if (!judged.unstretched || judged.may_stop_anywhere()) return;
  const int number = judged.piece_of(piece.source_face.front());
  const Piece& unstretched = judged.unstretched->pieces[number];
  if (unstretched.error || unstretched.report.termination != Termination::converged || !is_even(judged, piece)) return;
  if (piece.error) {
    judged.say(std::string("a piece that is evenly stretched has the error ") + describe(piece.error->code).name);
    return;
  }
  if (!(unstretched.metrics.arap_energy < kWithoutStrain)) return;
  const int first = piece.source_face.front();
  const double size = (piece.vertices.rowwise() - piece.vertices.row(0)).rowwise().norm().maxCoeff();
  const Eigen::Vector2d from = judged.uv(first, 0), there = unstretched_uv(judged, first, 0);
  double off = 0;
  for (const int face : piece.source_face) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector2d expected = (unstretched_uv(judged, face, k) - there).cwiseProduct(shares(judged));
      off = std::max(off, (judged.uv(face, k) - from - expected).norm());
    }
  }
  if (!(off <= kSamePlace * size)) {
    judged.say("a piece that is evenly stretched has another shape, with a distance of " + std::to_string(off / size));
  }
}

}  // namespace wirewarp::test
