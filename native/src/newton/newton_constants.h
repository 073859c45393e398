// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp {

/// Constants of minimize(), each with the reason for its value. f is the objective; the slope of a step is the first
/// derivative of f along it.
struct NewtonConstants {
  /// Smallest predicted decrease of a step, relative to f. Lengths are exact at every step, so more digits improve only
  /// the shape, and f has rounding errors of 1e-13 on a million triangles.
  static constexpr double worthwhile = 1e-9;
  /// Smallest predicted decrease, relative to f, for shapes from which later stages start. With 1e-2, all samples
  /// together take a tenth more factorizations. With 1, a quarter sphere takes 16 factorizations instead of 10.
  static constexpr double worthwhile_on_the_way = 0.1;
  /// A shape counts as isometric if f over the area is below this value. This means strains of 1e-11, a hundredth of
  /// the guaranteed precision of lengths.
  static constexpr double isometric = 1e-22;
  /// After this number of factorizations, flipped triangles are not expected to unfold. A start without flipped
  /// triangles is then tried (newton/injective_shape.h). With twice as many, no verdict on 300 random cases changes.
  static constexpr int patience = 30;

  /// Slope over f below which the Hessian hardly changes along a step, so that the next step can reuse the factor.
  /// With a tenth of this value, 1% more factorizations are needed.
  static constexpr double near_minimum = 1e-2;
  /// Largest slope of a step with an old factor, relative to the slope of the previous step. If the slope falls less, a
  /// new factor is cheaper: it costs as much as about four steps.
  static constexpr double falls_fast = 0.1;

  /// A step is accepted if f falls by at least this share of the predicted decrease. Values below 1/4 are usual
  /// (Nocedal, Wright, algorithm 4.1).
  static constexpr double accept_ratio = 0.1;
  /// Twice the radius is tried if f falls by this share of the predicted decrease. Usually, the share is 3/4. Here, a
  /// larger step costs no factorization, because one basis is enough for all radii.
  static constexpr double grow_ratio = 0.5;
  /// Divisor of the radius after a bad step; 2 to 4 is usual.
  static constexpr double shrink = 3;
  /// Largest number of radii that are tried for one step. With 30, no shape of 300 random cases changes: a step that is
  /// 3¹⁰ times shorter gains nothing.
  static constexpr int max_radii = 10;
  /// Largest dimension of the Krylov space. Each vector costs a few substitutions. On 300 random cases, 8 vectors lead
  /// to 4% more factorizations, and 30 vectors save none.
  static constexpr int max_krylov_size = 15;
  /// Smallest negative curvature, relative to the convex part's curvature, at which leaving a saddle is worthwhile.
  /// With half or twice this value, no shape of 400 random cases changes.
  static constexpr double flat_curvature = 1e-4;
};

}  // namespace wirewarp
