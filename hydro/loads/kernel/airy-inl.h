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
/// lanes.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// What is asked of the water.
enum class Ask { velocity, acceleration };

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

/// The water at places of the given depth below the surface, as `LoadInputs` counts it.
/// Above the surface it goes on as its functions do.
/// @param rise   The elevation by `turns`: where C is 1, the head is the depth to the last bit.
template <Ask kAsk>
HWY_INLINE Water water_around(const LoadInputs& in, const V3& r, V depth, V rise,
                              const Turns& turns, double least_depth = -1e300) {
  constexpr bool kVelocity = kAsk == Ask::velocity;
  constexpr int kAlong = kVelocity ? WaveField::kFlow : WaveField::kVector;
  constexpr int kUp = kVelocity ? WaveField::kUpward : WaveField::kNumber;
  const WaveField& waves = in.surface->waves;
  const V3 up = all3(in.up);
  const V s = depth + all(in.surface->hidden_depth);
  const V level = all(in.below + in.surface->hidden_depth);
  const V down = stretched(waves, hn::Max(s, all(least_depth)), s - (level - dot(up, r)));
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
  Water water = {depth - (rise - phi), {total(u.x, up.x), total(u.y, up.y), total(u.z, up.z)}};
  if constexpr (kVelocity)
    if (in.surface->shear.moves) water.u = water.u + sheared(in.surface->shear, dot(up, r));
  return water;
}

/// The same, but that above the surface it is as at the surface.
template <Ask kAsk>
HWY_INLINE Water water_at(const LoadInputs& in, const V3& r, V depth, V rise, const Turns& turns) {
  return water_around<kAsk>(in, r, depth, rise, turns, 0);
}

/// The water at the corners of faces.
struct MovingWater {
  Values depth;  ///< Below the surface [m].
  Values head;
  V3 a, b, c;  ///< `Water::u` at the corners.
};

/// The water at the corners of pieces of faces.
template <Ask kAsk>
inline HWY_NOINLINE MovingWater water_at_corners(const LoadInputs& in, const Plane& p,
                                                 const Triangle& t, const Values& depth,
                                                 Turns& turns) {
  const auto at = [&](const V2& corner, V depth_there) HWY_ATTR {
    const V3 r = point_on(p, corner);
    const V rise = find_turns(in.surface->waves, r, turns);
    return water_at<kAsk>(in, r, depth_there, rise, turns);
  };
  const Water a = at(t.a, depth.a), b = at(t.b, depth.b), c = at(t.c, depth.c);
  return {depth, {a.head, b.head, c.head}, a.u, b.u, c.u};
}

/// The water at the vertices of a leaf. Each vertex is there once.
struct alignas(64) LeafWater {
  Depths depths;
  double head[3 * kLeafFaces];
  double u[3][3 * kLeafFaces];

  HWY_INLINE MovingWater at_faces(const LeafVertices& vertices, int lane) const {
    const D d;
    const hn::Rebind<std::int64_t, D> di;
    const auto corner = [&](const double* from, int i) HWY_ATTR {
      return hn::GatherIndex(d, from, hn::Load(di, vertices.of_face[i] + lane));
    };
    const auto vector = [&](int i) HWY_ATTR {
      return V3{corner(u[0], i), corner(u[1], i), corner(u[2], i)};
    };
    return {depths.at_faces(vertices, lane),
            {corner(head, 0), corner(head, 1), corner(head, 2)},
            vector(0),
            vector(1),
            vector(2)};
  }
};

template <Ask kAsk>
inline HWY_NOINLINE void find_water(const Panels& panels, const LoadInputs& in, const Node& leaf,
                                    Turns& turns, LeafWater& water) {
  const LeafVertices& vertices = panels.vertices[static_cast<std::size_t>(leaf.first)];
  int to = 0;
  for (int block = vertices.first; block < vertices.last; ++block)
    for (int lane = 0; lane < kMostLanes; lane += static_cast<int>(hn::Lanes(D()))) {
      const V3 r = load3(panels.blocks[static_cast<std::size_t>(block)].r, lane);
      const V rise = find_turns(in.surface->waves, r, turns);
      const V depth = all(in.below) + (rise - dot(all3(in.up), r));
      const Water at = water_at<kAsk>(in, r, depth, rise, turns);
      hn::Store(depth, D(), water.depths.at + to);
      hn::Store(at.head, D(), water.head + to);
      hn::Store(at.u.x, D(), water.u[0] + to);
      hn::Store(at.u.y, D(), water.u[1] + to);
      hn::Store(at.u.z, D(), water.u[2] + to);
      to += static_cast<int>(hn::Lanes(D()));
    }
}

// Faces ask for what they need of the water: depth and head are one where it is still.

HWY_INLINE const Values& depth_of(const Values& depth) { return depth; }
HWY_INLINE const Values& depth_of(const MovingWater& water) { return water.depth; }
HWY_INLINE const Values& head_of(const Values& depth) { return depth; }
HWY_INLINE const Values& head_of(const MovingWater& water) { return water.head; }

/// u·d at the corners.
HWY_INLINE Values along_of(const MovingWater& water, const V3& d) {
  return {dot(water.a, d), dot(water.b, d), dot(water.c, d)};
}

HWY_INLINE Values operator-(const Values& a, const Values& b) {
  return {a.a - b.a, a.b - b.b, a.c - b.c};
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
