// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_SEA_TABLE_SUMS) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_SEA_TABLE_SUMS
#undef PLIMSOLL_KERNEL_SEA_TABLE_SUMS
#else
#define PLIMSOLL_KERNEL_SEA_TABLE_SUMS
#endif

#include "hydro/loads/kernel/sea_table-inl.h"

/// @file
/// The coefficients of tables of the sea: summed over all waves for a branch, or restricted from a
/// branch to a part of it.
///
/// Each wave is a product of functions of x, y and d, so its coefficients are products of those
/// along each side, and the sum over the waves needs no transform of the whole table.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// The polynomials of some waves along each side: of a·cos and a·sin along x, cos and sin along y,
/// C and S.
struct TableBlock {
  static constexpr int kWaves = 64;

  alignas(64) double x[2][kWaves][kTableRoom];
  alignas(64) double y[2][kMostTableNodes][kWaves];
  alignas(64) double depth[2][kMostTableNodes][kWaves];
  int first, count;
};

/// Turns values at the nodes into coefficients.
HWY_INLINE void transform(const Chebyshev& c, int nodes, const V* values, V* coefficients) {
  for (int k = 0; k < nodes; ++k) {
    coefficients[k] = zero();
    for (int p = 0; p < nodes; ++p)
      coefficients[k] = hn::MulAdd(all(c.to_coefficients[p][k]), values[p], coefficients[k]);
  }
}

/// Sets the coefficients of factor·cos and factor·sin of phase + turn·t, for waves in lanes.
/// @param put   put(which, k, coefficient) takes those of the cosine, 0, and of the sine, 1.
template <class Put>
HWY_INLINE void turn_polynomials(int nodes, V factor, V phase, V turn, Put put) {
  const Chebyshev& c = chebyshev(nodes);
  V values[2][kMostTableNodes], coefficients[kMostTableNodes];
  for (int p = 0; p < nodes; ++p) {
    const Turn t = turn_of(hn::MulAdd(turn, all(c.node[p]), phase));
    values[0][p] = factor * t.cosine;
    values[1][p] = factor * t.sine;
  }
  for (int which = 0; which < 2; ++which) {
    transform(c, nodes, values[which], coefficients);
    for (int k = 0; k < nodes; ++k) put(which, k, coefficients[k]);
  }
}

HWY_INLINE void set_block(const LoadInputs& in, const Node& node, const SeaTable& table,
                          TableBlock& block) {
  const WaveField& waves = in.surface->waves;
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const Chebyshev& c = chebyshev(table.nodes[2]);
  std::fill_n(block.x[0][0], 2 * TableBlock::kWaves * kTableRoom, 0.0);
  for (int i = 0; i < block.count; i += lanes) {
    const auto at = [&](int which) HWY_ATTR { return row(waves, which, block.first + i); };
    alignas(64) double lane[kMostLanes];
    // The middle of the box over the plan is the branch's centre.
    turn_polynomials(
        table.nodes[0], at(WaveField::kAmplitude), phases(waves, node.centre, block.first + i),
        at(WaveField::kEast) * all(1 / table.scale[0]), [&](int which, int k, V value) HWY_ATTR {
          hn::Store(value, d, lane);
          for (int j = 0; j < lanes; ++j) block.x[which][i + j][k] = lane[j];
        });
    turn_polynomials(
        table.nodes[1], all(1), zero(), at(WaveField::kEast + 1) * all(1 / table.scale[1]),
        [&](int which, int k, V value) HWY_ATTR { hn::Store(value, d, block.y[which][k] + i); });
    V values[2][kMostTableNodes], coefficients[kMostTableNodes];
    for (int m = 0; m < table.nodes[2]; ++m) {
      const V down = all(table.middle[2] + c.node[m] / table.scale[2]);
      const DepthFunctions f =
          depth_functions(waves, at(WaveField::kNumber), at(WaveField::kWeight), down);
      values[0][m] = f.C;
      values[1][m] = f.S;
    }
    for (int which = 0; which < 2; ++which) {
      transform(c, table.nodes[2], values[which], coefficients);
      for (int m = 0; m < table.nodes[2]; ++m)
        hn::Store(coefficients[m], d, block.depth[which][m] + i);
    }
  }
}

