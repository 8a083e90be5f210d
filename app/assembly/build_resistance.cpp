#include "app/assembly/build_resistance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>

#include "app/assembly/build_start.h"
#include "app/assembly/mean_pose.h"
#include "app/assembly/resistance_file.h"
#include "app/assembly/solution_files.h"
#include "app/base/checked_file.h"
#include "app/base/wall_clock.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/resistance/thin_ship.h"
#include "hydro/statics/hydrostatics.h"

namespace assembly {
namespace {

using From = scene::Resistance::Source;

/// The last letter is the version of the file's layout.
constexpr std::uint64_t kResistanceMagic = 0x504c494d57415631;  // PLIMWAV1

/// This version must be raised whenever `hydro::wave_resistance` gives other numbers.
constexpr std::int64_t kResistanceVersion = 1;

constexpr const char* kResistanceKind = "resistance";

/// Wall time of a solution that is worth a file [s].
constexpr double kLongSolution = 0.1;

/// Bluntness above which thin-ship theory says too much of a hull [-].
constexpr double kDoubtfulBluntness = 0.25;

/// Depth over the length below which waves of a hull feel the bottom [-].
constexpr double kDeepOverLength = 0.5;

/// @param suction   For water of density 1.
void give_resistance(hydro::ResistanceCurve curve, const hydro::ThinShip::Suction& suction,
                     std::size_t i, BuiltScene& built) {
  const ResistanceReport& report = built.resistance[i];
  Eigen::Vector3d at = report.pose.orientation * report.centre_B;
  at.head<2>() = suction.centre;
  built.spec.bodies[i].resistance = std::make_shared<const hydro::Resistance>(
      hydro::Resistance{.curve = std::move(curve),
                        .at_B = report.centre_B,
                        .volume = report.volume,
                        .suction = built.spec.sea->density * suction.area,
                        .suction_at_B = report.pose.orientation.conjugate() * at});
}

/// Chooses the resistances of one scene.
class ResistanceChooser {
 public:
  ResistanceChooser(const scene::Scene& scene, const std::vector<RadiationChoice>& radiation,
                    BuiltScene& built, BuildLog& log)
      : scene_(scene), radiation_(radiation), built_(built), log_(log) {}

  void choose() {
    built_.resistance.resize(built_.spec.bodies.size());
    const bool any = std::ranges::any_of(scene_.bodies, [](const scene::Body& body) {
      return body.hydro.resistance.source != From::none;
    });
    if (!any) return;
    if (built_.spec.sea && built_.spec.sea->gravity > 0) poses_.emplace(built_.spec);
    for (const RigidGroup& group : rigid_groups(built_.spec)) {
      bool makes_waves = false;
      for (const engine::BodyId id : group.bodies)
        choose(group, static_cast<std::size_t>(id), makes_waves);
    }
  }

 private:
  /// @param makes_waves   A body of the group has the waves of the hull.
  void choose(const RigidGroup& group, std::size_t i, bool& makes_waves) {
    const scene::Resistance& key = scene_.bodies[i].hydro.resistance;
    built_.resistance[i].source = key.source;
    if (key.source == From::none || (key.source == From::michell && makes_waves)) return;
    makes_waves = makes_waves || key.source == From::michell;
    try {
      if (!built_.spec.sea) throw std::invalid_argument("the scene has no water");
      if (has_simulated_waves(group))
        throw std::invalid_argument(
            "the simulated water has the resistance of its waves, unless hydro.radiation: none "
            "takes the hull out of it");
      const RadiatingHull hull = radiating_hull(built_.spec, group, static_cast<engine::BodyId>(i));
      find_pose(hull, i);
      find_volume(hull, i);
      if (key.source == From::michell)
        make_ship(hull, i);
      else
        give_resistance(read_resistance(key.file), {}, i, built_);
    } catch (const std::invalid_argument& error) {
      refuse(i, error.what());
    } catch (const scene::InputError& error) {
      for (const scene::Fault& fault : error.faults())
        log_.faults.add(scene_.places, path(i) + ".file", scene::to_string(fault));
    }
  }

