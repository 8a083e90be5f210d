// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_AIRY) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_AIRY
#undef PLIMSOLL_KERNEL_AIRY
#else
#define PLIMSOLL_KERNEL_AIRY
#endif

#include "hydro/loads/kernel/waves-inl.h"

/// @file
/// The water under Airy waves (airy_waves.h) and of a current that changes with depth, at places in
/// lanes: the sums over all waves.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// Quantities of the water that are asked for: its elevation alone, or its head and velocity or
/// acceleration.
enum class Ask { elevation, velocity, acceleration };

/// The water at a place.
struct Water {
  V head;  ///< p/(ρg), but for a constant [m].
  V3 u;    ///< Velocity relative to `Sea::current` [m/s], or acceleration [m/s^2]; body axes.
};

/// Depth below the level at which the functions of depth are taken: −z* of Wheeler's stretching.
/// @param s      Depth below the surface [m].
/// @param rise   Elevation of the surface [m].
HWY_INLINE V stretched(const WaveField& waves, V s, V rise) {
  if (waves.deep) return s;
  const V h = all(waves.water_depth);
  return hn::Min(h, s * h / hn::Max(h + rise, all(1e-300)));
}

/// C and S of (2) there, for one wave.
struct DepthFunctions {
  V C, S;
};

HWY_INLINE DepthFunctions depth_functions(const WaveField& waves, V k, V weight, V down) {
  const V falls = exponential(hn::NegMulAdd(k, down, zero()));
  if (waves.deep) return {falls, falls};
  const V rises = exponential(k * (down - all(2 * waves.water_depth)));
  return {weight * (falls + rises), weight * (falls - rises)};
}

/// Cosine and sine of the phases of all waves at places in lanes. The elevation is found from them
/// before the depth of a place is known, and the motion of the water after it.
class Turns {
 public:
  explicit Turns(const LoadInputs& in) {
    const auto waves = static_cast<std::size_t>(in.surface ? in.surface->waves.count : 0);
    if (waves > WaveField::kRoom) many_.resize(2 * waves * kMostLanes);
    at_ = many_.empty() ? few_ : many_.data();
  }
  Turns(const Turns&) = delete;
  Turns& operator=(const Turns&) = delete;

  HWY_INLINE void set(int wave, const Turn& turn) {
    hn::StoreU(turn.cosine, D(), at(2 * wave));
    hn::StoreU(turn.sine, D(), at(2 * wave + 1));
  }
  HWY_INLINE Turn operator[](int wave) const {
    return {hn::LoadU(D(), at(2 * wave)), hn::LoadU(D(), at(2 * wave + 1))};
  }

 private:
  HWY_INLINE double* at(int row) const {
    return at_ + static_cast<std::ptrdiff_t>(row) * kMostLanes;
  }

  double few_[2 * WaveField::kRoom * kMostLanes];
  std::vector<double> many_;
  double* at_;
};

/// Sets the turns at places. Returns the elevation of the surface there [m].
HWY_INLINE V find_turns(const WaveField& waves, const V3& r, Turns& turns) {
  V rise = zero();
  for (int i = 0; i < waves.count; ++i) {
    if (waves.row[WaveField::kAmplitude][i] == 0) continue;
    const auto row = [&](int which) HWY_ATTR { return all(waves.row[which][i]); };
    V phase = hn::MulAdd(row(WaveField::kVector), r.x, row(WaveField::kPhase));
    phase = hn::MulAdd(row(WaveField::kVector + 1), r.y, phase);
    const Turn turn = turn_of(hn::MulAdd(row(WaveField::kVector + 2), r.z, phase));
    turns.set(i, turn);
    rise = hn::MulAdd(row(WaveField::kAmplitude), turn.cosine, rise);
  }
  return rise;
}

/// (1) of shear.h at heights above the centre of mass.
HWY_INLINE V3 sheared(const Shear& shear, V height) {
  V3 u = all3(shear.first);
  for (const Shear::Layer& layer : shear.layers) {
    const V down = (all(layer.top) - height) * all(layer.rate);
    const V part = hn::Min(all(1), hn::Max(zero(), down));
    u = {hn::MulAdd(part, all(layer.change[0]), u.x), hn::MulAdd(part, all(layer.change[1]), u.y),
         hn::MulAdd(part, all(layer.change[2]), u.z)};
  }
  return u;
}

/// The water by all waves at places, without the shear of the current.
/// @param down   The depth below the level at which the functions of depth are taken.
template <Ask kAsk>
HWY_INLINE Water water_by_waves(const LoadInputs& in, V depth, V rise, V down, const Turns& turns) {
  constexpr bool kVelocity = kAsk == Ask::velocity;
  constexpr int kAlong = kVelocity ? WaveField::kFlow : WaveField::kVector;
  constexpr int kUp = kVelocity ? WaveField::kUpward : WaveField::kNumber;
  const WaveField& waves = in.surface->waves;
  const V3 up = all3(in.up);
  V phi = zero(), upward = zero();
  V3 u = {zero(), zero(), zero()};
  for (int i = 0; i < waves.count; ++i) {
    if (waves.row[WaveField::kAmplitude][i] == 0) continue;
    const auto row = [&](int which) HWY_ATTR { return all(waves.row[which][i]); };
    const auto [cosine, sine] = turns[i];
    const auto [C, S] =
        depth_functions(waves, row(WaveField::kNumber), row(WaveField::kWeight), down);
    const V a = row(WaveField::kAmplitude), a_C = a * C;
    phi = hn::MulAdd(a_C, cosine, phi);
    const V along = a_C * (kVelocity ? cosine : sine);
    u = {hn::MulAdd(along, row(kAlong), u.x), hn::MulAdd(along, row(kAlong + 1), u.y),
         hn::MulAdd(along, row(kAlong + 2), u.z)};
    upward = hn::MulAdd(a * S * (kVelocity ? sine : zero() - cosine), row(kUp), upward);
  }
  const V unit = all(kVelocity ? 1 : in.surface->gravity);
  const auto total = [&](V along, V vertical)
                         HWY_ATTR { return unit * hn::MulAdd(upward, vertical, along); };
  return {depth - (rise - phi), {total(u.x, up.x), total(u.y, up.y), total(u.z, up.z)}};
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
