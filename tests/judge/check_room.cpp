// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>

#include "checks.h"

namespace wirewarp::test {
namespace {

struct Box {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  bool has_helpers = false;  // helper wires may extend beyond a flipped piece
};

Box box_of(const Judged& judged, const Piece& piece) {
  Box box;
  box.has_helpers = !piece.helper_wires.empty();
  for (const int face : piece.source_face) {
    for (int k = 0; k < 3; ++k) {
      box.low = box.low.cwiseMin(judged.uv(face, k));
      box.high = box.high.cwiseMax(judged.uv(face, k));
    }
  }
  return box;
}

double area_of(const Judged& judged, const Piece& piece) {
  long double doubled = 0;
  for (const int face : piece.source_face) doubled += doubled_area(judged.triangle(face));
  return static_cast<double>(std::abs(doubled) / 2);
}

/// Returns the side of a square whose area is that of all boxes with their gaps.
double side_of_all(const std::vector<Box>& boxes, double gap) {
  double area = 0;
  for (const Box& box : boxes) area += ((box.high - box.low).array() + gap).prod();
  return std::sqrt(area);
}

}  // namespace

void check_room(Judged& judged) {
  std::vector<Box> boxes;
  double area = 0, size = 0;
  for (const Piece& piece : judged.result.pieces) {
    if (!judged.has_layout(piece)) continue;
    boxes.push_back(box_of(judged, piece));
    area += area_of(judged, piece);
    size = std::max(size, judged.uv_size(piece));
  }
  const double gap = judged.options.gap * std::sqrt(area);
  const double rounding = 1e-9 * size;
  const double slack = judged.options.layout == PieceLayout::packed ? 1e-6 * side_of_all(boxes, gap) : 0;
  const double least_gap = std::max(gap - slack, 0.0) - rounding;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double apart = (boxes[i].low.cwiseMax(boxes[j].low) - boxes[i].high.cwiseMin(boxes[j].high)).maxCoeff();
      if (apart < least_gap) judged.say("pieces are closer together than the gap");
    }
    if (judged.options.layout != PieceLayout::row) continue;
    const double left = i == 0 ? 0 : boxes[i - 1].high.x() + gap;
    const bool is_tight = !boxes[i].has_helpers && (i == 0 || !boxes[i - 1].has_helpers);
    if (boxes[i].low.x() < left - rounding || (is_tight && boxes[i].low.x() > left + rounding)) {
      judged.say("pieces in a row are not in their order");
    }
    if (boxes[i].low.y() < -rounding || (!boxes[i].has_helpers && boxes[i].low.y() > rounding)) {
      judged.say("pieces in a row are not on one line");
    }
  }
}

void check_same_shapes(Judged& judged, const FlattenResult& other) {
  if (other.pieces.size() != judged.result.pieces.size()) return judged.say("the layout changes the number of pieces");
  for (std::size_t p = 0; p < other.pieces.size(); ++p) {
    const Piece& piece = judged.result.pieces[p];
    const Piece& again = other.pieces[p];
    if (piece.error.has_value() != again.error.has_value() || (piece.error && piece.error->code != again.error->code)) {
      judged.say("the layout changes the outcome of piece " + std::to_string(p));
    }
    if (!judged.has_layout(piece) || piece.vertices.rows() != again.vertices.rows()) continue;
    const double size = std::max(piece.vertices.cwiseAbs().maxCoeff(), again.vertices.cwiseAbs().maxCoeff());
    for (const auto& corners : piece.faces.rowwise()) {
      for (int k = 0; k < 3; ++k) {
        const int a = corners[k], b = corners[(k + 1) % 3];
        const double length = (piece.vertices.row(a) - piece.vertices.row(b)).norm();
        const double same = (again.vertices.row(a) - again.vertices.row(b)).norm();
        if (!(std::abs(length - same) <= 1e-14 * size)) return judged.say("the layout changes lengths");
      }
    }
  }
}

}  // namespace wirewarp::test