/// Adds a block of waves to the coefficients from p on along x, of one row q of the plan, of
/// kDepths plans from m on. Lanes are coefficients along x.
template <Ask kAsk, int kDepths>
HWY_INLINE void add_block(const WaveField& waves, const TableBlock& block, int p, int q, int m,
                          SeaTable& table) {
  constexpr bool kVelocity = kAsk == Ask::velocity;
  const D d;
  V head[kDepths], east[kDepths], north[kDepths], up[kDepths], elevation = zero();
  for (int k = 0; k < kDepths; ++k) head[k] = east[k] = north[k] = up[k] = zero();
  for (int i = 0; i < block.count; ++i) {
    const auto at = [&](int which) HWY_ATTR { return all(waves.row[which][block.first + i]); };
    const V cx = hn::Load(d, block.x[0][i] + p), sx = hn::Load(d, block.x[1][i] + p);
    const V cy = all(block.y[0][q][i]), sy = all(block.y[1][q][i]);
    const V cosine = hn::MulSub(cx, cy, sx * sy), sine = hn::MulAdd(sx, cy, cx * sy);
    const V along = kVelocity ? cosine * at(WaveField::kSpeed) : sine;
    const V upward =
        kVelocity ? sine * at(WaveField::kUpward) : zero() - cosine * at(WaveField::kNumber);
    const V to_east = along * at(WaveField::kEast), to_north = along * at(WaveField::kEast + 1);
    elevation = elevation + cosine;
    for (int k = 0; k < kDepths; ++k) {
      const V C = all(block.depth[0][m + k][i]);
      head[k] = hn::MulAdd(C, cosine, head[k]);
      east[k] = hn::MulAdd(C, to_east, east[k]);
      north[k] = hn::MulAdd(C, to_north, north[k]);
      up[k] = hn::MulAdd(all(block.depth[1][m + k][i]), upward, up[k]);
    }
  }
  const auto put = [&](V sum, double* to) HWY_ATTR { hn::Store(hn::Load(d, to) + sum, d, to); };
  const int place = p + table.row * q;
  if (m == 0) put(elevation, table.elevation + place);
  for (int k = 0; k < kDepths; ++k) {
    const int at = place + table.plan() * (m + k);
    put(head[k], table.field[SeaTable::kHead] + at);
    put(east[k], table.field[SeaTable::kEast] + at);
    put(north[k], table.field[SeaTable::kNorth] + at);
    put(up[k], table.field[SeaTable::kUp] + at);
  }
}

/// Adds a block of waves to all coefficients. Four depths at a time keep their sums in registers.
template <Ask kAsk>
HWY_INLINE void add_block(const WaveField& waves, const TableBlock& block, SeaTable& table) {
  for (int q = 0; q < table.nodes[1]; ++q)
    for (int p = 0; p < table.nodes[0]; p += static_cast<int>(hn::Lanes(D()))) {
      int m = 0;
      for (; m + 4 <= table.nodes[2]; m += 4) add_block<kAsk, 4>(waves, block, p, q, m, table);
      if (m + 2 <= table.nodes[2]) {
        add_block<kAsk, 2>(waves, block, p, q, m, table);
        m += 2;
      }
      if (m < table.nodes[2]) add_block<kAsk, 1>(waves, block, p, q, m, table);
    }
}

/// Sets a table that is planned over a branch.
template <Ask kAsk>
inline HWY_NOINLINE void set_table(const Node& node, const LoadInputs& in, SeaTable& table) {
  std::fill_n(table.elevation, table.plan(), 0.0);
  for (auto& field : table.field) std::fill_n(field, table.size(), 0.0);
  const WaveField& waves = in.surface->waves;
  TableBlock block;
  for (block.first = 0; block.first < waves.count; block.first += TableBlock::kWaves) {
    block.count = std::min(TableBlock::kWaves, waves.count - block.first);
    set_block(in, node, table, block);
    add_block<kAsk>(waves, block, table);
  }
}

/// The polynomials of a table along one side in those of a part of it.
struct Restriction {
  /// [k][j]: what coefficient k of the whole adds to coefficient j of the part.
  alignas(64) double of[kMostTableNodes][kTableRoom];
};