  bool has_simulated_waves(const RigidGroup& group) const {
    return std::ranges::any_of(group.bodies, [&](engine::BodyId id) {
      return radiation_[static_cast<std::size_t>(id)].simulated;
    });
  }

  static std::string path(std::size_t i) { return fmt::format("bodies[{}].hydro.resistance", i); }

  void refuse(std::size_t i, const std::string& reason) {
    const bool file = scene_.bodies[i].hydro.resistance.source == From::file;
    log_.faults.add(
        scene_.places, path(i),
        fmt::format("found {} for {}: {}; expected none", file ? "a file" : "{wave: michell}",
                    built_.spec.bodies[i].name, reason));
  }

  /// Finds the pose at rest; that of a table may be deep under water, where no wave is made.
  /// @throws std::invalid_argument for a hull without one
  void find_pose(const RadiatingHull& hull, std::size_t i) {
    if (!built_.spec.bodies[i].wet) throw std::invalid_argument("the water does not act on it");
    ResistanceReport& report = built_.resistance[i];
    const bool file = report.source == From::file;
    std::string fault = poses_ ? "" : "there is no gravity";
    if (poses_ && poses_->holder(hull).empty())
      fault = why_not_afloat({hull.mass, hull.water}, hydro::solid_properties(hull.mesh_B).volume,
                             built_.spec.sea->density);
    if (!fault.empty() && !file) throw std::invalid_argument(fault);
    const double deep = -2 * std::sqrt(hull.mesh_B.vertices.colwise().squaredNorm().maxCoeff());
    if (fault.empty())
      report.pose = poses_->find(hull, std::nullopt).pose;
    else
      report.pose = {.height = deep};
  }

  /// Finds the body's own volume at rest, and the centre of what makes the waves.
  void find_volume(const RadiatingHull& hull, std::size_t i) {
    ResistanceReport& report = built_.resistance[i];
    Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
    turn.linear() = report.pose.orientation.toRotationMatrix();
    const auto floats = [&](const hydro::TriMesh& mesh_B) {
      return hydro::hydrostatics(hydro::transformed(mesh_B, turn), report.pose.height);
    };
    const hydro::Hydrostatics own = floats(engine::outside_B(built_.spec.bodies[i]));
    if (!(own.volume > 0)) throw std::invalid_argument("it is dry where it floats at rest");
    const bool file = report.source == From::file;
    const Eigen::Vector3d centre = (file ? own : floats(hull.mesh_B)).centre_of_buoyancy;
    report.centre_B = report.pose.orientation.conjugate() * centre;
    report.volume = own.volume;
  }

  void make_ship(const RadiatingHull& hull, std::size_t i) {
    ResistanceReport& report = built_.resistance[i];
    const WetSurface wet = wet_surface(built_.spec, hull, report.pose);
    if (!wet.fault.empty()) throw std::invalid_argument(wet.fault);
    report.ship = std::make_shared<const hydro::ThinShip>(wet.mesh_B, report.pose);
    const std::string& name = built_.spec.bodies[i].name;
    if (report.ship->bluntness() > kDoubtfulBluntness)
      log_.warnings.push_back(fmt::format(
          "{}: {:.0f} % of the section of {} lie on faces steeper than 45° to its motion, where "
          "thin-ship theory makes too large waves",
          path(i), 100 * report.ship->bluntness(), name));
    const double depth = built_.spec.sea->depth;
    if (depth < kDeepOverLength * report.ship->length())
      log_.warnings.push_back(
          fmt::format("{}: the waves of {} are those on deep water, and the water is {:.3g} m deep "
                      "at a length of {:.3g} m",
                      path(i), name, depth, report.ship->length()));
  }

