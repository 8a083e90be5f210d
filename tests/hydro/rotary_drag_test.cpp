#include "hydro/loads/rotary_drag.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "hydro/loads/viscous_drag.h"
#include "tests/support/random_pose.h"
#include "tests/support/reference_loads.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Vector3d;
using hydro::Panel;
using hydro::Twist;
using hydro::ViscousDrag;
using hydro::Wrench;
using support::Vector3l;

const ViscousDrag kConstant{.law = ViscousDrag::Law::constant, .coefficient = 0.3};
const ViscousDrag kThesis{.law = ViscousDrag::Law::thesis};

/// What viscous_drag.h promises of laws with a closed form.
constexpr double kPromised = 1e-9;

struct TurningPanel {
  Panel panel;
  Vector3d normal;
  Twist motion;
  Vector3d pole;

  /// A random panel that turns at `spin` about a point of its plane, with more motion that leaves
  /// its tangential velocity alone.
  TurningPanel(support::Random& random, const Vector3d& weights, double spin)
      : panel{random.vector(2), random.vector(2), random.vector(2)},
        normal(hydro::area_vector(panel).normalized()),
        pole(weights[0] * panel[0] + weights[1] * panel[1] + weights[2] * panel[2]) {
    const Vector3d other = random.vector(3);
    motion.angular = spin * normal + other - other.dot(normal) * normal;
    motion.linear = -motion.angular.cross(pole) + random.vector(3).x() * normal;
  }

  double fastest() const {
    double farthest = 0;
    for (const Vector3d& r : panel) farthest = std::max(farthest, (r - pole).norm());
    return std::abs(motion.angular.dot(normal)) * farthest;
  }
};

/// The six-point Gauss rule on each of `splits` equal parts of 0 … 1.
template <class Function>
void composite(int splits, Function&& visit) {
  constexpr std::array<long double, 3> x = {0.2386191860831969086L, 0.6612093864662645137L,
                                            0.9324695142031520278L};
  constexpr std::array<long double, 3> w = {0.4679139345726910474L, 0.3607615730481386076L,
                                            0.1713244923791703450L};
  for (int i = 0; i < splits; ++i) {
    for (int j = 0; j < 3; ++j) {
      visit((i + (1 - x[j]) / 2) / splits, w[j] / 2 / splits);
      visit((i + (1 + x[j]) / 2) / splits, w[j] / 2 / splits);
    }
  }
}

struct Sum {
  Vector3l force = Vector3l::Zero();
  Vector3l moment = Vector3l::Zero();
};

/// The traction integrated over the triangle of the pole and an edge, along rays from the pole that
/// are cut where the law has a kink, so that each piece is a polynomial of the distance. Between
/// the rays the rule is composite. A triangle that is seen from behind counts negatively.
void add_fan(const TurningPanel& c, int edge, const ViscousDrag& law, Sum& sum) {
  const Vector3l pole = c.pole.cast<long double>();
  const Vector3l n = c.normal.cast<long double>();
  const Vector3l a = c.panel[edge].cast<long double>() - pole;
  const Vector3l b = c.panel[(edge + 1) % 3].cast<long double>() - pole;
  const long double twice_area = a.cross(b).dot(n);
  const long double spin = c.motion.angular.dot(c.normal);
  composite(400, [&](long double u, long double weight) {
    const Vector3l end = a + u * (b - a);
    long double from = 0;
    for (const long double speed : {1.0L, 2.0L, 1e9L}) {
      const long double to = std::min(1.0L, speed / (std::abs(spin) * end.norm()));
      composite(1, [&](long double x, long double radial) {
        const long double part = from + x * (to - from);
        const Vector3l r = pole + part * end;
        const Vector3l v = spin * n.cross(part * end);
        const double c_v = hydro::viscous_coefficient(law, static_cast<double>(v.norm()));
        const Vector3l traction =
            twice_area * weight * radial * (to - from) * part * c_v * v.norm() * v;
        sum.force += traction;
        sum.moment += r.cross(traction);
      });
      from = to;
    }
  });
}

/// @return  The largest of the errors of force and moment, as parts of the largest possible load.
double error_of(const TurningPanel& c, const ViscousDrag& law) {
  Sum expected;
  for (int edge = 0; edge < 3; ++edge) add_fan(c, edge, law, expected);
  const Wrench load = hydro::viscous_drag_load(c.panel, c.normal, c.motion, law, 1);
  const double largest = hydro::area_vector(c.panel).norm() * hydro::viscous_coefficient(law, 0) *
                         c.fastest() * c.fastest();
  const double arm = 2 * std::sqrt(3.0);
  return std::max((load.force + expected.force.cast<double>()).norm() / largest,
                  (load.moment + expected.moment.cast<double>()).norm() / (largest * arm));
}

const std::array<Vector3d, 6> kPoles = {Vector3d(0.2, 0.5, 0.3), Vector3d(0.5, 0.5, 0),
                                        Vector3d(1, 0, 0),       Vector3d(1.4, -0.3, -0.1),
                                        Vector3d(2, -1, 0),      Vector3d(-6, 3, 4)};

TEST(RotaryDrag, MatchesQuadratureAboutThePoleForAConstantCoefficient) {
  support::Random random(30);
  for (const Vector3d& pole : kPoles)
    EXPECT_LT(error_of(TurningPanel(random, pole, -1.7), kConstant), support::tolerance(kPromised));
}