HWY_INLINE void set_restriction(const SeaTable& from, const SeaTable& to, int side,
                                Restriction& made) {
  const D d;
  const int nodes = to.nodes[side];
  const Chebyshev& c = chebyshev(nodes);
  double at[kMostTableNodes][kMostTableNodes];
  for (int p = 0; p < nodes; ++p) {
    const double place = to.middle[side] + c.node[p] / to.scale[side];
    set_polynomials(1.0, (place - from.middle[side]) * from.scale[side], from.nodes[side], at[p]);
  }
  for (int k = 0; k < from.nodes[side]; ++k)
    for (int j = 0; j < nodes; j += static_cast<int>(hn::Lanes(d))) {
      V sum = zero();
      for (int p = 0; p < nodes; ++p)
        sum = hn::MulAdd(all(at[p][k]), hn::Load(d, c.to_coefficients[p] + j), sum);
      hn::Store(sum, d, made.of[k] + j);
    }
}

/// Rows of some fields that are restricted at once, so that the adders work on several sums.
template <int kCount>
using Rows = std::array<double*, kCount>;

/// Sets rows to sums of `count` terms; add(k, i, f, sum) adds term k of field f from place i on.
/// The length is a multiple of the lanes.
template <int kCount, class Add>
HWY_INLINE void sum_rows(int count, int length, const Rows<kCount>& to, Add add) {
  const D d;
  for (int i = 0; i < length; i += static_cast<int>(hn::Lanes(d))) {
    V sum[kCount];
#pragma GCC unroll 4
    for (V& of_field : sum) of_field = zero();
    for (int k = 0; k < count; ++k) {
#pragma GCC unroll 4
      for (std::size_t f = 0; f < kCount; ++f) sum[f] = add(k, i, f, sum[f]);
    }
#pragma GCC unroll 4
    for (std::size_t f = 0; f < kCount; ++f) hn::Store(sum[f], d, to[f] + i);
  }
}

/// Sets rows to Σ_k of[k][j]·from[k]. The rows of `from` are `stride` apart.
template <int kCount>
HWY_INLINE void add_rows(const Restriction& factor, int j, int count,
                         const std::array<const double*, kCount>& from, int stride, int length,
                         const Rows<kCount>& to) {
  sum_rows<kCount>(count, length, to, [&](int k, int i, std::size_t f, V sum) HWY_ATTR {
    return hn::MulAdd(all(factor.of[k][j]), hn::Load(D(), from[f] + k * stride + i), sum);
  });
}

/// Restricts rows along x.
template <int kCount>
HWY_INLINE void restrict_rows(const Restriction& x, int count, const Rows<kCount>& from, int length,
                              const Rows<kCount>& to) {
  sum_rows<kCount>(count, length, to, [&](int k, int i, std::size_t f, V sum) HWY_ATTR {
    return hn::MulAdd(all(from[f][k]), hn::Load(D(), x.of[k] + i), sum);
  });
}

/// Restricts plans along y and x.
template <int kCount>
HWY_INLINE void restrict_plans(const SeaTable& from, const Restriction& x, const Restriction& y,
                               const std::array<const double*, kCount>& plans, const SeaTable& to,
                               const Rows<kCount>& made) {
  alignas(64) double lines[kCount][kTableRoom];
  Rows<kCount> line, row;
  for (std::size_t f = 0; f < kCount; ++f) line[f] = lines[f];
  for (int q = 0; q < to.nodes[1]; ++q) {
    add_rows<kCount>(y, q, from.nodes[1], plans, from.row, from.row, line);
    for (std::size_t f = 0; f < kCount; ++f) row[f] = made[f] + to.row * q;
    restrict_rows<kCount>(x, from.nodes[0], line, to.row, row);
  }
}

/// Sets a table that is planned over a part of another's branch.
inline HWY_NOINLINE void restrict_table(const SeaTable& from, SeaTable& to) {
  constexpr int kFields = SeaTable::kFields;
  Restriction x, y, z;
  set_restriction(from, to, 0, x);
  set_restriction(from, to, 1, y);
  set_restriction(from, to, 2, z);
  restrict_plans<1>(from, x, y, {from.elevation}, to, {to.elevation});
  alignas(64) double plans[kFields][kTableRoom * kMostTableNodes];
  std::array<const double*, kFields> fields, sources;
  Rows<kFields> plan, made;
  for (std::size_t f = 0; f < kFields; ++f) {
    fields[f] = from.field[f];
    sources[f] = plan[f] = plans[f];
  }
  for (int m = 0; m < to.nodes[2]; ++m) {
    add_rows<kFields>(z, m, from.nodes[2], fields, from.plan(), from.plan(), plan);
    for (std::size_t f = 0; f < kFields; ++f) made[f] = to.field[f] + to.plan() * m;
    restrict_plans<kFields>(from, x, y, sources, to, made);
  }
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
