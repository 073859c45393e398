// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace wirewarp {

/// What a cloth with a weft (x, across) and a warp (y, along the grain) resists, per area of the flat piece: threads of
/// length f in the worn piece, 1 in the flat one, and the angle γ by which weft and warp leave the right angle cost
///
///   weft (f_weft − 1)² + warp (f_warp − 1)² + shear (f_weft f_warp sin γ)²
///
/// Only ratios count. With (1, 1, ½) it is, for small strains, the isotropic energy of a run without a cloth.
struct Cloth {
  double weft = 1;     // stiffness of the threads across; positive
  double warp = 1;     // of those along the grain; positive
  double shear = 0.5;  // against turning the two to one another; positive. Small for wovens

  /// How much more than by stretching a thread costs when it is squeezed, as a factor: above 1 where the material
  /// hardly compresses. In [0.01, 100].
  double squeeze = 1;
  static constexpr double least_squeeze = 0.01;
  static constexpr double most_squeeze = 100;

  /// How much longer than flat the cloth is when it is worn, along weft and warp: 0.2 is 20 %, negative ease. Threads
  /// and the angle between them cost what they deviate from that, and lengths are promised so much shorter, each by
  /// its direction; the sides of a seam alike. Dimensionless, in [-0.5, 4].
  std::array<double, 2> stretch = {0, 0};
  static constexpr double least_stretch = -0.5;
  static constexpr double most_stretch = 4;

  /// γ, radians, in (0, π/2), from which on the threads press on one another: more costs 10 max(weft, warp)
  /// (|sin γ| − sin locking)². None: never.
  std::optional<double> locking;

  /// Strains that the cloth bears along weft and warp, dimensionless and not negative: a piece that needs more in
  /// either direction has a warning. None: not checked.
  std::optional<std::array<double, 2>> limits;

  /// Any two stiffnesses are at most this far apart, as a factor: real cloths stay below 300.
  static constexpr double most_anisotropy = 1e4;
};

/// A fabric that can be chosen by its name. Ratios and maximum stretch are those of an ordinary one: measure yours.
struct ClothPreset {
  std::string name;         // as in Options
  std::string label;        // as on a bolt: "Woven Cotton"
  std::string description;  // one sentence
  Cloth cloth;              // with limits: its maximum stretch across and along the grain
  std::string source;       // where the figures are from
};

/// The table of fabrics. Files of Blender store places in it: a new fabric goes at the end.
const std::vector<ClothPreset>& cloth_presets();

/// Throws FlattenError (invalid_option) for a name that the table does not have.
const ClothPreset& cloth_preset(const std::string& name);

/// Throws FlattenError (invalid_option) unless every number is in its range.
void check_cloth(const Cloth& cloth);

}  // namespace wirewarp
