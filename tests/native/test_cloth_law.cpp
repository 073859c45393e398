// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <vector>

#include "base/planar.h"
#include "dense_algebra.h"
#include "energy/cloth_law.h"
#include "energy/shear_smoothing.h"
#include "newton/unfold.h"
#include "test_meshes.h"

namespace wirewarp::test_cloth_law {
namespace {

Cloth cloth_of(double weft, double warp, double shear) {
  Cloth cloth;
  cloth.weft = weft;
  cloth.warp = warp;
  cloth.shear = shear;
  return cloth;
}

/// Returns the map from the worn to the flat shape.
Eigen::Matrix2d map_of(const Eigen::Matrix2d& flat_to_worn) { return flat_to_worn.inverse(); }

Eigen::Matrix2d rows(double a, double b, double c, double d) { return (Eigen::Matrix2d() << a, b, c, d).finished(); }

const Cloth kDenim = cloth_of(0.21, 1, 0.06);
constexpr double kRounding = 1e-14;

/// Energies are per worn area. The worn area is the determinant of flat_to_worn times the flat area.
TEST(ClothLaw, ThreadsCostTheirStretchAndTheirRotation) {
  Cloth squeezed = kDenim;
  squeezed.squeeze = 3;
  const auto expect_energy = [](const Cloth& cloth, const Eigen::Matrix2d& flat_to_worn, double of_flat_area) {
    EXPECT_NEAR(ClothLaw(cloth).density(map_of(flat_to_worn)), of_flat_area / flat_to_worn.determinant(), kRounding);
  };
  for (const double t : {0.2, -0.2}) {
    expect_energy(kDenim, rows(1, 0, 0, 1 + t), 1 * t * t);
    expect_energy(kDenim, rows(1 + t, 0, 0, 1), 0.21 * t * t);
    expect_energy(squeezed, rows(1, 0, 0, 1 + t), (t < 0 ? 3 : 1) * t * t);
    expect_energy(kDenim, rows(1, std::sin(t), 0, std::cos(t)), 0.06 * std::sin(t) * std::sin(t));
  }
}

TEST(ClothLaw, StretchOnTheBiasCostsBothThreadsAndShear) {
  const double t = 0.3, both = std::pow(std::sqrt((1 + (1 + t) * (1 + t)) / 2) - 1, 2),
               turn = ((1 + t) * (1 + t) - 1) / 2;
  const Eigen::Matrix2d bias = Eigen::Rotation2Dd(kPi / 4).toRotationMatrix();
  const Eigen::Matrix2d stretched = bias * Eigen::Vector2d(1 + t, 1).asDiagonal() * bias.transpose();
  EXPECT_NEAR(ClothLaw(kDenim).density(map_of(stretched)), ((0.21 + 1) * both + 0.06 * turn * turn) / (1 + t),
              kRounding);
}

TEST(ClothLaw, ShearBeyondLockingCostsMore) {
  Cloth cloth = kDenim;
  cloth.locking = kPi / 6;  // the sine of this angle is 1/2
  const double sine = 0.8, cosine = 0.6, excess = sine - 0.5;
  EXPECT_NEAR(ClothLaw(cloth).density(map_of(rows(1, -sine, 0, cosine))),
              (0.06 * sine * sine + 10 * excess * excess) / cosine, kRounding);
  EXPECT_NEAR(ClothLaw(cloth).density(map_of(rows(1, 0.4, 0, 1))), ClothLaw(kDenim).density(map_of(rows(1, 0.4, 0, 1))),
              kRounding);
}

TEST(ClothLaw, OnlyRatiosOfStiffnessCount) {
  const Eigen::Matrix2d map = rows(1.1, 0.2, -0.1, 0.9);
  EXPECT_EQ(ClothLaw(cloth_of(0.21 * 1024, 1024, 0.06 * 1024)).density(map), ClothLaw(kDenim).density(map));
}

TEST(ClothLaw, TheEnergyDependsOnRotationsOfTheFlatSideOnly) {
  const Eigen::Matrix2d map = rows(1.1, 0.2, -0.1, 0.9), turn = Eigen::Rotation2Dd(0.7).toRotationMatrix();
  const ClothLaw law(kDenim);
  EXPECT_NEAR(law.density(map * turn), law.density(map), kRounding);
  EXPECT_GT(std::abs(law.density(turn * map) - law.density(map)), 1e-3);
}

TEST(ClothLaw, FlippedOrDegenerateTrianglesAreInfinite) {
  const ClothLaw law(kDenim);
  EXPECT_EQ(law.density(rows(1, 0, 0, -1)), std::numeric_limits<double>::infinity());
  EXPECT_EQ(law.density(rows(1, 0, 2, 0)), std::numeric_limits<double>::infinity());
  EXPECT_EQ(law.density(Eigen::Matrix2d::Zero()), std::numeric_limits<double>::infinity());
}

/// The ARAP energy is |J − R|². Its term of second order at rest, ½ dJ·H dJ, is the square of the symmetric part of dJ.
TEST(ClothLaw, IsotropicClothIsArapToSecondOrder) {
  const ClothLaw law(cloth_of(1, 1, 0.5));
  Eigen::Matrix4d arap;  // Hessian with respect to J₁₁, J₁₂, J₂₁, J₂₂
  arap << 2, 0, 0, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 2;
  const Eigen::Matrix2d rest = Eigen::Matrix2d::Identity();
  EXPECT_EQ(law.density(rest), 0);
  EXPECT_TRUE(law.gradient(rest).isZero(kRounding));
  EXPECT_TRUE(law.hessian(rest).isApprox(arap, kRounding));
}

class ClothLawOnRandomMaps : public testing::Test {
 protected:
  static Eigen::Vector4d flat(const Eigen::Matrix2d& m) { return {m(0, 0), m(0, 1), m(1, 0), m(1, 1)}; }

