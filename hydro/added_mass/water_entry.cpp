#include "hydro/added_mass/water_entry.h"

#include <algorithm>
#include <cmath>

#include "hydro/loads/clip.h"

namespace hydro {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

/// Deadrise from which on no water rises [rad].
constexpr double kSteepest = 75 * M_PI / 180;

/// Exponent m of a parabola, from which on a body nears one with walls [-].
constexpr double kParabola = 2;

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

Waterplane waterplane(const TriMesh& mesh_B, const WaterPlane& plane) {
  Waterplane cut;
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
  return cut;
}

double rise_at_entry(const Waterplane& cut) {
  if (!(cut.volume > 0) || !(cut.area > 0) || !(cut.perimeter > 0)) return 0;
  const double round = std::min(1.0, 4 * M_PI * cut.area / (cut.perimeter * cut.perimeter));
  const double e = round * round;
  const double growth = cut.area * cut.draught / cut.volume - 1;
  if (!(growth > 0)) return 0;
  const double exponent = (1 + e) / growth, m = std::min(exponent, kParabola);
  const double of_long = std::sqrt(M_PI) * std::tgamma(m / 2 + 1) / std::tgamma((m + 1) / 2) - 1;
  const double of_round =
      2 / std::sqrt(M_PI) * std::tgamma((m + 3) / 2) / std::tgamma(m / 2 + 1) - 1;
  const double half_breadth = (1 + e) * cut.area / cut.perimeter;
  const double deadrise = std::atan2(cut.draught, half_breadth);
  return std::lerp(of_long, of_round, e) * std::min(1.0, kParabola / exponent) *
         std::max(0.0, 1 - deadrise / kSteepest);
}

}  // namespace hydro
