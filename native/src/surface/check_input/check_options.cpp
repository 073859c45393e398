// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <cmath>

#include "base/arguments.h"
#include "base/planar.h"
#include "base/sentence.h"
#include "surface/check_input/check_input.h"

namespace wirewarp {
namespace {

void check_range(const std::string& name, double value, double least, double most) {
  if (value >= least && value <= most) return;
  throw wrong_option(name, shortest(value), "be between " + shortest(least) + " and " + shortest(most));
}

}  // namespace

void check_options(const Options& options) {
  check_range("gap", options.gap, 0, 1);
  check_range("fairness", options.fairness, Options::least_fairness, Options::most_fairness);
  check_range("grain_angle", options.grain_angle, -kPi, kPi);
  if (!(options.thickness >= 0 && std::isfinite(options.thickness))) {
    throw wrong_option("thickness", shortest(options.thickness), "be 0 or above and finite, in scene units");
  }
  if (options.cloth) {
    check_cloth(*options.cloth);
    if (options.method != Method::refined) {
      throw wrong_option("method", options.method == Method::wirewarping ? "wirewarping" : "wirewarp++",
                         "be refined if there is a cloth");
    }
  } else if (options.orientation == Orientation::best) {
    throw wrong_option("orientation", "best", "be wire, boundary, up or grain if there is no cloth");
  }
  if (options.max_factorizations < 1) {
    throw wrong_option("max_factorizations", std::to_string(options.max_factorizations), "be at least 1");
  }
  if (options.grain < -1) throw wrong_option("grain", std::to_string(options.grain), "be -1 or the index of a wire");
  const Eigen::Vector3d up(options.up[0], options.up[1], options.up[2]);
  if (!up.allFinite() || up.isZero(0)) {
    throw wrong_option("up", "(" + shortest(up.x()) + ", " + shortest(up.y()) + ", " + shortest(up.z()) + ")",
                       "be finite and not zero");
  }
}

void check_options(const Options& options, std::size_t num_wires) {
  check_options(options);
  if (options.grain < static_cast<std::ptrdiff_t>(num_wires)) return;
  throw wrong_option("grain", std::to_string(options.grain),
                     "be -1 or the index of one of the " + std::to_string(num_wires) + " wires");
}

}  // namespace wirewarp