  static std::vector<Eigen::Matrix2d> maps() {
    std::vector<Eigen::Matrix2d> result;
    for (unsigned seed = 0; result.size() < 40; ++seed) {
      const Eigen::Matrix2d map = Eigen::Matrix2d::Identity() + 0.3 * test::random_normal(2, 2, seed);
      if (map.determinant() > 0.3) result.push_back(map);
    }
    return result;
  }

  static ClothLaw law() {
    Cloth cloth = kDenim;
    cloth.squeeze = 2;
    cloth.locking = 0.3;
    return ClothLaw(cloth);
  }
};

TEST_F(ClothLawOnRandomMaps, DerivativesEqualDifferences) {
  const double step = 1e-6;
  for (const Eigen::Matrix2d& map : maps()) {
    for (int k = 0; k < 4; ++k) {
      Eigen::Matrix2d d = Eigen::Matrix2d::Zero();
      d(k / 2, k % 2) = step;
      const double slope = (law().density(map + d) - law().density(map - d)) / (2 * step);
      EXPECT_NEAR(law().gradient(map)(k / 2, k % 2), slope, 1e-7 * (1 + std::abs(slope)));
      const Eigen::Vector4d bend = flat(law().gradient(map + d) - law().gradient(map - d)) / (2 * step);
      EXPECT_LT((law().hessian(map).col(k) - bend).norm(), 1e-6 * (1 + bend.norm()));
    }
  }
}

TEST_F(ClothLawOnRandomMaps, TheConvexHessianIsPositiveAndAboveTheExactHessian) {
  bool is_any_indefinite = false;
  for (const Eigen::Matrix2d& map : maps()) {
    const Eigen::MatrixXd exact = law().hessian(map), convex = law().convex_hessian(map);
    const double rounding = 1e-13 * exact.norm();
    EXPECT_GT(test::eigenvalues(convex).minCoeff(), -rounding);
    EXPECT_GT(test::eigenvalues(convex - exact).minCoeff(), -rounding);
    is_any_indefinite = is_any_indefinite || test::eigenvalues(exact).minCoeff() < -rounding;
  }
  EXPECT_TRUE(is_any_indefinite);
}

/// The unit square has two triangles with a common diagonal of length l = √2. The distance d of their centroids is
/// √2/3, so l/d = 3.
TEST(ShearSmoothing, AFoldCostsTheSquareOfItsAngle) {
  const Chart chart = test::chart_of(test::flat_rectangle(1, 1, 1, 1));  // diagonal from (0, 0) to (1, 1)
  const double slope = 0.3, height = std::sqrt(0.5);
  Positions2 uv = test::planar_positions(chart);
  uv(1, 0) += slope * height;  // the corner (1, 0)
  const double delta = 0.005, l_over_d = 3;
  const double expected = 0.5 * delta * delta * l_over_d * slope * slope;
  EXPECT_NEAR(shear_smoothing_of(chart).value(uv), expected, 1e-14 * expected);
}

TEST(ShearSmoothing, AnUnfoldedPieceCostsNothing) {
  const Chart chart = test::chart_of(test::cylinder_patch(7, 5, 1, 2, 1.5));
  EXPECT_LT(shear_smoothing_of(chart).value(unfold(chart).value().uv), 1e-28);
}

TEST(ShearSmoothing, GradientAndHessianAreThoseOfAQuadraticFunction) {
  const Chart chart = test::chart_of(test::saddle(4, 0.4));
  const ShearSmoothing smoothing = shear_smoothing_of(chart);
  Positions2 uv = test::planar_positions(chart);
  for (int v = 0; v < uv.rows(); ++v) uv.row(v) += 0.1 * Eigen::RowVector2d(std::sin(7 * v), std::cos(5 * v));
  Positions2 gradient = Positions2::Zero(uv.rows(), 2);
  const double value = smoothing.add_gradient(uv, gradient);
  EXPECT_EQ(value, smoothing.value(uv));
  EXPECT_NEAR((gradient.array() * uv.array()).sum() / 2, value, 1e-13 * value);

  std::vector<VertexPair> pairs;
  smoothing.list_pairs(pairs);
  for (const EdgeHandle e : chart.mesh.edges()) {
    const HalfedgeHandle h = chart.mesh.halfedge_handle(e, 0);
    pairs.push_back({chart.mesh.from_vertex_handle(h).idx(), chart.mesh.to_vertex_handle(h).idx()});
  }
  VertexMatrix matrix(static_cast<int>(uv.rows()), pairs);
  smoothing.add_hessian(matrix);
  const Eigen::MatrixXd hessian = test::symmetric(matrix.lower());
  const Eigen::VectorXd product = hessian * uv.reshaped<Eigen::RowMajor>();
  EXPECT_LT((product - gradient.reshaped<Eigen::RowMajor>()).norm(), 1e-13 * product.norm());
  EXPECT_NEAR(smoothing.value_of_rounding(0.1), 0.01 * hessian.trace() / 2, 1e-12 * hessian.trace());
}

}  // namespace
}  // namespace wirewarp::test_cloth_law
