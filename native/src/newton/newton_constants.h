// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp {

/// Constants of minimize(), each with the reason for its value. f is the objective; the slope of a step is the first
/// derivative of f along it.
struct NewtonConstants {
  // When to stop.

  /// Smallest predicted decrease of a step, relative to f. Lengths are exact at every step, so more digits improve only
  /// the shape, and f has rounding errors of 1e-13 on a million triangles.
  static constexpr double worthwhile = 1e-9;
  /// The same for shapes from which others start: without a fabric for those with one, and with fixed seams for those
  /// with elastic ones. On the samples, 1e-2 takes a tenth more factorizations in all; 1 takes 16 instead of 10 on a
  /// quarter sphere.
  static constexpr double worthwhile_on_the_way = 0.1;
  /// f over the area below which a shape counts as isometric: strains of 1e-11, a hundredth of the guaranteed precision
  /// of lengths.
  static constexpr double isometric = 1e-22;
  /// Factorizations after which flipped triangles are not expected to open. Twice as many change no verdict on 300
  /// random cases. Another start flips no triangle (newton/injective_shape.h).
  static constexpr int patience = 30;

  // Newton steps.

  /// Slope over f below which the Hessian hardly changes along a step, so that the next step can use the same factor. A
  /// tenth of it takes 1% more factorizations.
  static constexpr double near_minimum = 1e-2;
  /// Slope of a step with an old factor, relative to that of the previous step. If it falls less, a new factor is
  /// cheaper: it costs as much as about four steps with the old one.
  static constexpr double falls_fast = 0.1;

  // Steps in the trust region.

  /// Share of the predicted decrease from which on a step is accepted, as usual (Nocedal, Wright, algorithm 4.1, where
  /// it is below 1/4).
  static constexpr double accept_ratio = 0.1;
  /// Share from which on twice the radius is tried. It is lower than the usual 3/4, because a larger step costs no
  /// factorization: one basis is enough for all radii.
  static constexpr double grow_ratio = 0.5;
  /// Divisor of the radius after a bad step; 2 to 4 is usual.
  static constexpr double shrink = 3;
  /// Number of radii that are tried, shorter or longer. 30 change no shape on 300 random cases, where a step that is
  /// 3¹⁰ times shorter gains nothing.
  static constexpr int max_radii = 10;
  /// Number of vectors of the Krylov space, which take a few substitutions each. On 300 random cases, 8 take 4% more
  /// factorizations, and 30 no fewer.
  static constexpr int max_krylov_size = 15;
  /// Negative curvature, relative to that of the convex part, below which leaving a saddle gains nothing worthwhile.
  static constexpr double flat_curvature = 1e-4;
};

}  // namespace wirewarp
