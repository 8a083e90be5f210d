#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "hydro/loads/clip.h"
#include "hydro/mesh/mesh.h"
#include "hydro/sea.h"
#include "hydro/spatial.h"
#include "hydro/water/periodic_waves.h"

/// @file
/// The waves that bodies make, to be seen and not felt: rings, splashes and wakes.
///
/// The wet part of a body is covered with sources of the strength
///
///     σ = (V − u)·n,                                                                          (1)
///
/// V the velocity of its surface, u that of the given sea at the place. So the water gets what the
/// body displaces, wherever it goes, and what stands in the given sea turns some of it back. No
/// wave acts on a body, and bodies do not scatter each other's waves. The amplitude of the rings of
/// a heaving hemisphere is 1.06, 1.19, 1.30, 1.40 and 0.94 times the true one at kR = 0.1, 0.3,
/// 0.5, 1 and 2; a slender ship's waves are those of thin-ship theory.
///
/// The waves are those of PeriodicWaves in a square that rides with the current. A window follows
/// the bodies over the square, whose cells are used anew at the other side of the window; at the
/// window's edges the waves are damped.

namespace hydro {

/// Heights of water over a part of the sea.
struct SurfacePatch {
  Eigen::MatrixXf heights;  ///< Above the given sea [m]; rows along y, columns along x.
  double cell = 1;          ///< Distance of neighbouring heights [m].
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< Place of heights(0, 0) in W [m].

  /// The height over a point, by cubic interpolation; 0 outside [m].
  double at(double x, double y) const;

  bool operator==(const SurfacePatch&) const = default;
};

/// The surface by which a body moves the water.
struct WaterMover {
  const TriMesh* mesh_B = nullptr;  ///< Closed, outward, about the centre of mass; null: nothing.
  double radius = 0;                ///< Largest distance of a vertex from the centre of mass [m].
};

/// The window over the water around bodies: 24 radii of the largest one wide, and wider by what the
/// bodies are apart; 256 cells a side, or 512 where a cell would be longer than an eighth of
/// that radius.
PeriodicSquare square_about(const std::vector<WaterMover>& bodies,
                            const std::vector<BodyState>& states, const Sea& sea);

class SeenWater {
 public:
  /// @param bodies   One of them has a mesh at least; the meshes must outlive this.
  /// @param square   Such as square_about().
  SeenWater(const Sea& sea, std::vector<WaterMover> bodies, const PeriodicSquare& square);

  /// Goes on to the states of the bodies at a later time [s]; from the first ones the water starts.
  /// Times closer than the grid needs are left out, so that the cost does not depend on the step of
  /// the caller.
  void follow(double time, const std::vector<BodyState>& states);

  /// The water at a time at or after the last one that was followed [s]; none if it is still.
  std::optional<SurfacePatch> patch(double time) const;

  const PeriodicWaves& waves() const { return waves_; }

  /// What changes, for restore() in another object of the same bodies: a water that goes on from it
  /// is the same to the last bit.
  std::string state() const;
  /// @throws std::invalid_argument if the state is that of another square.
  void restore(const std::string& state);

 private:
  /// The sea about a body, linear in place.
  struct LocalSea;

  void add_sources(const WaterMover& body, const BodyState& state, double duration);
  void add_piece(const Panel& panel, const BodyState& state, const LocalSea& local,
                 double duration);
  LocalSea local_sea(const WaterMover& body, const BodyState& state) const;
  Eigen::Vector2d in_square(const Eigen::Vector2d& p_W, double time) const;
  void follow_bodies(const std::vector<BodyState>& states);
  void damp_edges();

  Sea sea_;
  std::vector<WaterMover> bodies_;
  PeriodicWaves waves_;
  double longest_;      ///< Longest time between two steps of the water [s].
  double largest_ = 0;  ///< Largest volume of a source of this step [m^3].

  /// The state beside the waves.
  struct Clock {
    double time = 0;             ///< Time of the waves [s].
    double undamped = 0;         ///< Time since the edges were damped [s].
    double column = 0, row = 0;  ///< Place of the window's middle in the square [cells].
    bool started = false;
    bool still = true;  ///< Nothing has moved the water so far.
  };
  Clock now_;
};

}  // namespace hydro
