// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp {

/// Constants of minimize(), each with the reason for its value. f is the objective; the slope of a step is the first
/// derivative of f along it.
struct NewtonConstants {
  // When to stop.

  /// Predicted decrease of f over f that a step must have. Lengths are exact at every step, so that only the shape
  /// gains from more digits, and f has rounding errors of 1e-13 on a million triangles.
  static constexpr double worthwhile = 1e-9;
  /// The same for shapes that others start from: without a cloth, for those of a cloth; with fixed seams, for those
  /// of elastic seams. On the samples 1e-2 takes a tenth more factorizations in all; 1 takes 16 instead of 10 on a
  /// quarter sphere.
  static constexpr double worthwhile_on_the_way = 0.1;
  /// f over the area, below which a shape is isometric: strains of 1e-11, a hundredth of what lengths are guaranteed
  /// to.
  static constexpr double isometric = 1e-22;
  /// Factorizations after which flipped triangles are not expected to open: twice as many change no verdict on 300
  /// random cases. There is a start that flips none (newton/injective_shape.h).
  static constexpr int patience = 30;

  // Newton steps.

  /// Slope over f, below which the Hessian hardly changes along a step: the next step can use the same factor. A tenth
  /// of it takes 1 % more factorizations.
  static constexpr double near_minimum = 1e-2;
  /// Slope of a step with an old factor over that of the step before. Where it falls less, a new factor is the cheaper
  /// way: it costs as much as about four steps with the old one.
  static constexpr double falls_fast = 0.1;

  // Steps in the trust region.

  /// Share of the decrease that the model predicts, from which on a step is taken: as usual (Nocedal, Wright,
  /// algorithm 4.1, where it is below 1/4).
  static constexpr double accept_ratio = 0.1;
  /// The same, from which on twice the radius is tried. Lower than the usual 3/4, because a larger step costs no
  /// factorization: one basis is enough for all radii.
  static constexpr double grow_ratio = 0.5;
  /// What the radius is divided by after a bad step: as usual, 2 to 4.
  static constexpr double shrink = 3;
  /// Radii that are tried, shorter or longer: 30 change no shape on 300 random cases, where a step 3¹⁰ times shorter
  /// gains nothing.
  static constexpr int max_radii = 10;
  /// Vectors of the Krylov space, a few substitutions each: on 300 random cases 8 take 4 % more factorizations, 30 no
  /// fewer.
  static constexpr int max_krylov_size = 15;
  /// Negative curvature over that of the convex part, below which leaving a saddle gains nothing worthwhile.
  static constexpr double flat_curvature = 1e-4;
};

}  // namespace wirewarp
