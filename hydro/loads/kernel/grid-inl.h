// Included once for each processor: no include guard of the usual kind.
#if defined(PLIMSOLL_KERNEL_GRID) == defined(HWY_TARGET_TOGGLE)
#ifdef PLIMSOLL_KERNEL_GRID
#undef PLIMSOLL_KERNEL_GRID
#else
#define PLIMSOLL_KERNEL_GRID
#endif

#include "hydro/loads/kernel/lanes-inl.h"
#include "hydro/loads/kernel/tree-inl.h"
#include "hydro/loads/kernel/water_surface.h"

/// @file
/// The elevation of a grid. Anywhere, its heights are gathered for each place; over a few cells
/// nine numbers serve all places.

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// The first grid line of a cell and the place in it; beyond the grid that of its edge.
struct CellPlace {
  V line, part;
};

HWY_INLINE CellPlace cell_at(V place, std::int64_t lines) {
  const V held = hn::Max(zero(), hn::Min(place, all(static_cast<double>(lines - 1))));
  const V last = all(static_cast<double>(lines > 1 ? lines - 2 : 0));
  const V line = hn::Min(hn::Floor(held), last);
  return {line, held - line};
}

HWY_INLINE V grid_at(const GridField& grid, const V3& r) {
  const D d;
  const hn::Rebind<std::int64_t, D> di;
  const CellPlace u = cell_at(dot(all3(grid.e_x), r) + all(grid.u0), grid.columns);
  const CellPlace v = cell_at(dot(all3(grid.e_y), r) + all(grid.v0), grid.rows);
  const V rows = all(static_cast<double>(grid.rows));
  const auto corner = hn::ConvertTo(di, hn::MulAdd(u.line, rows, v.line));
  const std::int64_t right = grid.columns > 1 ? grid.rows : 0, up = grid.rows > 1 ? 1 : 0;
  const auto height = [&](std::int64_t offset)
                          HWY_ATTR { return hn::GatherIndex(d, grid.heights + offset, corner); };
  const V low = hn::MulAdd(u.part, height(right) - height(0), height(0));
  const V high = hn::MulAdd(u.part, height(right + up) - height(up), height(up));
  return hn::MulAdd(v.part, high - low, low);
}

/// A grid where one of its lines at most crosses each way, at p = u − u_line = 0 and q = 0. With
/// p⁺ = max(p, 0) the elevation is Σ c_ij {1, p, p⁺}_i {1, q, q⁺}_j.
struct GridPatch {
  double u_line, v_line;
  double c[3][3];
};

/// False if more lines than that cross a box.
HWY_INLINE bool set_patch(const GridField& grid, const Node& box, GridPatch& patch) {
  const Range u = range_over(box.centre, box.half, grid.e_x, 3, grid.u0);
  const Range v = range_over(box.centre, box.half, grid.e_y, 3, grid.v0);
  // Beyond its edge the grid goes on with the edge's height, as if it had more lines.
  const auto line = [](double low, std::int64_t lines) {
    return std::clamp(std::floor(low), -2.0, static_cast<double>(lines)) + 1;
  };
  patch.u_line = line(u.low, grid.columns);
  patch.v_line = line(v.low, grid.rows);
  if (!(u.high <= patch.u_line + 1 && v.high <= patch.v_line + 1)) return false;
  const auto held = [](double at, std::int64_t lines) {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(at), 0, lines - 1);
  };
  // From a function's values on three lines: its value on the middle one, its slope before that
  // line and the change of slope there.
  const auto hinge = [](double before, double on, double behind, double* c, int step) {
    c[0] = on;
    c[step] = on - before;
    c[2 * step] = behind - 2 * on + before;
  };
  double along[3][3];  // The coefficients of q, on the three columns.
  for (int i = 0; i < 3; ++i) {
    const double* column = grid.heights + held(patch.u_line + i - 1, grid.columns) * grid.rows;
    hinge(column[held(patch.v_line - 1, grid.rows)], column[held(patch.v_line, grid.rows)],
          column[held(patch.v_line + 1, grid.rows)], along[i], 1);
  }
  for (int j = 0; j < 3; ++j) hinge(along[0][j], along[1][j], along[2][j], patch.c[0] + j, 3);
  return true;
}

HWY_INLINE V patch_at(const GridPatch& patch, const GridField& grid, const V3& r) {
  const V p = dot(all3(grid.e_x), r) + all(grid.u0 - patch.u_line);
  const V q = dot(all3(grid.e_y), r) + all(grid.v0 - patch.v_line);
  const V on_p = hn::Max(p, zero()), on_q = hn::Max(q, zero());
  const auto along = [&](const double(&c)[3]) HWY_ATTR {
    return hn::MulAdd(all(c[2]), on_q, hn::MulAdd(all(c[1]), q, all(c[0])));
  };
  return hn::MulAdd(along(patch.c[2]), on_p, hn::MulAdd(along(patch.c[1]), p, along(patch.c[0])));
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
