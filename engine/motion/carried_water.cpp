#include "engine/motion/carried_water.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/base/constants.h"
#include "engine/motion/body.h"
#include "hydro/interior/lids.h"
#include "hydro/interior/places.h"
#include "hydro/statics/buoyancy_energy.h"

namespace engine {
namespace {

/// A point of mass 1 at r, about the origin.
Matrix6d unit_mass_at(const Eigen::Vector3d& r) {
  Eigen::Matrix<double, 3, 6> J;
  J.leftCols<3>().setIdentity();
  J.rightCols<3>() << 0, r.z(), -r.y(),  //
      -r.z(), 0, r.x(),                  //
      r.y(), -r.x(), 0;
  return J.transpose() * J;
}

/// Only the pressure of the water acts.
hydro::Coefficients pressure_alone(const Body& body) {
  hydro::Coefficients coefficients{.pressure_drag = {0, 0}, .lift = 0};
  coefficients.viscous_drag.law = hydro::ViscousDrag::Law::none;
  coefficients.buoyancy = body.spec->coefficients.buoyancy;
  return coefficients;
}

/// Puts the water of the specification into the pockets.
void fill(const Body& body, const Eigen::Matrix3d& R_WB, CarriedWater& carried) {
  const Eigen::Vector3d up_B = R_WB.row(2);
  for (const WaterAtStart& water : body.spec->interior_water) {
    const int pocket =
        carried.interior
            ? hydro::pocket_under(body.spec->mesh_B, carried.interior->division, water.at_B, up_B)
            : hydro::kSea;
    if (pocket == hydro::kSea)
      throw std::invalid_argument(
          fmt::format("body '{}': there is no pocket at the water inside", body.spec->name));
    carried.pockets[pocket].volume += water.volume;
  }
  for (std::size_t i = 0; i < carried.pockets.size(); ++i) {
    PocketContent& content = carried.pockets[i];
    content.air = air_at_rest(body, carried.interior->division.pockets[i], content.volume);
    if (!content.holds()) continue;
    const hydro::Hull& hull = carried.interior->pockets[i];
    const hydro::WaterInside water = hydro::water_of(hull, R_WB, content.volume);
    content.surface = {water.level, water.area};
    content.centre_B = R_WB.transpose() * hydro::centroid_of(hull, R_WB, water);
    content.up_B = up_B;
  }
  carried.inertia_B = water_inertia(carried.pockets, body.environment.sea->density);
}

bool has_all_pockets(const Body& body, const CarriedWater& carried) {
  if (!carried.interior) return false;
  const BodySpec& spec = *body.spec;
  const bool of_start = carried.interior == spec.pockets && spec.closed_mesh_B;
  return hydro::is_convex(of_start ? *spec.closed_mesh_B
                                   : hydro::with_lids(spec.mesh_B, carried.interior->division));
}

void find_sides(const Body& body, CarriedWater& carried) {
  carried.openings.clear();
  carried.pumps.clear();
  if (!carried.interior) return;
  for (const Opening& opening : body.spec->openings) {
    const auto [near, far] = hydro::wall_at(body.spec->mesh_B, opening.at_B).face;
    const std::vector<int>& pocket_of = carried.interior->division.pocket_of_face;
    carried.openings.push_back(
        {near < 0 ? hydro::kSea : pocket_of[near], far < 0 ? hydro::kSea : pocket_of[far]});
  }
  const auto pocket_at = [&](const Eigen::Vector3d& at_B) {
    return hydro::pocket_under(body.spec->mesh_B, carried.interior->division, at_B,
                               carried.found_up_B);
  };
  for (const PumpSpec& pump : body.spec->pumps)
    carried.pumps.push_back(
        {pocket_at(pump.from_B), pump.to_B ? pocket_at(*pump.to_B) : hydro::kSea});
}

}  // namespace

bool CarriedWater::holds() const {
  return std::any_of(pockets.begin(), pockets.end(), [](const auto& p) { return p.holds(); });
}

double air_at_rest(const Body& body, const hydro::Pocket& pocket, double water) {
  if (!body.spec->air || !pocket.is_void()) return 0;
  return kAtmosphere * std::max(0.0, pocket.capacity - water);
}

double air_volume(const PocketContent& content, double capacity) {
  return std::max(capacity - content.volume, kLastWater * capacity);
}

bool holds_water(const Motion& motion) {
  return motion.carried_water && motion.carried_water->holds();
}

std::shared_ptr<CarriedWater> dry_pockets(const Body& body, const Eigen::Vector3d& up_B) {
  if (!body.hollow) return nullptr;
  auto carried = std::make_shared<CarriedWater>();
  carried->interior = pockets_at(*body.spec, up_B);
  carried->found_up_B = up_B;
  carried->known_up_B = {up_B};
  if (carried->interior) carried->pockets.resize(carried->interior->pockets.size());
  for (PocketContent& pocket : carried->pockets) pocket.id = carried->next_id++;
  find_sides(body, *carried);
  carried->has_all = has_all_pockets(body, *carried);
  return carried;
}

std::shared_ptr<const CarriedWater> water_at_start(const Body& body,
                                                   const hydro::BodyState& state) {
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  const std::shared_ptr<CarriedWater> carried = dry_pockets(body, R_WB.row(2));
  if (carried) fill(body, R_WB, *carried);
  return carried;
}

std::shared_ptr<const CarriedWater> completed(const Body& body,
                                              const std::shared_ptr<const CarriedWater>& carried) {
  if (!carried || carried->interior || carried->pockets.empty()) return carried;
  auto whole = std::make_shared<CarriedWater>(*carried);
  whole->interior = pockets_at(*body.spec, carried->found_up_B);
  return whole;
}

bool fits_water(const Body& body, const Motion& motion) {
  if (body.hollow != (motion.carried_water != nullptr)) return false;
  if (!body.hollow) return true;
  const auto carried = completed(body, motion.carried_water);
  return carried->pockets.size() == (carried->interior ? carried->interior->pockets.size() : 0);
}

void settle(const Eigen::Matrix3d& R_WB, CarriedWater& carried) {
  const Eigen::Vector3d up_B = R_WB.row(2);
  for (std::size_t i = 0; i < carried.pockets.size(); ++i) {
    PocketContent& content = carried.pockets[i];
    if (content.flooded || !(content.volume > 0)) continue;
    const hydro::Hull& hull = carried.interior->pockets[i];
    const hydro::WaterInside water = hydro::water_of(hull, R_WB, content.volume, content.surface);
    content.surface = {water.level, water.area};
    if (up_B.dot(content.up_B) > kKeptMassTurn) continue;
    content.centre_B = R_WB.transpose() * hydro::centroid_of(hull, R_WB, water);
    content.up_B = up_B;
  }
}

Matrix6d water_inertia(const std::vector<PocketContent>& pockets, double density) {
  Matrix6d sum = Matrix6d::Zero();
  for (const PocketContent& pocket : pockets)
    if (pocket.volume > 0) sum += density * pocket.volume * unit_mass_at(pocket.centre_B);
  return sum;
}

const hydro::Hull& sea_hull(const Body& body, const Motion& motion) {
  return motion.carried_water && motion.carried_water->interior
             ? motion.carried_water->interior->outside
             : *body.hull;
}

hydro::Loads sea_loads(const Body& body, const Motion& motion, const hydro::BodyState& state,
                       double time, const hydro::Coefficients& coefficients,
                       const hydro::LoadAccuracy& how) {
  const hydro::Hull& hull = sea_hull(body, motion);
  const bool prepared = body.felt_sea && &hull == body.hull.get() &&
                        how.wave_tolerance == body.spec->summation.wave_tolerance;
  if (prepared) return hydro::compute_loads(hull, state, *body.felt_sea, time, coefficients, how);
  return hydro::compute_loads(hull, state, *body.environment.sea, time, coefficients, how);
}

void add_carried_loads(const Body& body, const CarriedWater& carried, const hydro::BodyState& state,
                       double time, hydro::Loads& loads) {
  const hydro::Sea& sea = *body.environment.sea;
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  for (std::size_t i = 0; i < carried.pockets.size(); ++i) {
    const PocketContent& content = carried.pockets[i];
    if (!content.holds()) continue;
    const hydro::Hull& hull = carried.interior->pockets[i];
    if (content.flooded) {
      loads +=
          hydro::compute_loads(hull, state, sea, time, pressure_alone(body), body.spec->summation);
    } else {
      const hydro::WaterInside water = hydro::water_of(hull, R_WB, content.volume, content.surface);
      loads.interior += sea.density * sea.gravity * water.push;
    }
  }
}

double carried_energy(const Body& body, const CarriedWater& carried,
                      const hydro::BodyState& state) {
  const hydro::Sea& sea = *body.environment.sea;
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  double energy = 0;
  for (std::size_t i = 0; i < carried.pockets.size(); ++i) {
    const PocketContent& content = carried.pockets[i];
    if (!content.holds()) continue;
    const hydro::Hull& hull = carried.interior->pockets[i];
    if (content.flooded) {
      energy += hydro::buoyancy_energy(hull, state, sea);
    } else {
      const double level = hydro::water_of(hull, R_WB, content.volume, content.surface).level;
      const double height = state.position.z() + level - sea.level;
      energy += sea.density * sea.gravity *
                (content.volume * height - hydro::depth_moment(hull, R_WB, level));
    }
  }
  return energy;
}

}  // namespace engine
