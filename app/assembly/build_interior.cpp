#include "app/assembly/build_interior.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "hydro/interior/interior.h"
#include "hydro/interior/lids.h"
#include "hydro/interior/places.h"

namespace assembly {
namespace {

/// An opening may be this far from both sides of its wall, over the body's longest side.
constexpr double kFarFromWall = 0.05;

engine::Interior model_of(scene::Interior interior) {
  switch (interior) {
    case scene::Interior::flooding:
      return engine::Interior::flooding;
    case scene::Interior::dry:
      return engine::Interior::dry;
    case scene::Interior::wet:
      break;
  }
  return engine::Interior::wet;
}

Eigen::Matrix3d orientation_of(const engine::BodySpec& spec) {
  return spec.initial.orientation.toRotationMatrix();
}

/// The volume of the water in a pocket, or a fault.
std::optional<double> volume_in(const hydro::Interior& interior, int pocket,
                                const scene::InteriorWater& water, const Eigen::Vector3d& com_M,
                                const engine::BodySpec& spec, const std::string& path,
                                BuildLog& log) {
  const double capacity = interior.division.pockets[pocket].capacity;
  const Eigen::Matrix3d R_WB = orientation_of(spec);
  double volume = water.volume.value_or(0);
  if (water.level) {
    const double above_com = *water.level - R_WB.row(2).dot(com_M);
    volume = hydro::water_up_to(interior.pockets[pocket], R_WB, above_com).volume;
  }
  if (volume > 0 && volume <= capacity * (1 + 1e-9)) return volume;
  const char* key = water.level ? ".level" : ".volume";
  log.faults.add(log.scene.places, path + key,
                 volume > 0 ? fmt::format("gives {:.6g} m^3 of water to a hollow that holds {:.6g} "
                                          "m^3 at the start",
                                          volume, capacity)
                            : std::string("is below the hollow: there would be no water"));
  return std::nullopt;
}

bool is_void(const hydro::Interior* interior, int space) {
  return space != hydro::kSea &&
         interior->division.pockets[static_cast<std::size_t>(space)].is_void();
}

/// @return true if it leads into a void
bool add_opening(const scene::Opening& opening, const hydro::Interior* interior,
                 const Eigen::Vector3d& com_M, const std::string& path, engine::BodySpec& spec,
                 BuildLog& log) {
  const Eigen::Vector3d at_B = opening.at - com_M;
  const hydro::WallFaces wall = hydro::wall_at(spec.mesh_B, at_B);
  const double size = hydro::bounding_box(spec.mesh_B).sizes().maxCoeff();
  if (!(wall.distance <= kFarFromWall * size)) {
    log.faults.add(
        log.scene.places, path + ".at",
        fmt::format("is {:.3g} m from the far side of the nearest wall, expected a point "
                    "in or near a wall",
                    wall.distance));
    return false;
  }
  const auto space = [&](int face) {
    return interior ? interior->division.pocket_of_face[face] : hydro::kSea;
  };
  const int first = space(wall.face[0]), second = space(wall.face[1]);
  if (first == second) {
    log.faults.add(log.scene.places, path + ".at",
                   "has the same water on both sides of the wall there, expected a wall of a "
                   "hollow");
    return false;
  }
  spec.openings.push_back({.at_B = at_B, .area = opening.area, .discharge = opening.discharge});
  return is_void(interior, first) || is_void(interior, second);
}

/// @param interior   At the start; null: the body has no pocket.
/// @return true if it brings water into a void
bool add_pump(const scene::Pump& pump, const hydro::Interior* interior,
              const Eigen::Vector3d& com_M, const std::string& path, engine::BodySpec& spec,
              BuildLog& log) {
  engine::PumpSpec made{.from_B = pump.from - com_M};
  if (pump.to) made.to_B = *pump.to - com_M;
  if (pump.head) made.head = *pump.head;
  const Eigen::Vector3d up_B = orientation_of(spec).row(2);
  const auto pocket_at = [&](const Eigen::Vector3d& at_B) {
    return interior ? hydro::pocket_under(spec.mesh_B, interior->division, at_B, up_B)
                    : hydro::kSea;
  };
  const int from = pocket_at(made.from_B), to = made.to_B ? pocket_at(*made.to_B) : hydro::kSea;
  if (made.to_B && to == hydro::kSea)
    log.faults.add(log.scene.places, path + ".to",
                   "is in no hollow at the start; expected sea or a point in a hollow");
  else if (from == to)
    log.faults.add(log.scene.places, path + ".from",
                   from == hydro::kSea
                       ? "is in no hollow at the start, and the pump brings water into the sea"
                       : "is in the hollow that the pump brings water into");
  spec.pumps.push_back(made);
  return is_void(interior, to);
}

}  // namespace

void build_interior(const scene::Body& body, engine::BodySpec& spec) {
  if (!spec.wet || hydro::is_convex(spec.mesh_B)) return;
  spec.interior = model_of(body.interior);
  if (spec.interior == engine::Interior::wet) return;
  spec.pockets = hydro::make_interior(spec.mesh_B, orientation_of(spec).row(2));
  if (spec.pockets) spec.closed_mesh_B = hydro::with_lids(spec.mesh_B, spec.pockets->division);
}

void fill_interior(const scene::Body& body, const Eigen::Vector3d& com_M,
                   const std::string& key_path, engine::BodySpec& spec, BuildLog& log) {
  spec.air = body.air;
  if (body.interior_water.empty() && body.openings.empty() && body.pumps.empty() && !body.air)
    return;
  const Eigen::Vector3d up_B = orientation_of(spec).row(2);
  const auto interior = spec.interior == engine::Interior::flooding ? spec.pockets : nullptr;
  for (std::size_t i = 0; i < body.interior_water.size(); ++i) {
    const std::string path = fmt::format("{}.interior_water[{}]", key_path, i);
    const scene::InteriorWater& water = body.interior_water[i];
    const Eigen::Vector3d at_B = water.at - com_M;
    const int pocket =
        interior ? hydro::pocket_under(spec.mesh_B, interior->division, at_B, up_B) : hydro::kSea;
    if (pocket == hydro::kSea) {
      log.faults.add(log.scene.places, path + ".at",
                     interior ? "is in no hollow that holds water at the start"
                              : "the body has no hollow that holds water at the start");
      continue;
    }
    if (const auto volume = volume_in(*interior, pocket, water, com_M, spec, path, log))
      spec.interior_water.push_back({.at_B = at_B, .volume = *volume});
  }
  bool fills_void = false;
  for (std::size_t i = 0; i < body.openings.size(); ++i)
    fills_void |= add_opening(body.openings[i], interior.get(), com_M,
                              fmt::format("{}.openings[{}]", key_path, i), spec, log);
  for (std::size_t i = 0; i < body.pumps.size(); ++i)
    fills_void |= add_pump(body.pumps[i], interior.get(), com_M,
                           fmt::format("{}.pumps[{}]", key_path, i), spec, log);
  if (body.air && !fills_void)
    log.faults.add(log.scene.places, key_path + ".air",
                   "traps no air: the body has no hollow without a mouth into which an opening or "
                   "a pump leads");
}

std::vector<std::string> interior_warnings(const engine::SimulationSpec& spec) {
  std::vector<std::string> warnings;
  for (const engine::BodySpec& body : spec.bodies) {
    if (!spec.sea || body.interior != engine::Interior::flooding || !body.closed_mesh_B) continue;
    const Eigen::Vector3d up_B = orientation_of(body).row(2);
    double deepest = 0;
    const auto interior = engine::pockets_at(body, up_B);
    if (!interior) continue;
    for (const hydro::SillEdge& edge : interior->division.sills) {
      if (edge.other != hydro::kSea) continue;
      for (const int v : {edge.from, edge.to}) {
        const Eigen::Vector3d p =
            body.initial.position + body.initial.orientation * body.mesh_B.vertices.col(v);
        deepest = std::max(deepest, hydro::surface_height(*spec.sea, p.x(), p.y(), 0) - p.z());
      }
    }
    if (deepest > 0)
      warnings.push_back(fmt::format(
          "body '{}' starts with the rim of a hollow {:.3g} m under water: it fills at once",
          body.name, deepest));
  }
  return warnings;
}

double mass_of_water_in(const engine::BodySpec& spec, double density) {
  double mass = 0;
  for (const engine::WaterAtStart& water : spec.interior_water) mass += density * water.volume;
  return mass;
}

double mass_afloat(const engine::BodySpec& spec, double density) {
  return spec.mass + mass_of_water_in(spec, density);
}

std::vector<hydro::Tank> tanks_of(const engine::BodySpec& spec) {
  std::vector<hydro::Tank> tanks;
  if (spec.interior_water.empty()) return tanks;
  const Eigen::Vector3d up_B = orientation_of(spec).row(2);
  const auto interior = engine::pockets_at(spec, up_B);
  if (!interior) return tanks;
  for (const engine::WaterAtStart& water : spec.interior_water) {
    const int pocket = hydro::pocket_under(spec.mesh_B, interior->division, water.at_B, up_B);
    if (pocket != hydro::kSea)
      tanks.push_back({.hull = interior->pockets[pocket], .volume = water.volume});
  }
  return tanks;
}

}  // namespace assembly
