// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/pack_pieces.h"

#include <cmath>

#include "base/work_meter.h"
#include "result/pack_boxes.h"
#include "surface/charts/enclosed_area.h"
#include "surface/orientation/upright_direction.h"

namespace wirewarp {
Positions2 mirror_image(const Positions2& uv) {
  Positions2 mirrored = uv;
  mirrored.col(0) *= -1;
  return mirrored;
}

// Layouts are rotated in place, because for a large piece, allocating memory would take most of the time.
std::vector<Positions2> pack_pieces(const std::vector<Chart>& charts, std::vector<Positions2> layouts,
                                    const Options& options, const StopToken& stop) {
  WorkMeter work(stop);
  std::vector<std::size_t> pieces;  // indices of pieces with a layout
  double area = 0;
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    if (layouts[i].rows() == 0) continue;
    work.did(charts[i].source_face.size());
    pieces.push_back(i);
    area += std::abs(enclosed_area(charts[i], layouts[i]));
    // Pieces of a fabric are solved in their final direction: x is the weft, y the warp.
    Eigen::Vector2d up = options.cloth ? Eigen::Vector2d(0, 1) : upright_direction(charts[i], layouts[i], options);
    if (options.mirror) {
      layouts[i] = mirror_image(layouts[i]);
      up.x() *= -1;
    }
    stand_upright(layouts[i], up);
  }

  Positions2 sizes(static_cast<Eigen::Index>(pieces.size()), 2);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    sizes.row(static_cast<Eigen::Index>(k)) = layouts[pieces[k]].colwise().maxCoeff();
  }
  const double gap = options.gap * std::sqrt(area);
  const Positions2 corners =
      options.layout == PieceLayout::row ? place_in_row(sizes, gap) : pack_boxes(sizes, gap, stop);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    layouts[pieces[k]].rowwise() += corners.row(static_cast<Eigen::Index>(k));
  }
  return layouts;
}

}  // namespace wirewarp
