// SPDX-License-Identifier: GPL-3.0-or-later
#include "cuts/propose/needed_stretch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "surface/mesh/widespread.h"

namespace wirewarp {
namespace {

/// Replaces NaN with infinity, because a flat triangle without area has no finite strain.
Eigen::ArrayXd as_numbers(const Eigen::VectorXd& strains) {
  return strains.array().isFinite().select(strains.array(), std::numeric_limits<double>::infinity());
}

/// Returns for each face the stretch that the fabric needs beyond the eases, in the worst direction. Compression counts
/// as the stretch that would undo it.
Eigen::VectorXd worst_direction(const Metrics& metrics, double wanted_stretch, double wanted_compression) {
  const Eigen::ArrayXd weft = 1 + as_numbers(metrics.face_weft_strain), warp = 1 + as_numbers(metrics.face_warp_strain);
  Eigen::VectorXd worst(weft.size());
  for (Eigen::Index f = 0; f < worst.size(); ++f) {
    // Threads with lengths p and q at an angle of π/2 − γ have the metric (p², p q sin γ; p q sin γ, q²).
    const double p = weft[f], q = warp[f];
    const double middle = (p * p + q * q) / 2;
    const double spread = std::hypot((p * p - q * q) / 2, p * q * std::sin(metrics.face_shear_angle[f]));
    const double longest = std::sqrt(middle + spread), shortest = std::sqrt(std::max(middle - spread, 0.0));
    const double stretch = std::max(longest, 1.0) / wanted_stretch;
    const double compression = 1 / (std::min(shortest, 1.0) * wanted_compression);
    const double needed = std::max({stretch, compression, 1.0}) - 1;
    worst[f] = std::isnan(needed) ? std::numeric_limits<double>::infinity() : needed;
  }
  return worst;
}

}  // namespace

NeededStretch::NeededStretch(const FlattenInput& input, bool has_cloth) : input_(input), has_cloth_(has_cloth) {
  for (const auto& corners : input.faces.rowwise()) {
    const Eigen::Vector3d a = input.vertices.row(corners[0]), b = input.vertices.row(corners[1]),
                          c = input.vertices.row(corners[2]);
    areas_.push_back((b - a).cross(c - a).norm() / 2);
  }
  for (const Ease& ease : input.eases) {
    for (const auto& ends : ease.half_edges.rowwise()) sides_[{ends[0], ends[1]}] = ease.ratio;
  }
}

/// Returns the smallest range that contains 0 and the eases of all lines of the piece.
std::pair<double, double> NeededStretch::range_of_eases(const Piece& piece) const {
  std::pair<double, double> range{0, 0};
  const auto add = [&](double ease) { range = {std::min(range.first, ease), std::max(range.second, ease)}; };
  for (const WireReport& wire : piece.wires) add(input_.wires[wire.wire_index].ease);
  if (sides_.empty()) return range;
  for (const BoundaryReport& chain : piece.boundaries) {
    for (std::size_t i = 1; i < chain.vertices.size(); ++i) {
      const auto found = sides_.find({chain.vertices[i - 1], chain.vertices[i]});
      if (found != sides_.end()) add(found->second);
    }
  }
  return range;
}

Eigen::VectorXd NeededStretch::of_faces(const Piece& piece) const {
  const auto [least, most] = range_of_eases(piece);
  const double wanted_stretch = 1 / (1 + least), wanted_compression = 1 + most;
  const Metrics& metrics = piece.metrics;
  if (!has_cloth_) return worst_direction(metrics, wanted_stretch, wanted_compression);
  const Eigen::ArrayXd weft = as_numbers(metrics.face_weft_strain), warp = as_numbers(metrics.face_warp_strain);
  return ((1 + weft.max(warp)) / wanted_stretch - 1).max(0);
}

double NeededStretch::of(const Piece& piece) const {
  std::vector<double> areas;
  for (const int f : piece.source_face) areas.push_back(areas_[f]);
  if (!has_cloth_) return widespread(areas, of_faces(piece));
  const double wanted_stretch = 1 / (1 + range_of_eases(piece).first);
  double needed = 0;
  for (const Eigen::VectorXd* threads : {&piece.metrics.face_weft_strain, &piece.metrics.face_warp_strain}) {
    needed = std::max(needed, (1 + widespread(areas, as_numbers(*threads))) / wanted_stretch - 1);
  }
  return needed;
}

}  // namespace wirewarp
