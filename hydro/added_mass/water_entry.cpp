#include "hydro/added_mass/water_entry.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hydro/loads/clip.h"

namespace hydro {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

/// Deadrise from which on no water rises [rad].
constexpr double kSteepest = 75 * M_PI / 180;

/// Deadrise at which (3) would leave nothing of a plate [rad].
constexpr double kNoPlate = 185 * M_PI / 180;

/// Exponent m of a parabola, from which on a body nears one with walls [-].
constexpr double kParabola = 2;

constexpr double kWalls = std::numeric_limits<double>::infinity();

/// Exponent m of a body below a cut: how half-breadths grow.
double exponent(const SurfaceCut& cut) {
  if (!(cut.volume > 0) || !(cut.area > 0) || !(cut.half_breadth > 0)) return kWalls;
  const double growth = cut.area * cut.draught / cut.volume - 1;
  return growth > 0 ? (1 + cut.round) / growth : kWalls;
}

/// Length of the edges of a part that the cut made [m].
double cut_length(const PanelPart& part) {
  double length = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (part.value[static_cast<Index>(i)] == 0 && part.value[static_cast<Index>(j)] == 0)
      length += (part.panel[j] - part.panel[i]).norm();
  }
  return length;
}

}  // namespace

SurfaceCut surface_cut(const TriMesh& mesh_B, const WaterPlane& plane) {
  SurfaceCut cut;
  if (!plane.bounded()) return cut;
  cut.volume = wetted_volume(mesh_B, plane);
  for (Index face = 0; face < mesh_B.face_count(); ++face) {
    Panel panel;
    Vector3d depths;
    for (Index i = 0; i < 3; ++i) {
      panel[static_cast<std::size_t>(i)] = mesh_B.vertices.col(mesh_B.faces(i, face));
      depths[i] = plane.depth(panel[static_cast<std::size_t>(i)]);
    }
    cut.draught = std::max(cut.draught, depths.maxCoeff());
    for (const PanelPart& part : positive_part(panel, depths)) {
      cut.area -= plane.up.dot(area_vector(part.panel));
      cut.perimeter += cut_length(part);
    }
  }
  if (!(cut.perimeter > 0)) return cut;
  const double compact = std::min(1.0, 4 * M_PI * cut.area / (cut.perimeter * cut.perimeter));
  cut.round = compact * compact;
  cut.half_breadth = (1 + cut.round) * cut.area / cut.perimeter;
  cut.plate = cut.area * cut.area / cut.perimeter;
  return cut;
}

double rise_at_entry(const SurfaceCut& cut) {
  const double of_form = exponent(cut);
  if (!(of_form < kWalls)) return 0;
  const double m = std::min(of_form, kParabola);
  const double of_long = std::sqrt(M_PI) * std::tgamma(m / 2 + 1) / std::tgamma((m + 1) / 2) - 1;
  const double of_round =
      2 / std::sqrt(M_PI) * std::tgamma((m + 3) / 2) / std::tgamma(m / 2 + 1) - 1;
  const double deadrise = std::atan2(cut.draught, cut.half_breadth);
  return std::lerp(of_long, of_round, cut.round) * std::min(1.0, kParabola / of_form) *
         std::max(0.0, 1 - deadrise / kSteepest);
}

double heave_at_entry(const SurfaceCut& risen) {
  const double of_form = exponent(risen);
  if (!(of_form < kWalls)) return risen.plate;
  const double deadrise =
      std::atan2(std::min(of_form, kParabola) * risen.draught, risen.half_breadth);
  return risen.plate * (1 - std::min(1.0, kParabola / of_form) * deadrise / kNoPlate);
}

}  // namespace hydro
