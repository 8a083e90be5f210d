// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_SEA_TABLE) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_SEA_TABLE
#undef PLIMSOLL_KERNEL_SEA_TABLE
#else
#define PLIMSOLL_KERNEL_SEA_TABLE
#endif

#include "hydro/loads/kernel/airy-inl.h"
#include "hydro/loads/kernel/tree-inl.h"

/// @file
/// The sum of many waves over a branch of the tree as a table: its cost at a place does not depend
/// on the number of waves.
///
/// Over the branch's box the elevation is a polynomial of the places x, y along east and north, and
/// head and motion of the water are polynomials of x, y and the depth d = −z* at which the
/// functions of depth are taken. They interpolate the sums of airy_waves.h at Chebyshev's nodes.
/// With n nodes over 2h a wave of the number κ along that side is missed by its first coefficient
/// left out,
///
///     2 J_n(κh) ≈ 2 (κh/2)^n / n!,                                                            (1)
///
/// over the depth the same with k and I_n.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// The number of places for nodes along x: a multiple of the lanes of every vector unit.
constexpr int kTableRoom = (kMostTableNodes + kMostLanes - 1) / kMostLanes * kMostLanes;

struct SeaTable {
  static constexpr int kMostNodes = 768;  ///< The most nodes of a field, with those that fill rows.
  /// The fields: the head's part of the waves [m], and what `Ask` asks for east, north and up.
  enum : int { kHead, kEast, kNorth, kUp, kFields };

  int nodes[3];
  int row;           ///< Places of a row along x: a multiple of the lanes of every vector unit.
  double middle[3];  ///< Middle of x, y and d [m].
  double scale[3];   ///< One over the half sides [1/m].
  /// Coefficients, row by row and plan by plan; those that fill a row are 0.
  alignas(64) double elevation[kTableRoom * kMostTableNodes];
  alignas(64) double field[kFields][kMostNodes];

  int plan() const { return row * nodes[1]; }
  int size() const { return plan() * nodes[2]; }
};

/// Chebyshev's nodes of a number of them, and the matrix from values there to coefficients.
struct Chebyshev {
  double node[kMostTableNodes];
  /// [p][k]: what the value at node p adds to coefficient k; those that fill a row are 0.
  alignas(64) double to_coefficients[kMostTableNodes][kTableRoom];
};

inline const Chebyshev& chebyshev(int count) {
  static const auto all_counts = [] {
    std::array<Chebyshev, kMostTableNodes + 1> made{};
    for (int n = 1; n <= kMostTableNodes; ++n)
      for (int p = 0; p < n; ++p) {
        const double angle = M_PI * (p + 0.5) / n;
        Chebyshev& c = made[static_cast<std::size_t>(n)];
        c.node[p] = std::cos(angle);
        for (int i = 0; i < n; ++i)
          c.to_coefficients[p][i] = (i == 0 ? 1.0 : 2.0) / n * std::cos(i * angle);
      }
    return made;
  }();
  return all_counts[static_cast<std::size_t>(count)];
}

/// The number of nodes that (1) needs over a side of half length `half`; more than kMostTableNodes
/// if they do not do.
inline int nodes_over(const TableLimits& limits, int side, double half) {
  double power = half;
  for (int n = 2; n <= kMostTableNodes; ++n) {
    power *= half;
    if (limits.error[side][n] * power <= limits.allowed) return n;
  }
  return kMostTableNodes + 1;
}

/// Half the length of a branch's box along a direction [m].
inline double reach_along(const Node& node, const double (&direction)[3]) {
  return std::abs(direction[0]) * node.half[0] + std::abs(direction[1]) * node.half[1] +
         std::abs(direction[2]) * node.half[2];
}

inline double centre_along(const Node& node, const double (&direction)[3]) {
  return direction[0] * node.centre[0] + direction[1] * node.centre[1] +
         direction[2] * node.centre[2];
}

/// The depths of places d that are asked for over a branch [m].
struct DepthRange {
  double top, bottom;
};

/// @param reach   Reach of the branch from its middle over the plan [m].
inline DepthRange depth_of_water(const Node& node, const LoadInputs& in, double reach) {
  const WaterSurface& surface = *in.surface;
  const WaveField& waves = surface.waves;
  const double far = 0.5 * std::min(waves.height, waves.bends[0] * reach);
  const double rise = middle_rise(waves, node.centre);
  const double depth = in.below + surface.hidden_depth - centre_along(node, in.up) + rise;
  const double dz = reach_along(node, in.up);
  // The corners of a branch's box may lie above the water when its faces do not.
  double top = std::max(depth - dz - far, -0.25 * dz), bottom = std::max(depth + dz + far, 0.0);
  if (!waves.deep) {
    const double h = waves.water_depth;
    bottom = std::min(h, bottom * h / std::max(h - waves.height, 0.1 * h));
  }
  return {std::min(top, bottom), bottom};
}

