// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/pack_boxes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/work_meter.h"

namespace wirewarp {
namespace {

// Lengths count as equal if they differ by less than this fraction of the side of a square with the area of all boxes.
// Therefore, rounding errors do not decide where boxes are placed.
constexpr double kSameLength = 1e-6;

/// A step of the skyline, the upper outline of the boxes placed so far. Steps are listed from left to right.
struct Step {
  double x;
  double width;
  double y;
};

struct Packing {
  Positions2 corners;
  double extent = 0;  // larger side of the box around all boxes
};

/// Returns the height at which a box rests with its left side on step i; infinite if it leaves the strip. overhang:
/// width of the box that needs no step below it, because `width` includes the gap.
double resting_height(const std::vector<Step>& skyline, std::size_t i, double width, double overhang) {
  double y = 0;
  double remaining = width;
  for (; i < skyline.size() && remaining > overhang; ++i) {
    y = std::max(y, skyline[i].y);
    remaining -= skyline[i].width;
  }
  return remaining > overhang ? std::numeric_limits<double>::infinity() : y;
}

/// Raises the skyline to the top of a box placed with its left side on step i.
void raise(std::vector<Step>& skyline, std::size_t i, double width, double top) {
  const Step placed{skyline[i].x, width, top};
  const double end = placed.x + width;
  std::size_t last = i;
  while (last < skyline.size() && skyline[last].x + skyline[last].width <= end) ++last;
  if (last < skyline.size() && skyline[last].x < end) {
    skyline[last].width -= end - skyline[last].x;
    skyline[last].x = end;
  }
  skyline.erase(skyline.begin() + static_cast<std::ptrdiff_t>(i), skyline.begin() + static_cast<std::ptrdiff_t>(last));
  skyline.insert(skyline.begin() + static_cast<std::ptrdiff_t>(i), placed);
}

/// Places each box as low as possible, then as far left as possible, in a strip of the given width.
Packing pack_in_strip(const Positions2& sizes, const std::vector<Eigen::Index>& order, double gap, double strip,
                      double slack, WorkMeter& work) {
  Packing packing;
  packing.corners.resize(sizes.rows(), 2);
  std::vector<Step> skyline{{0, strip + gap + slack, 0}};
  const double overhang = std::min(gap, slack);
  for (const Eigen::Index box : order) {
    work.did(skyline.size());
    const double width = sizes(box, 0) + gap;
    std::size_t best = 0;
    double best_y = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < skyline.size(); ++i) {
      const double y = resting_height(skyline, i, width, overhang);
      if (y < best_y - slack) {
        best = i;
        best_y = y;
      }
    }
    packing.corners.row(box) << skyline[best].x, best_y;
    packing.extent = std::max({packing.extent, skyline[best].x + sizes(box, 0), best_y + sizes(box, 1)});
    raise(skyline, best, width, best_y + sizes(box, 1) + gap);
  }
  return packing;
}

}  // namespace

Positions2 pack_boxes(const Positions2& sizes, double gap, const StopToken& stop) {
  if (sizes.rows() == 0) return Positions2(0, 2);
  const double side = std::sqrt(((sizes.col(0).array() + gap) * (sizes.col(1).array() + gap)).sum());
  const double slack = kSameLength * side;

  // The tallest box comes first.
  std::vector<Eigen::Index> order(static_cast<std::size_t>(sizes.rows()));
  std::iota(order.begin(), order.end(), 0);
  const auto height = [&](Eigen::Index box) { return slack > 0 ? std::round(sizes(box, 1) / slack) : 0.0; };
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) { return height(a) > height(b); });

  // Strips are 0.8 to 1.55 times as wide as `side`, but at least as wide as the widest box. The packing whose larger
  // side is shortest is kept.
  constexpr int kStrips = 16;
  WorkMeter work(stop);
  Packing best;
  best.extent = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kStrips; ++k) {
    const double strip = std::max(sizes.col(0).maxCoeff(), side * (0.8 + 0.05 * k));
    Packing packing = pack_in_strip(sizes, order, gap, strip, slack, work);
    if (packing.extent < best.extent - slack || k == 0) best = std::move(packing);
  }
  return best.corners;
}

Positions2 place_in_row(const Positions2& sizes, double gap) {
  Positions2 corners = Positions2::Zero(sizes.rows(), 2);
  for (Eigen::Index box = 1; box < sizes.rows(); ++box) {
    corners(box, 0) = corners(box - 1, 0) + sizes(box - 1, 0) + gap;
  }
  return corners;
}

}  // namespace wirewarp
