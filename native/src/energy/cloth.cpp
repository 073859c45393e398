// SPDX-License-Identifier: GPL-3.0-or-later
#include "wirewarp/cloth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/arguments.h"
#include "base/planar.h"
#include "base/sentence.h"
#include "wirewarp/error.h"

namespace wirewarp {
namespace {

[[noreturn]] void refuse(const std::string& name, double value, const std::string& allowed) {
  throw wrong_option("cloth " + name, shortest(value), allowed);
}

void check_stiffness(const std::string& name, double value) {
  if (!(value > 0 && std::isfinite(value))) refuse(name, value, "be positive and finite");
}

// stiffness: across the grain, along the grain, and against shear. stretch: largest stretch across and along the grain
// that a hand can cause and from which the fabric recovers.
Cloth fabric(std::array<double, 3> stiffness, std::array<double, 2> stretch, double squeeze = 1,
             std::optional<double> locking = {}) {
  return {stiffness[0], stiffness[1], stiffness[2], squeeze, {}, locking, stretch};
}

}  // namespace

// The stiffnesses are middle values for families of fabrics, and only their ratios matter. Measured stiffnesses are
// beside the presets: weft, warp and shear, in N/m.
const std::vector<ClothPreset>& cloth_presets() {
  static const std::string wang = "Stiffness: Wang, O'Brien, Ramamoorthi: Data-driven elastic models for cloth (2011)";
  static const std::vector<ClothPreset> all = {
      // Measured: 2,100, 2,100 and 25 to 100. Dry fabrics lock at about 45° in trellis tests.
      {"woven", "Woven Cotton", "Cotton, linen and other plain weaves without elastane",
       fabric({1, 1, 0.05}, {0.03, 0.03}, 1, kPi / 4),
       wang + ", stiff plain weaves. Stretch: chosen for the crimp of the yarns"},
      // Measured, 11 oz: 225, 1,055 and 70.
      {"denim", "Denim", "Denim and twill without elastane", fabric({0.21, 1, 0.06}, {0.03, 0.03}),
       wang + ", denim of 11 oz. Stretch: chosen, the same as for other wovens"},
      // Measured double knit: 67, 182 and 30.
      {"jersey", "Jersey", "Jersey and T-shirt fabric", fabric({0.3, 0.6, 0.15}, {0.5, 0.25}),
       wang + ", a little softer than their double knit. Stretch: stretch guides, 25 to 50%"},
      // Measured: 40, 138 and 10 to 36.
      {"swim", "Swim Knit", "Swim and activewear knit with elastane", fabric({0.29, 1, 0.17}, {1.0, 0.75}),
       wang + ", swimwear knit. Stretch: stretch guides, 75 to 100% both ways"},
      // Isotropic materials have half of their tensile stiffness against shear. Leather and foam buckle instead of
      // compressing: no measurements are published, so their squeeze factors are chosen.
      {"leather", "Leather", "Garment and upholstery leather", fabric({1, 1, 0.5}, {0.08, 0.08}, 4),
       "Stiffness: the same in all directions. Stretch: chosen for garment leather, which shoemakers stretch no "
       "further"},
      {"neoprene", "Neoprene", "Neoprene with knit on both sides", fabric({1, 1, 0.5}, {0.3, 0.3}, 2),
       "Stiffness: the same in all directions. Stretch: chosen for sheets of 2 to 5 mm. Thinner sheets stretch "
       "further"},
      {"felt", "Felt", "Felt of wool or acrylic, with no grain", fabric({1, 1, 0.5}, {0.05, 0.05}),
       "Stiffness: the same in all directions, because felt has no threads. Stretch: chosen. More stretch tears felt"},
      {"fleece", "Fleece", "Polar fleece and sweatshirt fabric", fabric({0.4, 1, 0.17}, {0.2, 0.1}),
       wang +
           ", double knit. Stretch: chosen. Across the grain, it is that of stable knits in stretch guides, 18 to 25%. "
           "Along the grain, it is half of that"},
      {"minky", "Minky", "Minky and other short plush on a knit backing", fabric({0.3, 1, 0.15}, {0.2, 0.05}),
       "Stiffness: about that of swim knit. Stretch: chosen. Across the grain, it is that of stable knits. Along the "
       "grain, it is small"},
      {"vinyl", "Vinyl", "Vinyl and faux leather on a knit backing", fabric({1, 1, 0.5}, {0.05, 0.03}, 4),
       "Stiffness: the same in all directions. Stretch: chosen for an ordinary backing. Many vinyls stretch further"},
      {"foam", "EVA Foam", "EVA foam for costumes and armor, shaped with heat", fabric({1, 1, 0.5}, {0.1, 0.1}, 2),
       "Stiffness: the same in all directions, because the cells are closed. Stretch: chosen. A heat gun allows it "
       "without thinning the foam"},
  };
  return all;
}

const ClothPreset& cloth_preset(const std::string& name) {
  std::string known;
  for (const ClothPreset& one : cloth_presets()) {
    if (one.name == name) return one;
    known += (known.empty() ? "'" : " or '") + one.name + "'";
  }
  throw wrong_option("cloth", "'" + name + "'", "be " + known);
}

void check_cloth(const Cloth& cloth) {
  check_stiffness("weft", cloth.weft);
  check_stiffness("warp", cloth.warp);
  check_stiffness("shear", cloth.shear);
  const auto [least, most] = std::minmax({cloth.weft, cloth.warp, cloth.shear});
  if (!(most <= Cloth::most_anisotropy * least)) {
    throw wrong_option(
        "cloth",
        "weft " + shortest(cloth.weft) + ", warp " + shortest(cloth.warp) + " and shear " + shortest(cloth.shear),
        "have no stiffness more than " + shortest(Cloth::most_anisotropy) + " times another");
  }
  if (!(cloth.squeeze >= Cloth::least_squeeze && cloth.squeeze <= Cloth::most_squeeze)) {
    refuse("squeeze", cloth.squeeze,
           "be between " + shortest(Cloth::least_squeeze) + " and " + shortest(Cloth::most_squeeze));
  }
  for (const double stretch : cloth.stretch) {
    if (!(stretch >= Cloth::least_stretch && stretch <= Cloth::most_stretch)) {
      refuse("stretch", stretch,
             "be between " + shortest(Cloth::least_stretch) + " and " + shortest(Cloth::most_stretch));
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
