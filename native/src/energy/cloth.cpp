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

Cloth fabric(std::array<double, 3> stiffness, std::array<double, 2> stretch, double squeeze = 1,
             std::optional<double> locking = {}) {
  return {stiffness[0], stiffness[1], stiffness[2], squeeze, {}, locking, stretch};
}

}  // namespace

// The first three numbers are the stiffnesses across the grain, along the grain and against shear. Only their ratios
// matter. The next two are the maximum stretch across and along the grain: a hand can pull this far, and the fabric
// recovers. The last two numbers, if present, are the squeeze factor and the locking angle.
//
// A preset is for a family of fabrics, so its stiffnesses are middle values. Measured stiffnesses in N/m, in the same
// order: stiff plain weaves 2,100, 2,100 and 25 to 100; 11 oz denim 225, 1,055 and 70; knits such as swimwear 40, 138
// and 10 to 36; double knit 67, 182 and 30. A plain weave locks at about 45° (trellis tests on dry fabrics). An
// isotropic material has half of its tensile stiffness against shear. Foam and leather buckle instead of compressing.
// No measurements are published, so their squeeze factors are chosen.
const std::vector<ClothPreset>& cloth_presets() {
  static const std::string wang = "Stiffness: Wang, O'Brien, Ramamoorthi: Data-driven elastic models for cloth (2011)";
  static const std::vector<ClothPreset> all = {
      {"woven", "Woven Cotton", "Cotton, linen and other plain weaves without elastane",
       fabric({1, 1, 0.05}, {0.03, 0.03}, 1, kPi / 4),
       wang + ", stiff plain weaves. Stretch: chosen for the crimp of the yarns"},
      {"denim", "Denim", "Denim and twill without elastane", fabric({0.21, 1, 0.06}, {0.03, 0.03}),
       wang + ", denim of 11 oz. Stretch: chosen, the same as for other wovens"},
      {"jersey", "Jersey", "Jersey and T-shirt fabric", fabric({0.3, 0.6, 0.15}, {0.5, 0.25}),
       wang + ", a little softer than their double knit. Stretch: stretch guides, 25 to 50%"},
      {"swim", "Swim Knit", "Swim and activewear knit with elastane", fabric({0.29, 1, 0.17}, {1.0, 0.75}),
       wang + ", swimwear knit. Stretch: stretch guides, 75 to 100% both ways"},
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
