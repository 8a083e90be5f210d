#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/logs/table_layouts.h"
#include "app/scene/probe.h"
#include "engine/base/spec.h"
#include "hydro/water/surface_patch.h"

/// @file
/// The readings of the probes of a run, and the columns of their log.
///
/// `elevation` is the height of the water's surface above the still water at the place of the
/// probe, the waves of bodies in simulated water included [m]. `x`, `y`, `z` is the point of the
/// probe in W [m]; `vx` … `vz` [m/s] and `ax` … `az` [m/s^2] are velocity and acceleration of the
/// body at the point, or of the water:
///
/// - A wave gauge is at a fixed x, y. Without a depth its z is that of the surface, and it has no
///   velocity. With a depth its z is fixed, and velocity and acceleration are those of the water
///   there by the given sea (hydro/airy_waves.h), while the surface is above it.
/// - A point of a body moves with it. Its velocity is v + ω × r, exact in the body's state. Its
///   acceleration is the change of that velocity in the last step over the step, so that the sum of
///   all accelerations times the step is the velocity to round-off. It is the acceleration half a
///   step before, to second order in the step, and impacts are part of it.
///
/// A number that a probe does not have is NaN: an acceleration before the first step, the elevation
/// of a scene without water.

namespace app {

/// Numbers of one probe at one time, in the order of the columns; NaN: not measured.
using ProbeReading = std::array<double, 10>;

/// The probes of a run.
class Probes {
 public:
  /// @param spec   Specification of the scene of the probes; it must outlive this.
  /// @param centers_of_mass   Centres of mass of the bodies, in the frames of their meshes [m].
  Probes(const std::vector<scene::Probe>& probes, const engine::SimulationSpec& spec,
         const std::vector<Eigen::Vector3d>& centers_of_mass);

  /// Keeps the velocities of the points before a step.
  void before_step(const std::vector<hydro::BodyState>& states);

  /// Velocities of the points of bodies before the last step, in W [m/s], those of gauges zero;
  /// empty before the first step.
  const std::vector<Eigen::Vector3d>& velocities_before() const { return velocities_before_; }
  /// @param velocities   One for each probe, or none.
  void set_velocities_before(std::vector<Eigen::Vector3d> velocities);

  /// Returns the readings in the order of the scene.
  /// @param states   States of the bodies at `time`.
  /// @param waves    Waves of the bodies in simulated water at `time`; none: still.
  std::vector<ProbeReading> read(double time, const std::vector<hydro::BodyState>& states,
                                 const std::optional<hydro::SurfacePatch>& waves = {}) const;

 private:
  /// A point of a body, or of the water where there is no body.
  struct Point {
    std::optional<std::size_t> body;
    Eigen::Vector3d at;       ///< In B, or in W [m].
    bool on_surface = false;  ///< The height of the point is that of the surface.
  };

  ProbeReading read_water(const Point& point, double time, double raise) const;
  ProbeReading read_body(const Point& point, double time, double raise,
                         const hydro::BodyState& state) const;

  const engine::SimulationSpec& spec_;
  std::vector<Point> points_;
  std::vector<Eigen::Vector3d> velocities_before_;
};

}  // namespace app
