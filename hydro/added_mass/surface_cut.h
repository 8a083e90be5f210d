#pragma once

#include <array>

#include "hydro/added_mass/water_entry.h"
#include "hydro/loads/kernel/load_inputs.h"
#include "hydro/loads/kernel/panels.h"
#include "hydro/loads/kernel/tree.h"

namespace hydro::kernel {

/// Rows of the sums of a cut: S, V, ∫ d dV, P, and ∫ {x, y, xx, xy, yy} dS of the waterplane in the
/// axes of HorizontalAxes.
enum : int {
  kCutArea,
  kCutVolume,
  kCutDepth,
  kCutPerimeter,
  kCutPlace,
  kCutSquare = kCutPlace + 2,
  kCutSums = kCutSquare + 3
};

/// Two unit vectors normal to the vertical and to each other, right-handed with it.
struct HorizontalAxes {
  explicit HorizontalAxes(const double (&up)[3]);
  double x[3], y[3];
};

/// Depth within which a vertex lies in the plane [m].
double level_within(const Tree& tree);

/// A cut by the sums of its rows, with (4) to (6) of water_entry.h.
SurfaceCut cut_of(const std::array<double, kCutSums>& sums);

/// The part of a hull that a plane of water cuts off, by the walk through the tree and in the
/// vector lanes of the loads.
SurfaceCut surface_cut(const Panels& panels, const Tree& tree, const WaterPlane& plane);

}  // namespace hydro::kernel
