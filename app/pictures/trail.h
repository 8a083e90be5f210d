#pragma once

#include <string>
#include <vector>

#include "app/pictures/shot_spool.h"
#include "app/render/rigging.h"
#include "engine/base/spec.h"

namespace app {

/// The path so far of a body's centre of mass, as a line in pictures. Between two shots it is the
/// cubic that matches their velocities.
class Trail {
 public:
  /// @param followed   Name of the body; empty: every body that can move.
  Trail(const engine::SimulationSpec& spec, const std::string& followed);

  /// Adds the next shot in the order of time.
  void add(const Shot& shot);

  /// Adds the trail up to the last shot to what a picture has.
  void draw(render::Rigging& rigging) const;

 private:
  struct Path {
    std::size_t body = 0;
    double length = 1;  ///< Length of the body [m].
    std::vector<Eigen::Vector3d> points_W;
  };
  void extend(Path& path, const hydro::BodyState& from, const hydro::BodyState& to,
              double interval) const;

  std::vector<Path> paths_;
  double time_ = 0;                     ///< Time of the last shot [s].
  std::vector<hydro::BodyState> last_;  ///< Its states; empty before the first.
};

}  // namespace app
