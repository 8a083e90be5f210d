#include "hydro/added_mass/bem/far_kernel.h"

#include <algorithm>

#include "hydro/added_mass/bem/quadrature.h"

namespace hydro::bem {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using LaneBits __attribute__((vector_size(kLanes * sizeof(double)))) = long long;

/// A rule's points, and its weights times the hat functions there.
template <std::size_t N>
struct HatRule {
  std::array<std::array<double, 3>, N> at;
  std::array<std::array<double, 3>, N> hats;

  explicit HatRule(const Rule& rule) {
    for (std::size_t k = 0; k < N; ++k) {
      for (std::size_t i = 0; i < 3; ++i) {
        at[k][i] = rule[k].at[static_cast<Index>(i)];
        hats[k][i] = rule[k].weight * at[k][i];
      }
    }
  }
};

const HatRule<3>& rule_3() {
  static const HatRule<3> rule(rule_of_degree_2());
  return rule;
}

const HatRule<6>& rule_6() {
  static const HatRule<6> rule(rule_of_degree_4());
  return rule;
}

/// 1/√x to round-off: a first guess from the bits of x, then four steps of Newton's method. It uses
/// only operations that all processors offer on eight lanes.
[[gnu::always_inline]] inline void inverse_root(const Lanes& x, Lanes& root) {
  const LaneBits bits = 0x5fe6eb50c7b537a9 - (reinterpret_cast<LaneBits>(x) >> 1);
  root = reinterpret_cast<Lanes>(bits);
  const Lanes half = 0.5 * x;
  for (int step = 0; step < 4; ++step) root = root * (1.5 - half * root * root);
}

template <std::size_t N>
[[gnu::always_inline]] inline void pairs_by(const HatRule<N>& rule, const Element& a,
                                            const Batch& b, const Lanes (&points)[N][3],
                                            LanePairs& pairs) {
  const Lanes zero = {};
  pairs = {{{zero, zero, zero}, {zero, zero, zero}, {zero, zero, zero}}, {zero, zero, zero}};
  for (std::size_t k = 0; k < N; ++k) {
    double x[3] = {};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        x[axis] += rule.at[k][i] * a.corners[i][static_cast<Index>(axis)];
    Lanes inner[3] = {zero, zero, zero};  // Σ_l λ_j/r
    for (std::size_t l = 0; l < N; ++l) {
      const Lanes dx = x[0] - points[l][0], dy = x[1] - points[l][1], dz = x[2] - points[l][2];
      Lanes inverse;
      inverse_root(dx * dx + dy * dy + dz * dz, inverse);
      for (std::size_t j = 0; j < 3; ++j) inner[j] += rule.hats[l][j] * inverse;
    }
    const Lanes along = x[0] * b.normal[0] + x[1] * b.normal[1] + x[2] * b.normal[2];
    const Lanes raised = along * (inner[0] + inner[1] + inner[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) pairs.hats[i][j] += rule.hats[k][i] * inner[j];
      pairs.rise[i] += rule.hats[k][i] * raised;
    }
  }
  const Lanes scale = a.area * b.area;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) pairs.hats[i][j] *= scale;
    pairs.rise[i] *= scale;
  }
}

/// curl λ_i·curl λ_j.
[[gnu::always_inline]] inline void products_of_curls(const Element& a, const Batch& b,
                                                     Lanes (&products)[3][3]) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      products[i][j] = a.curls[i][0] * b.curls[j][0] + a.curls[i][1] * b.curls[j][1] +
                       a.curls[i][2] * b.curls[j][2];
}

PLIMSOLL_VECTOR_CLONES
void by_3(const HatRule<3>& rule, const Element& a, const Batch& b, LanePairs& pairs) {
  pairs_by<3>(rule, a, b, b.points_3, pairs);
}

PLIMSOLL_VECTOR_CLONES
void by_6(const HatRule<6>& rule, const Element& a, const Batch& b, LanePairs& pairs) {
  pairs_by<6>(rule, a, b, b.points_6, pairs);
}

bool is_far_lane(const Element& a, const Batch& b, std::size_t k) {
  const double reach = kFar * (a.radius + b.radius[k]);
  double squared = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double d = a.centroid[static_cast<Index>(axis)] - b.centroid[axis][k];
    squared += d * d;
  }
  return squared > reach * reach;
}

void copy_lane(const LanePairs& from, std::size_t k, LanePairs& to) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) to.hats[i][j][k] = from.hats[i][j][k];
    to.rise[i][k] = from.rise[i][k];
  }
}

void set(Lanes (&point)[3], std::size_t k, const Vector3d& value) {
  for (std::size_t axis = 0; axis < 3; ++axis) point[axis][k] = value[static_cast<Index>(axis)];
}

}  // namespace

