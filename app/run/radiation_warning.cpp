#include "app/run/radiation_warning.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace app {

std::optional<std::string> radiation_warning(const engine::SimulationSpec& spec,
                                             const std::vector<hydro::BodyState>& states) {
  static const double kLeastCosine = std::cos(kLargestTilt);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto& radiation = spec.bodies[i].radiation;
    if (!radiation) continue;
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    const double cosine = (states[i].orientation.conjugate() * up)
                              .dot(radiation->data().pose.orientation.conjugate() * up);
    // The water does not feel how a ball is turned.
    const bool is_ball = radiation->slides() == hydro::WaveFrameRule::Slides::all;
    if (cosine >= kLeastCosine || is_ball) continue;
    return fmt::format(
        "body '{}' has turned more than {:.0f}° from its mean pose, and the waves that it makes "
        "are known for small motions: hydro.radiation: none leaves them out",
        spec.bodies[i].name, kLargestTilt * 180 / std::numbers::pi);
  }
  return std::nullopt;
}

}  // namespace app