/// Sets the box of a table over a branch and its nodes.
/// @return false if it would have too many
template <Ask kAsk>
inline bool plan_table(const Node& node, const LoadInputs& in, SeaTable& table) {
  const WaterSurface& surface = *in.surface;
  const TableLimits& limits = surface.table;
  if (!limits.pays) return false;
  const double least = 1e-9 * (node.half[0] + node.half[1] + node.half[2]);  // For a flat box.
  const auto set = [&](int side, double low, double high) {
    const double half = std::max(0.5 * (high - low), least);
    table.middle[side] = 0.5 * (low + high);
    table.scale[side] = 1 / half;
    table.nodes[side] = nodes_over(limits, side, half);
    return table.nodes[side] <= kMostTableNodes;
  };
  const double x = centre_along(node, surface.east), y = centre_along(node, surface.north);
  const double dx = reach_along(node, surface.east), dy = reach_along(node, surface.north);
  if (!set(0, x - dx, x + dx) || !set(1, y - dy, y + dy)) return false;
  table.nodes[2] = 1;
  table.middle[2] = 0;
  table.scale[2] = 1;
  if (kAsk != Ask::elevation) {
    const DepthRange depth = depth_of_water(node, in, std::hypot(dx, dy));
    if (!set(2, depth.top, depth.bottom)) return false;
  }
  table.row = (table.nodes[0] + kMostLanes - 1) / kMostLanes * kMostLanes;
  return table.size() <= SeaTable::kMostNodes;
}

/// Sets Chebyshev's polynomials at t.
template <class T>
HWY_INLINE void set_polynomials(T one, T t, int count, T* to) {
  to[0] = one;
  if (count > 1) to[1] = t;
  for (int i = 2; i < count; ++i) to[i] = (t + t) * to[i - 1] - to[i - 2];
}

/// The products of the polynomials of the plan at places.
struct PlanProducts {
  V at[kMostTableNodes * kMostTableNodes];
};

/// Sets the products. Returns the elevation there [m].
HWY_INLINE V rise_by_table(const SeaTable& table, const WaterSurface& surface, const V3& r,
                           PlanProducts& products) {
  V x[kMostTableNodes], y[kMostTableNodes];
  const auto part = [&](const double(&direction)[3], int side) HWY_ATTR {
    return (dot(all3(direction), r) - all(table.middle[side])) * all(table.scale[side]);
  };
  set_polynomials(all(1), part(surface.east, 0), table.nodes[0], x);
  set_polynomials(all(1), part(surface.north, 1), table.nodes[1], y);
  V rise = zero();
  for (int q = 0, i = 0; q < table.nodes[1]; ++q)
    for (int p = 0; p < table.nodes[0]; ++p, ++i) {
      products.at[i] = x[p] * y[q];
      rise = hn::MulAdd(all(table.elevation[table.row * q + p]), products.at[i], rise);
    }
  return rise;
}

/// The water at places of which the products are set. @param down   d there [m].
template <Ask kAsk>
HWY_INLINE Water water_by_table(const SeaTable& table, const LoadInputs& in,
                                const PlanProducts& products, V depth, V rise, V down) {
  const V t =
      hn::Max(all(-1), hn::Min(all(1), (down - all(table.middle[2])) * all(table.scale[2])));
  V z[kMostTableNodes];
  set_polynomials(all(1), t, table.nodes[2], z);
  V value[SeaTable::kFields];
  for (V& v : value) v = zero();
  for (int m = 0; m < table.nodes[2]; ++m) {
    V head = zero(), east = zero(), north = zero(), up = zero();
    for (int q = 0, i = 0; q < table.nodes[1]; ++q) {
      const int place = table.plan() * m + table.row * q;
      for (int p = 0; p < table.nodes[0]; ++p, ++i) {
        const auto at = [&](int f) HWY_ATTR { return all(table.field[f][place + p]); };
        const V product = products.at[i];
        head = hn::MulAdd(at(SeaTable::kHead), product, head);
        east = hn::MulAdd(at(SeaTable::kEast), product, east);
        north = hn::MulAdd(at(SeaTable::kNorth), product, north);
        up = hn::MulAdd(at(SeaTable::kUp), product, up);
      }
    }
    value[SeaTable::kHead] = hn::MulAdd(z[m], head, value[SeaTable::kHead]);
    value[SeaTable::kEast] = hn::MulAdd(z[m], east, value[SeaTable::kEast]);
    value[SeaTable::kNorth] = hn::MulAdd(z[m], north, value[SeaTable::kNorth]);
    value[SeaTable::kUp] = hn::MulAdd(z[m], up, value[SeaTable::kUp]);
  }
  const V unit = all(kAsk == Ask::velocity ? 1 : in.surface->gravity);
  const auto total = [&](int axis) HWY_ATTR {
    const V across = value[SeaTable::kEast] * all(in.surface->east[axis]) +
                     value[SeaTable::kNorth] * all(in.surface->north[axis]);
    return unit * hn::MulAdd(value[SeaTable::kUp], all(in.up[axis]), across);
  };
  return {depth - (rise - value[SeaTable::kHead]), {total(0), total(1), total(2)}};
}

/// Bounds of the elevation over a branch for which there is a table [m].
inline ElevationRange range_by_table(const SeaTable& table, const WaterSurface& surface,
                                     const Node& node) {
  double x[kMostTableNodes], y[kMostTableNodes], rise = 0;
  const auto part = [&](const double(&direction)[3], int side) {
    return (centre_along(node, direction) - table.middle[side]) * table.scale[side];
  };
  set_polynomials(1.0, part(surface.east, 0), table.nodes[0], x);
  set_polynomials(1.0, part(surface.north, 1), table.nodes[1], y);
  for (int q = 0; q < table.nodes[1]; ++q)
    for (int p = 0; p < table.nodes[0]; ++p)
      rise += table.elevation[table.row * q + p] * x[p] * y[q];
  const double far = surface.waves.bends[0] *
                     std::hypot(reach_along(node, surface.east), reach_along(node, surface.north));
  return {rise - far, rise + far};
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
