// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_LOCAL) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_LOCAL
#undef PLIMSOLL_KERNEL_LOCAL
#else
#define PLIMSOLL_KERNEL_LOCAL
#endif

#include "hydro/loads/kernel/tree-inl.h"
#include "hydro/loads/kernel/waves-inl.h"

/// @file
/// The depth over a branch as a polynomial of the place, of second order: so its moments take it.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// Sets the rows of the depth to the waves' Taylor series about the middle of a branch, up to
/// second order, if what is left out is small enough. The error is at most |k·d|³/6 of an
/// amplitude, and its mean over a plane patch at most a quarter of its value at the ends.
inline bool set_local_waves(const Node& node, const LoadInputs& in, double (&depth)[kNormal]) {
  const WaveField& waves = in.surface->waves;
  const double* c = node.centre;
  const double size = std::sqrt(node.half[0] * node.half[0] + node.half[1] * node.half[1] +
                                node.half[2] * node.half[2]);
  if (waves.bends[2] * size * size * size / 24 > in.wave_error) return false;
  double value, g[3], h[6];  // ξ, its gradient and its second derivatives, in body axes.
  expand_waves(waves, c, value, g, h);
  // From powers of r − c to powers of r.
  const double hc[3] = {h[0] * c[0] + h[3] * c[1] + h[5] * c[2],
                        h[3] * c[0] + h[1] * c[1] + h[4] * c[2],
                        h[5] * c[0] + h[4] * c[1] + h[2] * c[2]};
  depth[kOne] = in.below + value;
  for (int a = 0; a < 3; ++a) {
    depth[kOne] += (0.5 * hc[a] - g[a]) * c[a];
    depth[kPlace + a] = g[a] - hc[a] - in.up[a];
    depth[kSquare + a] = 0.5 * h[a];
    depth[kSquare + 3 + a] = h[3 + a];
  }
  return true;
}

/// Sets the rows of the depth to the grid's surface, if a branch lies over one cell: exact, as it
/// is bilinear there. With p and q the place in the cell, h = h_0 + p h_p + q h_q + p q h_pq.
inline bool set_local_grid(const Node& node, const LoadInputs& in, double (&depth)[kNormal]) {
  if (in.wave_error == 0) return false;
  const GridField& grid = in.surface->grid;
  const double *e = grid.e_x, *f = grid.e_y;
  const Range u = range_over(node.centre, node.half, e, 3, grid.u0);
  const Range v = range_over(node.centre, node.half, f, 3, grid.v0);
  const double column = std::floor(u.low), row = std::floor(v.low);
  const bool one_cell = u.high <= column + 1 && v.high <= row + 1;
  const auto last = [](std::int64_t lines) { return static_cast<double>(lines - 2); };
  if (!one_cell || !(column >= 0 && row >= 0)) return false;
  if (!(column <= last(grid.columns) && row <= last(grid.rows))) return false;
  const double* near =
      grid.heights + static_cast<std::int64_t>(column) * grid.rows + static_cast<std::int64_t>(row);
  const double* far = near + grid.rows;
  const double h_p = far[0] - near[0], h_q = near[1] - near[0], h_pq = far[1] - near[1] - h_p;
  const double p0 = grid.u0 - column, q0 = grid.v0 - row;
  const double along_p = h_p + q0 * h_pq, along_q = h_q + p0 * h_pq;
  depth[kOne] = in.below + (near[0] + p0 * h_p + q0 * along_q);
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3;
    depth[kPlace + a] = along_p * e[a] + along_q * f[a] - in.up[a];
    depth[kSquare + a] = h_pq * e[a] * f[a];
    depth[kSquare + 3 + a] = h_pq * (e[a] * f[b] + e[b] * f[a]);
  }
  return true;
}

inline bool set_local_depth(const Node& node, const LoadInputs& in, double (&depth)[kNormal]) {
  return in.surface->is_grid() ? set_local_grid(node, in, depth) : set_local_waves(node, in, depth);
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