std::vector<Batch> batches_of(const std::vector<Element>& elements) {
  std::vector<Batch> batches((elements.size() + kLanes - 1) / kLanes);
  for (std::size_t f = 0; f < kLanes * batches.size(); ++f) {
    const Element& element = elements[std::min(f, elements.size() - 1)];
    Batch& batch = batches[f / kLanes];
    const std::size_t k = f % kLanes;
    for (std::size_t i = 0; i < 3; ++i) {
      set(batch.points_3[i], k, point(element.corners, rule_of_degree_2()[i]));
      set(batch.corners[i], k, element.corners[i]);
      set(batch.curls[i], k, element.curls[i]);
    }
    for (std::size_t i = 0; i < 6; ++i)
      set(batch.points_6[i], k, point(element.corners, rule_of_degree_4()[i]));
    set(batch.normal, k, element.normal);
    set(batch.centroid, k, element.centroid);
    batch.radius[k] = element.radius;
    // Copies have no area and contribute nothing.
    batch.area[k] = f < elements.size() ? element.area : 0;
  }
  return batches;
}

void pairs_by_points(const Element& a, const Batch& b, LanePairs& pairs) {
  std::size_t far = 0;
  LanePairs by_3_points;
  for (std::size_t k = 0; k < kLanes; ++k) far += is_far_lane(a, b, k);
  if (far < kLanes) by_6(rule_6(), a, b, pairs);
  if (far == 0) return;
  by_3(rule_3(), a, b, far == kLanes ? pairs : by_3_points);
  if (far == kLanes) return;
  for (std::size_t k = 0; k < kLanes; ++k)
    if (is_far_lane(a, b, k)) copy_lane(by_3_points, k, pairs);
}

void set_lane(const PairIntegrals& exact, std::size_t lane, LanePairs& pairs) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      pairs.hats[i][j][lane] = exact.hats(static_cast<Index>(i), static_cast<Index>(j));
    pairs.rise[i][lane] = exact.rise[static_cast<Index>(i)];
  }
}

Eigen::Matrix3d hats_of_lane(const LanePairs& pairs, std::size_t lane) {
  Eigen::Matrix3d hats;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      hats(static_cast<Index>(i), static_cast<Index>(j)) = pairs.hats[i][j][lane];
  return hats;
}

PLIMSOLL_VECTOR_CLONES
void couple(const Element& a, const Batch& b, const LanePairs& pairs, LaneCouplings& couplings) {
  Lanes curls[3][3];
  products_of_curls(a, b, curls);
  const auto& hats = pairs.hats;
  auto& result = couplings.functions;
  Lanes from_a[3], from_b[3];  // ∫∫ λ_i(x)/r and ∫∫ λ_j(y)/r
  for (std::size_t i = 0; i < 3; ++i) {
    from_a[i] = hats[i][0] + hats[i][1] + hats[i][2];
    from_b[i] = hats[0][i] + hats[1][i] + hats[2][i];
  }
  const Lanes single = from_a[0] + from_a[1] + from_a[2];
  // The curls are curl λ_i and, for the edge from corner i to j, 4 (λ_i curl λ_j + λ_j curl λ_i).
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      result[i][k] = curls[i][k] * single;
      result[i][3 + k] = 4 * (curls[i][l] * from_b[k] + curls[i][k] * from_b[l]);
      result[3 + i][k] = 4 * (curls[j][k] * from_a[i] + curls[i][k] * from_a[j]);
      result[3 + i][3 + k] = 16 * (curls[j][l] * hats[i][k] + curls[j][k] * hats[i][l] +
                                   curls[i][l] * hats[j][k] + curls[i][k] * hats[j][l]);
    }
  }
}

PLIMSOLL_VECTOR_CLONES
void add_rotation_moments(const Batch& b, const LanePairs& pairs, LaneRotationMoments& moments) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Lanes(&hats)[3] = pairs.hats[i];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Lanes arm = hats[0] * b.corners[0][axis] + hats[1] * b.corners[1][axis] +
                        hats[2] * b.corners[2][axis];
      for (std::size_t n = 0; n < 3; ++n) moments.hats[i][3 * axis + n] += arm * b.normal[n];
    }
    moments.hats[i][9] += pairs.rise[i];
  }
}

RotationMoments summed(const LaneRotationMoments& moments) {
  RotationMoments rotation_moments;
  const auto sum = [](const Lanes& lanes) {
    double whole = 0;
    for (std::size_t k = 0; k < kLanes; ++k) whole += lanes[k];
    return whole;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 9; ++k)
      rotation_moments[i](static_cast<Index>(k / 3), static_cast<Index>(k % 3)) =
          sum(moments.hats[i][k]);
    rotation_moments[i].diagonal().array() -= sum(moments.hats[i][9]);
  }
  return rotation_moments;
}

}  // namespace hydro::bem
