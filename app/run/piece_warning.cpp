#include "app/run/piece_warning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/motion/locks.h"
#include "hydro/loads/loads.h"
#include "hydro/loads/refine.h"
#include "hydro/mesh/mass_properties.h"

namespace app {
namespace {

bool needs_more_pieces(const engine::BodySpec& body, double radius, const hydro::Sea& sea) {
  const hydro::TriMesh& mesh = body.mesh_B;
  double area = 0;
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f) area += hydro::area_vector(mesh, f).norm();
  if (!(area > 0)) return false;
  const hydro::HeadError error{std::max(body.summation.wave_tolerance, hydro::kLeastWaveTolerance),
                               std::abs(hydro::solid_properties(mesh).volume) / area};
  return hydro::needs_more_pieces(sea, radius, error);
}

}  // namespace

std::optional<std::string> piece_warning(const engine::SimulationSpec& spec) {
  if (!spec.sea) return std::nullopt;
  for (const engine::BodySpec& body : spec.bodies) {
    if (!body.wet || hydro::no_load(body.coefficients) || engine::immovable(body.locked)) continue;
    const double radius = body.mesh_B.vertices.colwise().norm().maxCoeff();
    if (needs_more_pieces(body, radius, *spec.sea))
      return fmt::format(
          "body '{}': its wave_tolerance of {:.3g} asks for pieces with edges below {:.2g} m, of "
          "which none is split, so that a face has {} pieces at most: what the shortest waves do "
          "at "
          "its waterline is missed in part; a larger hydro.wave_tolerance or fewer waves need "
          "fewer "
          "pieces",
          body.name, body.summation.wave_tolerance, hydro::kSmallestPanel * radius,
          hydro::kMostPiecesOfAFace);
  }
  return std::nullopt;
}

}  // namespace app
