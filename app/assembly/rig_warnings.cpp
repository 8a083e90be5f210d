#include "app/assembly/rig_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "app/assembly/build_rig.h"

namespace assembly {
namespace {

/// A rope this many times shorter than its span starts with a warning.
constexpr double kShortRope = 1.02;

/// A catenary whose first swing takes more than this part of the waves' period is warned of [-].
constexpr double kSlowSwing = 0.6;

/// Warns of a rope or mooring that is shorter than its span.
void warn_of_span(const engine::SimulationSpec& spec, const engine::LineSpec& line,
                  const std::string& path, std::vector<std::string>& warnings) {
  const double span = (place_at_start(spec, line.second) - place_at_start(spec, line.first)).norm();
  const bool rope = line.kind == engine::LineSpec::Kind::rope;
  if (span > (rope ? kShortRope : 1) * line.length)
    warnings.push_back(fmt::format(
        "{}.length: {:.4g} m is less than the distance of {:.4g} m between its ends at the start, "
        "so the line starts with a tension of {:.4g} N",
        path, line.length, span, tension_at_start(spec, line)));
}

/// Warns of a propeller whose disc reaches out of still water.
void warn_of_air(const engine::SimulationSpec& spec, std::size_t i,
                 std::vector<std::string>& warnings) {
  const engine::PropellerSpec& propeller = spec.propellers[i];
  if (!spec.sea) return;
  const Eigen::Vector3d center = place_at_start(spec, {propeller.body, propeller.at_B});
  const hydro::BodyState& state = spec.bodies[static_cast<std::size_t>(propeller.body)].initial;
  const double slope = (state.orientation * propeller.axis_B).z();
  const double up = propeller.screw.diameter / 2 * std::sqrt(std::max(0.0, 1 - slope * slope));
  const double above = center.z() + up - spec.sea->level;
  if (above > 0)
    warnings.push_back(fmt::format(
        "propellers[{}].at: the disc reaches {:.3g} m above the still water at the start; what is "
        "above it drives nothing",
        i, above));
}

/// Period of the largest of the waves [s]; 0 without waves.
double wave_period(const hydro::Sea& sea) {
  const auto* waves = std::get_if<hydro::WaveSurface>(&sea.surface);
  if (!waves || waves->components.empty()) return 0;
  return 2 * std::numbers::pi /
         std::ranges::max(waves->components, {}, &hydro::WaveComponent::amplitude).omega;
}

/// Period of the first swing of a mooring at its start, as that of a string with the tension of its
/// fairlead and the mass of what is off the bottom, water included [s].
double swing_period(const engine::SimulationSpec& spec, const engine::LineSpec& line) {
  const hydro::CatenarySolution rest = catenary_at_start(spec, line);
  const double displaced =
      spec.sea->density * std::numbers::pi / 4 * line.drag_diameter * line.drag_diameter;
  const double mass = line.weight / spec.gravity + 2 * displaced;
  return rest.tension() > 0 ? 2 * (line.length - rest.resting) * std::sqrt(mass / rest.tension())
                            : 0;
}

/// Warns of a catenary that is too slow for the waves.
void warn_of_swing(const engine::SimulationSpec& spec, const engine::LineSpec& line, std::size_t i,
                   std::vector<std::string>& warnings) {
  if (!spec.sea) return;
  const double waves = wave_period(*spec.sea), swing = swing_period(spec, line);
  if (waves > 0 && swing > kSlowSwing * waves)
    warnings.push_back(
        fmt::format("moorings[{}]: the line swings in {:.2g} s and the waves have {:.2g} s, so "
                    "that its inertia "
                    "and drag count; model: dynamic has them",
                    i, swing, waves));
}

}  // namespace

std::vector<std::string> rig_warnings(const scene::Scene& scene,
                                      const engine::SimulationSpec& spec) {
  const auto settled = [&](const engine::AttachmentPoint& end) {
    return end.body != engine::kWorld &&
           scene.bodies[static_cast<std::size_t>(end.body)].start == scene::Start::equilibrium;
  };
  std::vector<std::string> warnings;
  std::map<engine::LineSpec::Kind, std::size_t> counts;
  for (const engine::LineSpec& line : spec.lines) {
    const std::size_t i = counts[line.kind]++;
    if (line.kind == engine::LineSpec::Kind::spring) continue;
    if (settled(line.first) || settled(line.second)) continue;
    if (line.kind == engine::LineSpec::Kind::mooring && !line.inertia)
      warn_of_swing(spec, line, i, warnings);
    const char* list = line.kind == engine::LineSpec::Kind::rope ? "ropes" : "moorings";
    warn_of_span(spec, line, fmt::format("{}[{}]", list, i), warnings);
  }
  for (std::size_t i = 0; i < spec.propellers.size(); ++i) warn_of_air(spec, i, warnings);
  return warnings;
}

}  // namespace assembly
