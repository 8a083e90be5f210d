#include "app/assembly/envelope.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "app/assembly/sea_warnings.h"
#include "engine/motion/locks.h"
#include "hydro/decompositions.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"

namespace assembly {
namespace {

struct Bounds {
  double least = 0;
  double most = std::numeric_limits<double>::infinity();
};

constexpr Bounds kSizes{5e-3, 500};        // [m]
constexpr Bounds kMasses{0.01, 20};        // Over the mass of the displaced water [-].
constexpr Bounds kSpeeds{.most = 50};      // [m/s]
constexpr Bounds kSpins{.most = 50};       // [rad/s]
constexpr Bounds kAddedMass{.most = 100};  // Over the mass of the body [-].
constexpr Bounds kSteps{1.0 / 1000, 1.0 / 20};

/// Excess over a bound that is taken as round-off, as of a volume or a step of 1/20 s in decimals.
constexpr double kSlack = 1e-6;

/// Entries of a line, after which the others are only counted.
constexpr std::size_t kMostEntries = 4;

/// Depth at which a body is wholly immersed for every model of its added mass, over its size [-].
constexpr double kDeep = 1e6;

/// Largest added mass of a wholly immersed body in any direction [kg].
double largest_added_mass(const engine::BodySpec& body, hydro::Sea sea, double size) {
  sea.surface = hydro::FlatSurface{};
  hydro::BodyState deep{.orientation = body.initial.orientation};
  deep.position.z() = sea.level - kDeep * size;
  const Eigen::Matrix3d A = body.added_mass->at(deep, sea, 0).topLeftCorner<3, 3>();
  return hydro::eigenvalues(A).maxCoeff();
}

/// Judges values and keeps those that lie outside.
class Judge {
 public:
  /// @param what   Subject and quantity. @param unit   With a space, or what a ratio is relative
  /// to.
  void check(const std::string& what, double value, Bounds bounds, const char* unit) {
    const bool low = value < bounds.least * (1 - kSlack);
    if (low || value > bounds.most * (1 + kSlack))
      entries_.push_back(fmt::format("{} {:.4g}{}, expected at {} {:g}{}", what, value, unit,
                                     low ? "least" : "most", low ? bounds.least : bounds.most,
                                     unit));
  }

  void check(const engine::BodySpec& body, const std::optional<hydro::Sea>& sea) {
    if (engine::immovable(body.locked)) return;
    const std::string name = fmt::format("body '{}': ", body.name);
    const double size = hydro::bounding_box(body.mesh_B).sizes().maxCoeff();
    check(name + "size", size, kSizes, " m");
    check(name + "speed", body.initial.linear_velocity.norm(), kSpeeds, " m/s");
    check(name + "spin", body.initial.angular_velocity.norm(), kSpins, " rad/s");
    if (!sea || !body.wet) return;
    const double water = sea->density * hydro::solid_properties(engine::outside_B(body)).volume;
    if (water > 0)
      check(name + "mass", body.mass / water, kMasses, " times that of its displaced water");
    if (body.added_mass)
      check(name + "added mass", largest_added_mass(body, *sea, size) / body.mass, kAddedMass,
            " times its mass");
  }

  std::vector<std::string> entries() && { return std::move(entries_); }

 private:
  std::vector<std::string> entries_;
};

}  // namespace

std::vector<std::string> outside_envelope(const engine::SimulationSpec& spec) {
  Judge judge;
  const auto moves = [](const engine::BodySpec& body) { return !engine::immovable(body.locked); };
  if (std::ranges::any_of(spec.bodies, moves)) judge.check("step", spec.step, kSteps, " s");
  for (const engine::BodySpec& body : spec.bodies) judge.check(body, spec.sea);
  return std::move(judge).entries();
}

std::optional<std::string> envelope_warning(const engine::SimulationSpec& spec) {
  std::vector<std::string> entries = outside_envelope(spec);
  if (entries.empty()) return std::nullopt;
  std::string more;
  if (entries.size() > kMostEntries) {
    more = fmt::format("; and {} more", entries.size() - kMostEntries);
    entries.resize(kMostEntries);
  }
  return fmt::format("outside the operating envelope, where motions may gain energy: {}{}",
                     fmt::join(entries, "; "), more);
}

bool inside_envelope(const engine::SimulationSpec& spec) {
  return outside_envelope(spec).empty() && !(spec.sea && breaks(*spec.sea));
}

}  // namespace assembly
