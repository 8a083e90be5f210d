#include "app/run/radiation_warning.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace app {
namespace {

/// Part of a displacement's added mass, times the radius squared, that turns of a sphere of
/// triangles stay below [-].
constexpr double kTurnsOfASphere = 1e-3;

/// True if the water does not feel how the body is turned: it is a sphere about its centre.
bool is_round(const engine::BodySpec& body) {
  const hydro::Matrix6d& A = body.radiation->data().infinite_added_mass;
  const double radius_squared = body.mesh_B.vertices.colwise().squaredNorm().maxCoeff();
  return A.bottomRightCorner<3, 3>().norm() <
         kTurnsOfASphere * radius_squared * A.topLeftCorner<3, 3>().norm();
}

}  // namespace

std::optional<std::string> radiation_warning(const engine::SimulationSpec& spec,
                                             const std::vector<hydro::BodyState>& states) {
  static const double kLeastCosine = std::cos(kLargestTilt);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto& radiation = spec.bodies[i].radiation;
    if (!radiation) continue;
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    const double cosine = (states[i].orientation.conjugate() * up)
                              .dot(radiation->data().pose.orientation.conjugate() * up);
    if (cosine >= kLeastCosine || is_round(spec.bodies[i])) continue;
    return fmt::format(
        "body '{}' has turned more than {:.0f}° from its mean pose, and the waves that it makes "
        "are known for small motions: hydro.radiation: none leaves them out",
        spec.bodies[i].name, kLargestTilt * 180 / std::numbers::pi);
  }
  return std::nullopt;
}

}  // namespace app
