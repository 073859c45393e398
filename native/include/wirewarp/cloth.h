// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace wirewarp {

/// A fabric with a weft (x, across) and a warp (y, along the grain).
///
/// - f: worn length of a thread divided by its flat length
/// - γ: angle by which weft and warp differ from a right angle
///
/// The energy per area of the flat piece is
///
///   weft (f_weft − 1)² + warp (f_warp − 1)² + shear (f_weft f_warp sin γ)²
///
/// The shape depends only on the ratios of the stiffnesses. For small strains, weft 1, warp 1 and shear ½ mean the
/// isotropic energy of a run without a cloth.
struct Cloth {
  double weft = 1;     // stiffness of the threads across the grain; positive
  double warp = 1;     // stiffness of the threads along the grain; positive
  double shear = 0.5;  // stiffness against shear; positive, small for woven fabrics

  /// Cost of compressing a thread divided by the cost of stretching it: above 1 if the material hardly compresses. In
  /// [0.01, 100], far beyond the presets, which have 1 to 4.
  double squeeze = 1;
  static constexpr double least_squeeze = 0.01;
  static constexpr double most_squeeze = 100;

  /// Negative ease: relative stretch when worn, along weft and warp, where 0.2 is 20%. In [-0.5, 4]. No preset
  /// stretches by more than 1.
  ///
  /// - An edge of the flat piece is shorter by the stretch in its direction.
  /// - All sides of a seam become shorter by the same factor.
  /// - The energy measures the deviation from the worn state.
  std::array<double, 2> stretch = {0, 0};
  static constexpr double least_stretch = -0.5;
  static constexpr double most_stretch = 4;

  /// Angle γ in radians, in (0, π/2), above which threads press on each other. A larger γ adds the energy 10 max(weft,
  /// warp) (|sin γ| − sin locking)². None: threads never press on each other.
  std::optional<double> locking;

  /// Maximum strain along weft and warp, dimensionless and not negative. A piece with more strain in either direction
  /// gets a warning. None: the strain is not checked.
  std::optional<std::array<double, 2>> limits;

  /// Largest allowed ratio of two stiffnesses. Real fabrics stay below 300.
  static constexpr double most_anisotropy = 1e4;
};

/// A fabric that can be chosen by its name. Its figures are for an ordinary fabric of this kind, so measure your own
/// fabric.
struct ClothPreset {
  std::string name;         // name for scripts: "woven"
  std::string label;        // name for users: "Woven Cotton"
  std::string description;  // one sentence
  Cloth cloth;              // its limits are the maximum stretch across and along the grain
  std::string source;       // source of the figures
};

/// Returns the table of fabrics. Blender files store indices into it, so new fabrics are added at the end.
const std::vector<ClothPreset>& cloth_presets();

/// Returns a fabric by its name. Throws FlattenError (invalid_option) if the table does not have it.
const ClothPreset& cloth_preset(const std::string& name);

/// Throws FlattenError (invalid_option) unless every number is in its range.
void check_cloth(const Cloth& cloth);

}  // namespace wirewarp
