#pragma once

#include <string>
#include <vector>

#include "engine/motion/moving_body.h"
#include "engine/simulation.h"

/// @file
/// Small worlds for the tests of the engine.

namespace support {

inline constexpr double kGravity = 9.80665;
inline constexpr double kStep = 0.01;  ///< [s]

/// A uniform box centred on its centre of mass, `divisions` squares along each edge; it collides
/// with nothing and the water leaves it alone.
engine::BodySpec box_body(const std::string& name, const Eigen::Vector3d& size, double density,
                          const Eigen::Vector3d& position, int divisions = 1);

/// A uniform sphere as above: an icosphere with the mass of the true sphere.
engine::BodySpec sphere_body(const std::string& name, double radius, double density,
                             const Eigen::Vector3d& position);

/// A dry world of these bodies.
engine::SimulationSpec dry_world(std::vector<engine::BodySpec> bodies, double step);

/// A box of 1 m and half the water's density, in flat water of 1000 kg/m³, that nothing touches.
engine::SimulationSpec box_in_still_water(const Eigen::Vector3d& position);

/// A specification with every joint to the world held a second time by one that asks for nothing
/// more, so that it is left to the constraint solver (engine/motion/reduced_joint.h).
engine::SimulationSpec left_to_the_solver(engine::SimulationSpec spec);

/// A square of ground through the origin that falls by `angle` [rad] in the direction `heading`
/// [rad]; `cells` squares along its edge of 100 m.
engine::MeshGround slope(double angle, double heading, int cells);

/// The rotation that lays a body flat on that slope.
Eigen::Quaterniond lying_on_slope(double angle, double heading);

/// Kinetic and potential energy of all bodies, the latter from z = 0 [J].
double energy(const engine::SimulationSpec& spec, const std::vector<hydro::BodyState>& states);

/// Energy of all bodies in still water, each with the added mass of its pose [J].
double total_energy(const engine::SimulationSpec& spec,
                    const std::vector<hydro::BodyState>& states);

/// The bodies of a specification, which must outlive them, at time 0.
std::vector<engine::MovingBody> moving_bodies(const engine::SimulationSpec& spec);
std::vector<engine::MovingBody> moving_bodies(engine::SimulationSpec&& spec) = delete;

/// Largest distance of two states in place [m] and angle [rad].
double distance(const hydro::BodyState& a, const hydro::BodyState& b);

/// Angular momentum about the body's centre of mass, in W [kg m^2/s].
Eigen::Vector3d spin(const engine::BodySpec& body, const hydro::BodyState& state);

/// The simulation after the number of steps.
engine::Simulation after(engine::SimulationSpec spec, long steps);

/// Number of steps that make up a time.
long steps_in(double time, double step);

}  // namespace support
