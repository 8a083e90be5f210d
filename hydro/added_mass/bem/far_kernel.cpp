#include "hydro/added_mass/bem/far_kernel.h"

#include <algorithm>
#include <cstdint>

#include "hydro/added_mass/bem/quadrature.h"
#include "hydro/loads/kernel/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hydro/added_mass/bem/far_kernel.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

#include "hydro/added_mass/bem/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hydro::bem::HWY_NAMESPACE {

/// 1/√x to round-off: a first guess from the bits of x, then four steps of Newton's method. It uses
/// only operations that all processors offer.
HWY_INLINE V inverse_root(V x) {
  const hn::Rebind<std::uint64_t, D> bits;
  V root =
      hn::BitCast(D(), hn::Set(bits, 0x5fe6eb50c7b537a9) - hn::ShiftRight<1>(hn::BitCast(bits, x)));
  const V half = all(0.5) * x;
  for (int step = 0; step < 4; ++step) root = root * (all(1.5) - half * root * root);
  return root;
}

/// Integrates one part of the lanes by the points of a rule.
template <std::size_t N>
HWY_INLINE void pairs_by(const HatRule<N>& rule, const Element& a, const Batch& b,
                         const Lanes (&points)[N][3], Index part, LanePairs& pairs) {
  const V normal[3] = {load(b.normal[0], part), load(b.normal[1], part), load(b.normal[2], part)};
  V hats[3][3] = {{zero(), zero(), zero()}, {zero(), zero(), zero()}, {zero(), zero(), zero()}};
  V rise[3] = {zero(), zero(), zero()};
  for (std::size_t k = 0; k < N; ++k) {
    double x[3] = {};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        x[axis] += rule.at[k][i] * a.corners[i][static_cast<Index>(axis)];
    const V at[3] = {all(x[0]), all(x[1]), all(x[2])};
    V inner[3] = {zero(), zero(), zero()};  // Σ_l λ_j/r
    for (std::size_t l = 0; l < N; ++l) {
      const V dx = at[0] - load(points[l][0], part), dy = at[1] - load(points[l][1], part),
              dz = at[2] - load(points[l][2], part);
      const V inverse = inverse_root(dx * dx + dy * dy + dz * dz);
      for (std::size_t j = 0; j < 3; ++j) inner[j] = inner[j] + all(rule.hats[l][j]) * inverse;
    }
    const V along = at[0] * normal[0] + at[1] * normal[1] + at[2] * normal[2];
    const V raised = along * (inner[0] + inner[1] + inner[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      const V hat = all(rule.hats[k][i]);
      for (std::size_t j = 0; j < 3; ++j) hats[i][j] = hats[i][j] + hat * inner[j];
      rise[i] = rise[i] + hat * raised;
    }
  }
  const V scale = all(a.area) * load(b.area, part);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) store(hats[i][j] * scale, pairs.hats[i][j], part);
    store(rise[i] * scale, pairs.rise[i], part);
  }
}

void by_3_here(const Element& a, const Batch& b, LanePairs& pairs) {
  for (Index part = 0; part < kParts; ++part) pairs_by(hat_rule_3(), a, b, b.points_3, part, pairs);
}

void by_6_here(const Element& a, const Batch& b, LanePairs& pairs) {
  for (Index part = 0; part < kParts; ++part) pairs_by(hat_rule_6(), a, b, b.points_6, part, pairs);
}

HWY_INLINE void couple_part(const Element& a, const Batch& b, const LanePairs& pairs, Index part,
                            LaneCouplings& couplings) {
  V curls[3][3], hats[3][3];  // curl λ_i·curl λ_j, and the pairs' own
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      curls[i][j] = all(a.curls[i][0]) * load(b.curls[j][0], part) +
                    all(a.curls[i][1]) * load(b.curls[j][1], part) +
                    all(a.curls[i][2]) * load(b.curls[j][2], part);
      hats[i][j] = load(pairs.hats[i][j], part);
    }
  }
  V from_a[3], from_b[3];  // ∫∫ λ_i(x)/r and ∫∫ λ_j(y)/r
  for (std::size_t i = 0; i < 3; ++i) {
    from_a[i] = hats[i][0] + hats[i][1] + hats[i][2];
    from_b[i] = hats[0][i] + hats[1][i] + hats[2][i];
  }
  const V single = from_a[0] + from_a[1] + from_a[2], four = all(4), sixteen = all(16);
  auto& result = couplings.functions;
  // The curls are curl λ_i and, for the edge from corner i to j, 4 (λ_i curl λ_j + λ_j curl λ_i).
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      store(curls[i][k] * single, result[i][k], part);
      store(four * (curls[i][l] * from_b[k] + curls[i][k] * from_b[l]), result[i][3 + k], part);
      store(four * (curls[j][k] * from_a[i] + curls[i][k] * from_a[j]), result[3 + i][k], part);
      store(sixteen * (curls[j][l] * hats[i][k] + curls[j][k] * hats[i][l] +
                       curls[i][l] * hats[j][k] + curls[i][k] * hats[j][l]),
            result[3 + i][3 + k], part);
    }
  }
}

void couple_here(const Element& a, const Batch& b, const LanePairs& pairs,
                 LaneCouplings& couplings) {
  for (Index part = 0; part < kParts; ++part) couple_part(a, b, pairs, part, couplings);
}

HWY_INLINE void add_to(Lanes& sum, Index part, V value) {
  store(load(sum, part) + value, sum, part);
}

HWY_INLINE void add_moments_of_part(const Batch& b, const LanePairs& pairs, Index part,
                                    LaneRotationMoments& moments) {
  for (std::size_t i = 0; i < 3; ++i) {
    const V hats[3] = {load(pairs.hats[i][0], part), load(pairs.hats[i][1], part),
                       load(pairs.hats[i][2], part)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const V arm = hats[0] * load(b.corners[0][axis], part) +
                    hats[1] * load(b.corners[1][axis], part) +
                    hats[2] * load(b.corners[2][axis], part);
      for (std::size_t n = 0; n < 3; ++n)
        add_to(moments.hats[i][3 * axis + n], part, arm * load(b.normal[n], part));
    }
    add_to(moments.hats[i][9], part, load(pairs.rise[i], part));
  }
}

void add_moments_here(const Batch& b, const LanePairs& pairs, LaneRotationMoments& moments) {
  for (Index part = 0; part < kParts; ++part) add_moments_of_part(b, pairs, part, moments);
}

}  // namespace hydro::bem::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hydro::bem {

HWY_EXPORT(by_3_here);
HWY_EXPORT(by_6_here);
HWY_EXPORT(couple_here);
HWY_EXPORT(add_moments_here);

namespace {

using Eigen::Index;
using Eigen::Vector3d;

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
  if (far < kLanes) HWY_DYNAMIC_DISPATCH(by_6_here)(a, b, pairs);
  if (far == 0) return;
  HWY_DYNAMIC_DISPATCH(by_3_here)(a, b, far == kLanes ? pairs : by_3_points);
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

void couple(const Element& a, const Batch& b, const LanePairs& pairs, LaneCouplings& couplings) {
  HWY_DYNAMIC_DISPATCH(couple_here)(a, b, pairs, couplings);
}

void add_rotation_moments(const Batch& b, const LanePairs& pairs, LaneRotationMoments& moments) {
  HWY_DYNAMIC_DISPATCH(add_moments_here)(b, pairs, moments);
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
#endif
