#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hydro/mesh/mesh.h"
#include "hydro/radiation/floating_body.h"
#include "hydro/sea.h"
#include "hydro/spatial.h"
#include "hydro/water/hull_passage.h"
#include "hydro/water/hull_sources.h"
#include "hydro/water/near_field.h"
#include "hydro/water/periodic_waves.h"
#include "hydro/water/water_window.h"

/// @file
/// The water about bodies, which they move and feel.
///
/// The surface is that of the given sea and of the waves φ_w of PeriodicWaves, which the sources of
/// bodies drive. A floating hull has the sources (1) of hull_sources.h, about its mean pose; it
/// moves over the water in surge, sway and yaw, and scatters the given sea and the waves of all
/// bodies. Any other body has sources of the strength
///
///     σ = (V − u)·n                                                                           (1)
///
/// on its wet part, V the velocity of its surface, u that of the given sea at the place. So the
/// water gets what the body displaces, wherever it goes, and no wave acts on it. The rings of a
/// heaving hemisphere by (1) are 1.06, 1.19, 1.30, 1.40 and 0.94 times the true ones at kR = 0.1,
/// 0.3, 0.5, 1 and 2; a slender ship's waves are those of thin-ship theory.
///
/// A step of the water of length H takes the waves through ½H, reads the flow about the hulls'
/// places halfway, gives the hulls the load that follows, adds what they have displaced during the
/// step, and takes the waves through the other half. With ξ the way of a hull since the step's
/// start (in the frame H of wave_frame.h), the load during the step is
///
///     F = f − ρg C ξ                                                                          (2)
///
/// f of hull_passage.h, less half of the answer of what the hull scatters in this step. The step's
/// sources leave the energy ½ρg ξ·Cξ of the spring in the water, so that no body is too light for
/// it.
///
/// Hulls closer than some of their radii feel each other's sources as well (near_field.h), with the
/// strengths of the last step, taken on.
///
/// The surface inside a hull's waterplane is fictitious and would slosh; it is damped.

namespace hydro {

/// A body in the water.
struct WaterBody {
  const TriMesh* mesh_B = nullptr;  ///< Closed, outward, about the centre of mass; null: nothing.
  double radius = 0;                ///< Largest distance of a vertex from the centre of mass [m].
  /// The sources of a floating hull, and how it lies in the water; null: (1).
  std::shared_ptr<const HullSources> hull;
  std::shared_ptr<const FloatingBody> floating;
};

/// The window over the water around bodies: 24 radii of the largest one wide, and wider by what the
/// bodies are apart; 256 cells a side, or 512 where a cell would be longer than an eighth of
/// that radius.
PeriodicSquare square_about(const std::vector<WaterBody>& bodies,
                            const std::vector<BodyState>& states, const Sea& sea);

/// Side of the smallest cell [m] whose waves steps of a length [s] follow.
double smallest_cell(double step, double gravity);

class SimulatedWater {
 public:
  /// @param bodies   One of them has a mesh at least; the meshes must outlive this.
  /// @param square   Such as square_about().
  /// @param edge     Width of the window's damped edge [m]; 0: a fifth of its side.
  SimulatedWater(const Sea& sea, std::vector<WaterBody> bodies, const PeriodicSquare& square,
                 double edge = 0);

  /// Longest time between two steps of the water [s].
  double longest_step() const { return longest_; }

  /// Begins a step of the water of a length [s]. @return per body; zero but for hulls
  std::vector<WavesOnHull> begin(double time, double length, const std::vector<BodyState>& states);
  /// Ends it with the bodies' states there and the hulls' ways ξ in it, per body.
  void end(const std::vector<BodyState>& states, const std::vector<Vector6d>& ways);

  /// Goes on to the states of the bodies at a later time [s], from which nothing acts on them; from
  /// the first ones the water starts. Times closer than the grid needs are left out, so that the
  /// cost does not depend on the step of the caller.
  void follow(double time, const std::vector<BodyState>& states);

  /// The water at a time at or after the last one that was followed [s]; none if it is still.
  std::optional<SurfacePatch> patch(double time) const;

  const PeriodicWaves& waves() const { return waves_; }

  /// Energy that the damping has taken from the waves since the start, over density [m^5/s^2].
  double absorbed() const { return now_.absorbed; }

  /// The state, for restore() in another object of the same bodies: water that continues from it is
  /// the same to the last bit.
  std::string state() const;
  /// @throws std::invalid_argument if the state is that of another square.
  void restore(const std::string& state);

 private:
  void find_passage(const WaterBody& body, const BodyState& start, HullPassage& passage) const;
  std::vector<NearSources> neighbours_of(std::size_t hull) const;
  FlowAtHull flow_at(std::size_t body) const;
  void add_hull(std::size_t body, const Vector6d& way);
  void add_surface(const WaterBody& body, const BodyState& state);
  void follow_bodies(const std::vector<BodyState>& states);
  double damp(const std::vector<BodyState>& states);

  Sea sea_;
  std::vector<WaterBody> bodies_;
  PeriodicWaves waves_;
  FieldBelow field_;  ///< Field of the waves halfway through the step.
  WaterWindow window_;
  bool felt_;  ///< At least one hull feels the waves.
  double longest_;
  double largest_ = 0;  ///< Largest volume of a source of this step [m^3].

  // The state beside the waves.
  struct Clock {
    double time = 0;      ///< Time of the waves [s].
    double undamped = 0;  ///< Time since the edges were damped [s].
    double length = 0;    ///< Length of the step that has begun [s]; 0 between steps.
    bool started = false;
    bool still = true;    ///< Nothing has moved the water so far.
    double absorbed = 0;  ///< Energy that was damped, over density [m^5/s^2].
  };
  Clock now_;
  std::vector<HullPassage> passages_;  ///< Per body.
};

}  // namespace hydro
