#include "hydro/wave_sums.h"

#include <algorithm>
#include <cmath>

#include "hydro/loads/kernel/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hydro/wave_sums.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

#include "hydro/loads/kernel/pieces-inl.h"
#include "hydro/loads/kernel/wave_functions-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// Some waves in lanes; those that fill the last lanes have amplitude 0.
struct WavesInLanes {
  V amplitude, kx, ky, phase;  ///< The phase is θ at a place and time.
};

/// Angles that turn_of() takes with all digits [rad].
HWY_INLINE V reduced(V angle) {
  const D d;
  if (hn::AllTrue(d, hn::Abs(angle) < all(1e6))) return angle;
  alignas(64) double lane[kMostLanes];
  hn::Store(angle, d, lane);
  for (std::size_t i = 0; i < hn::Lanes(d); ++i) lane[i] = std::remainder(lane[i], 2 * M_PI);
  return hn::Load(d, lane);
}

/// Calls at_waves(some) for all waves of a surface over (x, y) at a time.
template <class AtWaves>
HWY_INLINE void for_waves(const WaveSurface& waves, double x, double y, double time,
                          AtWaves&& at_waves) {
  const D d;
  const std::size_t lanes = hn::Lanes(d), count = waves.components.size();
  alignas(64) double field[5][kMostLanes] = {};
  for (std::size_t first = 0; first < count; first += lanes) {
    const std::size_t some = std::min(lanes, count - first);
    for (std::size_t i = 0; i < lanes; ++i) {
      const WaveComponent& w = waves.components[first + std::min(i, some - 1)];
      field[0][i] = i < some ? w.amplitude : 0;
      field[1][i] = w.kx;
      field[2][i] = w.ky;
      field[3][i] = w.omega;
      field[4][i] = w.phase;
    }
    const V kx = hn::Load(d, field[1]), ky = hn::Load(d, field[2]);
    const V along = hn::MulAdd(kx, all(x), ky * all(y));
    const V phase = hn::NegMulAdd(hn::Load(d, field[3]), all(time), along);
    at_waves(WavesInLanes{hn::Load(d, field[0]), kx, ky, reduced(phase + hn::Load(d, field[4]))});
  }
}

double sum_elevation(const WaveSurface& waves, double x, double y, double time) {
  V height = zero();
  for_waves(waves, x, y, time, [&](const WavesInLanes& w) HWY_ATTR {
    height = hn::MulAdd(w.amplitude, turn_of(w.phase).cosine, height);
  });
  return hn::GetLane(hn::SumOfLanes(D(), height));
}

/// g/σ and 1/(1 + e^{−2kh}) of waves in lanes.
struct OfDepth {
  V speed, weight;
};

HWY_INLINE OfDepth of_depth(const Sea& sea, V k) {
  if (!(sea.depth < AiryWaves::kDeepest)) return {hn::Sqrt(all(sea.gravity) / k), all(1)};
  const D d;
  alignas(64) double number[kMostLanes], speed[kMostLanes];
  hn::Store(k, d, number);
  for (std::size_t i = 0; i < hn::Lanes(d); ++i)
    speed[i] = sea.gravity / intrinsic_frequency(number[i], sea.depth, sea.gravity);
  return {hn::Load(d, speed), all(1) / (all(1) + exponential(all(-2 * sea.depth) * k))};
}

/// The mean of cos(k·δ) over a box [-].
HWY_INLINE V mean_over(const WavesInLanes& w, const Eigen::Matrix3d& half_sides) {
  V mean = all(1);
  for (int i = 0; i < 3; ++i) {
    const V turn = hn::MulAdd(w.kx, all(half_sides(0, i)), w.ky * all(half_sides(1, i)));
    const M turns = turn != zero();
    const V safe = hn::IfThenElse(turns, turn, all(1));
    mean = hn::IfThenElse(turns, mean * (turn_of(safe).sine / safe), mean);
  }
  return mean;
}

void sum_water(const Sea& sea, const Eigen::Vector3d& p_W, double down,
               const Eigen::Matrix3d* half_sides, double time, WaterMotion& water) {
  const bool deep = !(sea.depth < AiryWaves::kDeepest);
  V head = zero(), east = zero(), north = zero(), up = zero();
  V to_east = zero(), to_north = zero(), upward = zero();
  const auto& waves = std::get<WaveSurface>(sea.surface);
  for_waves(waves, p_W.x(), p_W.y(), time, [&](const WavesInLanes& w) HWY_ATTR {
    const V squared = hn::MulAdd(w.kx, w.kx, w.ky * w.ky);
    const M waves_here = hn::And(squared > zero(), w.amplitude != zero());
    const V k = hn::IfThenElse(waves_here, hn::Sqrt(squared), all(1));
    V a = hn::IfThenElseZero(waves_here, w.amplitude);
    if (half_sides) a = a * mean_over(w, *half_sides);
    const Turn turn = turn_of(w.phase);
    const OfDepth depth = of_depth(sea, k);
    const V falls = exponential(zero() - k * all(down));
    const V rises = deep ? zero() : exponential(k * all(down - 2 * sea.depth));
    const V C = depth.weight * (falls + rises), S = depth.weight * (falls - rises);
    head = hn::MulAdd(a * (C - all(1)), turn.cosine, head);
    const V flow = a * depth.speed, cosine = C * turn.cosine, sine = C * turn.sine;
    east = hn::MulAdd(flow * cosine, w.kx, east);
    north = hn::MulAdd(flow * cosine, w.ky, north);
    up = hn::MulAdd(flow * turn.sine, k * S, up);
    to_east = hn::MulAdd(a * sine, w.kx, to_east);
    to_north = hn::MulAdd(a * sine, w.ky, to_north);
    upward = hn::NegMulAdd(a * turn.cosine, k * S, upward);
  });
  const auto sum = [](V v) HWY_ATTR { return hn::GetLane(hn::SumOfLanes(D(), v)); };
  water.head = sum(head);
  water.velocity = {sum(east), sum(north), sum(up)};
  water.acceleration = sea.gravity * Eigen::Vector3d(sum(to_east), sum(to_north), sum(upward));
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hydro {
namespace kernel {

HWY_EXPORT(sum_elevation);
HWY_EXPORT(sum_water);

}  // namespace kernel

double elevation_in_lanes(const WaveSurface& waves, double x, double y, double time) {
  using namespace kernel;
  return HWY_DYNAMIC_DISPATCH(sum_elevation)(waves, x, y, time);
}

WaterMotion airy_waves_in_lanes(const Sea& sea, const Eigen::Vector3d& p_W, double down,
                                const Eigen::Matrix3d* half_sides, double time) {
  using namespace kernel;
  const double factor = amplitude_factor(std::get<WaveSurface>(sea.surface), time);
  WaterMotion water;
  HWY_DYNAMIC_DISPATCH(sum_water)(sea, p_W, down, half_sides, time, water);
  return {factor * water.head, factor * water.velocity, factor * water.acceleration};
}

}  // namespace hydro
#endif
