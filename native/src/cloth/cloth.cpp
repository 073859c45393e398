// SPDX-License-Identifier: GPL-3.0-or-later
#include "wirewarp/cloth.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "errors/sentence.h"
#include "planar.h"
#include "wirewarp/error.h"

namespace wirewarp {
namespace {

[[noreturn]] void refuse(const std::string& name, double value, const std::string& allowed) {
  throw FlattenError(ErrorCode::invalid_option,
                     "The cloth's " + name + " is " + shortest(value) + ": it must " + allowed + ".");
}

void check_stiffness(const std::string& name, double value) {
  if (!(value > 0 && std::isfinite(value))) refuse(name, value, "be positive and finite");
}

// Ratios of stiffness; where one figure stands for a family, a middle one. Wovens: stretching in weft and warp some
// 2,100 N/m, shear 25 to 100, of stiff plain weaves; denim of 11 oz: 225, 1,055 and 70; knits such as swimwear 40, 138
// and 10 to 36 (all from the measurements of H. Wang, J. O'Brien, R. Ramamoorthi, Data-driven elastic models for cloth,
// 2011). Jersey is a little softer against shear than their double knit (67, 182, 30). A plain weave locks at about 45°
// (trellis tests on dry fabrics). Leather and closed-cell foam are alike in all directions and buckle rather than
// compress: nobody publishes by how much, so these two factors are chosen, not measured.
const std::map<std::string, Cloth>& presets() {
  static const std::map<std::string, Cloth> all = {
      {"woven", {1, 1, 0.05, 1, {}, kPi / 4, {}}}, {"denim", {0.21, 1, 0.06, 1, {}, {}, {}}},
      {"jersey", {0.3, 0.6, 0.15, 1, {}, {}, {}}}, {"swim", {0.29, 1, 0.17, 1, {}, {}, {}}},
      {"leather", {1, 1, 0.5, 4, {}, {}, {}}},     {"neoprene", {1, 1, 0.5, 2, {}, {}, {}}},
  };
  return all;
}

}  // namespace

const std::vector<std::string>& cloth_preset_names() {
  static const std::vector<std::string> names = {"woven", "denim", "jersey", "swim", "leather", "neoprene"};
  return names;
}

Cloth cloth_preset(const std::string& name) {
  const auto preset = presets().find(name);
  if (preset != presets().end()) return preset->second;
  std::string known;
  for (const std::string& one : cloth_preset_names()) known += (known.empty() ? "'" : " or '") + one + "'";
  throw FlattenError(ErrorCode::invalid_option, "There is no cloth '" + name + "': it must be " + known + ".");
}

void check_cloth(const Cloth& cloth) {
  check_stiffness("weft", cloth.weft);
  check_stiffness("warp", cloth.warp);
  check_stiffness("shear", cloth.shear);
  const auto [least, most] = std::minmax({cloth.weft, cloth.warp, cloth.shear});
  if (!(most <= Cloth::most_anisotropy * least)) {
    throw FlattenError(ErrorCode::invalid_option, "The cloth's stiffnesses weft " + shortest(cloth.weft) + ", warp " +
                                                      shortest(cloth.warp) + " and shear " + shortest(cloth.shear) +
                                                      " are too far apart: none may be more than " +
                                                      shortest(Cloth::most_anisotropy) + " times another.");
  }
  if (!(cloth.squeeze >= Cloth::least_squeeze && cloth.squeeze <= Cloth::most_squeeze)) {
    refuse("squeeze", cloth.squeeze,
           "lie between " + shortest(Cloth::least_squeeze) + " and " + shortest(Cloth::most_squeeze));
  }
  for (const double stretch : cloth.stretch) {
    if (!(stretch >= Cloth::least_stretch && stretch <= Cloth::most_stretch)) {
      refuse("stretch", stretch,
             "lie between " + shortest(Cloth::least_stretch) + " and " + shortest(Cloth::most_stretch));
    }
  }
  if (cloth.locking && !(*cloth.locking > 0 && *cloth.locking < kPi / 2)) {
    refuse("locking", *cloth.locking, "be an angle above 0 and below a quarter turn, in radians");
  }
  if (!cloth.limits) return;
  for (const double limit : *cloth.limits) {
    if (!(limit >= 0 && std::isfinite(limit))) refuse("limit", limit, "be a strain, 0 or above and finite");
  }
}

}  // namespace wirewarp