TEST(RotaryDrag, MatchesQuadratureAboutThePoleAcrossTheKinksOfTheThesisLaw) {
  support::Random random(31);
  for (const Vector3d& pole : kPoles) {
    for (const double spin : {0.3, 1.0, -3.0}) {
      EXPECT_LT(error_of(TurningPanel(random, pole, spin), kThesis), support::tolerance(kPromised))
          << "pole " << pole.transpose() << ", spin " << spin;
    }
  }
}

TEST(RotaryDrag, HandsOverToTheQuadratureWithoutLosingDigits) {
  support::Random random(32);
  for (double distance = 2; distance < 2000; distance *= 1.7) {
    const Vector3d weights(1.0 / 3 + distance, 1.0 / 3 - distance / 2, 1.0 / 3 - distance / 2);
    TurningPanel c(random, weights, 1);
    const double slow = 0.9 / c.fastest();  // The panel's fastest point is below the first kink.
    for (const double factor : {slow, 1.3 * slow}) {
      const TurningPanel turned = [&] {
        TurningPanel scaled = c;
        scaled.motion.linear *= factor;
        scaled.motion.angular *= factor;
        return scaled;
      }();
      EXPECT_LT(error_of(turned, kConstant), support::tolerance(kPromised)) << distance;
      EXPECT_LT(error_of(turned, kThesis), support::tolerance(kPromised)) << distance;
    }
  }
}

/// Rounding of some dozen operations, and of the differences of r's powers.
constexpr double kRotaryRounding = 1e-13;

TEST(RotaryDrag, OfASquareAboutItsMiddleHasTheTorqueOfItsThirdMoment) {
  const double edge = 1.4;
  const double spin = -2.5;
  const std::array<Vector3d, 4> corner = {
      Vector3d(edge / 2, edge / 2, 0), Vector3d(-edge / 2, edge / 2, 0),
      Vector3d(-edge / 2, -edge / 2, 0), Vector3d(edge / 2, -edge / 2, 0)};
  const Twist motion{Vector3d(0, 0, 3), Vector3d(0, 0, spin)};
  Wrench sum;
  for (const Panel& panel :
       {Panel{corner[0], corner[1], corner[2]}, Panel{corner[0], corner[2], corner[3]}})
    sum += hydro::viscous_drag_load(panel, Vector3d::UnitZ(), motion, kConstant, 500);
  // ∫ r³ dA over the unit square about its centre.
  const double moment = (7 * std::sqrt(2.0) / 8 + 3.0 / 8 * std::log(1 + std::sqrt(2.0))) / 20;
  const double expected = 500 * 0.3 * spin * spin * std::pow(edge, 5) * moment;
  EXPECT_NEAR(sum.moment.z(), expected, support::tolerance(kRotaryRounding) * expected);
  EXPECT_LT(sum.force.norm(), support::tolerance(kRotaryRounding) * expected);
}

TEST(RotaryDrag, SplittingAPanelChangesNothing) {
  support::Random random(33);
  for (const Vector3d& pole : kPoles) {
    const TurningPanel c(random, pole, 1.1);
    const Vector3d inside = 0.2 * c.panel[0] + 0.45 * c.panel[1] + 0.35 * c.panel[2];
    Wrench parts;
    for (int i = 0; i < 3; ++i)
      parts += hydro::viscous_drag_load({c.panel[i], c.panel[(i + 1) % 3], inside}, c.normal,
                                        c.motion, kThesis, 500);
    const Wrench whole = hydro::viscous_drag_load(c.panel, c.normal, c.motion, kThesis, 500);
    const double scale = 500 * 0.1 * hydro::area_vector(c.panel).norm() * c.fastest() * c.fastest();
    EXPECT_LT((whole.force - parts.force).norm(), support::tolerance(kPromised) * scale);
    EXPECT_LT((whole.moment - parts.moment).norm(), support::tolerance(kPromised) * scale * 4);
  }
}

TEST(RotaryDrag, OpposesTheMotionAndTurnsWithItsSign) {
  support::Random random(34);
  for (const Vector3d& pole : kPoles) {
    TurningPanel c(random, pole, 0.8);
    const Wrench ahead = hydro::viscous_drag_load(c.panel, c.normal, c.motion, kConstant, 500);
    EXPECT_LT(ahead.force.dot(c.motion.linear) + ahead.moment.dot(c.motion.angular), 0);
    c.motion.linear *= -1;
    c.motion.angular *= -1;
    const Wrench astern = hydro::viscous_drag_load(c.panel, c.normal, c.motion, kConstant, 500);
    EXPECT_LT((ahead.force + astern.force).norm(),
              support::tolerance(kRotaryRounding) * ahead.force.norm());
  }
}

TEST(RotaryDrag, OfAPanelWithoutAreaVanishes) {
  const Vector3d a(0.3, 0.1, 0);
  const Vector3d b(-0.5, 0.7, 0);
  const Twist motion{Vector3d(0.2, 0, 1), Vector3d(0.1, 0, 2)};
  for (const Panel& panel : {Panel{a, a, a}, Panel{a, b, a}, Panel{a, 0.5 * (a + b), b}}) {
    const Wrench load = hydro::viscous_drag_load(panel, Vector3d::UnitZ(), motion, kThesis, 500);
    EXPECT_LT(load.force.norm() + load.moment.norm(), support::tolerance(1e-12));
  }
}

}  // namespace