  const scene::Scene& scene_;
  const std::vector<RadiationChoice>& radiation_;
  BuiltScene& built_;
  BuildLog& log_;
  std::optional<MeanPoses> poses_;
};

/// A solution for water of density 1.
struct StoredResistance {
  hydro::WaveResistance waves;
  double seconds = 0;
  bool from_store = false;
};

std::string identity_of(const hydro::ThinShip& ship, double gravity) {
  std::string bytes;
  app::append(bytes, kResistanceMagic);
  app::append(bytes, kResistanceVersion);
  app::append(bytes, gravity);
  const std::vector<double> numbers = ship.numbers();
  app::append(bytes, numbers.data(), numbers.size());
  return bytes;
}

std::string encode(const StoredResistance& stored) {
  std::string bytes;
  app::append(bytes, stored.seconds);
  app::append(bytes, stored.waves.suction.area);
  app::append(bytes, stored.waves.suction.centre.data(), 2);
  for (const auto* column : {&stored.waves.speeds, &stored.waves.forces})
    app::append(bytes, column->data(), column->size());
  return bytes;
}

StoredResistance decode(const std::string& bytes) {
  std::vector<double> numbers(bytes.size() / sizeof(double));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
  constexpr std::size_t kHead = 4;
  const auto speeds = numbers.begin() + kHead;
  const auto forces = speeds + static_cast<std::ptrdiff_t>((numbers.size() - kHead) / 2);
  return {.waves = {.speeds = {speeds, forces},
                    .forces = {forces, numbers.end()},
                    .suction = {.area = numbers[1], .centre = {numbers[2], numbers[3]}}},
          .seconds = numbers[0],
          .from_store = true};
}

StoredResistance solved(const std::string& name, const hydro::ThinShip& ship, double gravity,
                        const SolutionFiles& files, app::Reporter& reporter) {
  const std::string what = "wave resistance of " + name;
  const std::string identity = identity_of(ship, gravity);
  const auto find = [&]() -> std::optional<StoredResistance> {
    const auto content = files.read(identity, kResistanceKind, std::nullopt, reporter);
    return content ? std::optional(decode(*content)) : std::nullopt;
  };
  return found_or_solved(files.file_of(identity, kResistanceKind), what, reporter, find, [&] {
    reporter.working_on(what + ": solving over the speed, once for this mesh and pose");
    const app::WallClock clock;
    StoredResistance stored{.waves = hydro::wave_resistance(ship, gravity)};
    stored.seconds = clock.seconds();
    reporter.done(
        fmt::format("{}: {} speeds, {:.1f} s", what, stored.waves.speeds.size(), stored.seconds));
    if (stored.seconds > kLongSolution)
      files.write(identity, kResistanceKind, encode(stored), reporter);
    return stored;
  });
}

}  // namespace

void choose_resistances(const scene::Scene& scene, const std::vector<RadiationChoice>& radiation,
                        BuiltScene& built, BuildLog& log) {
  ResistanceChooser(scene, radiation, built, log).choose();
}

void solve_resistances(BuiltScene& built, const std::optional<std::filesystem::path>& folder,
                       app::Reporter& reporter) {
  const SolutionFiles files(folder, "the wave resistance");
  std::map<std::string, StoredResistance> known;
  for (std::size_t i = 0; i < built.resistance.size(); ++i) {
    ResistanceReport& report = built.resistance[i];
    if (!report.ship) continue;
    const hydro::Sea& sea = *built.spec.sea;
    const std::string identity = identity_of(*report.ship, sea.gravity);
    auto found = known.find(identity);
    if (found == known.end())
      found = known
                  .emplace(identity, solved(built.spec.bodies[i].name, *report.ship, sea.gravity,
                                            files, reporter))
                  .first;
    report.seconds = found->second.seconds;
    report.from_store = found->second.from_store;
    std::vector<double> forces = found->second.waves.forces;
    for (double& force : forces) force *= sea.density;
    give_resistance({found->second.waves.speeds, forces}, found->second.waves.suction, i, built);
  }
}

}  // namespace assembly
