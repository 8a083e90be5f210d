#include "app/pictures/trail.h"

#include <algorithm>
#include <cmath>

#include "app/logs/interpolation.h"
#include "engine/motion/locks.h"

namespace app {
namespace {

/// Distance between two points of a trail, as a part of the body's length: a finer trail does not
/// look smoother, and a coarser one shows its corners.
constexpr double kTrailSpacing = 0.04;

/// Largest number of points between two shots.
constexpr double kMostBetween = 200;

/// Radius of a trail, as a part of the body's length.
constexpr double kTrailRadius = 0.006;

const Eigen::Vector3d kTrailColor = {0.99, 0.95, 0.72};

}  // namespace

Trail::Trail(const engine::SimulationSpec& spec, const std::string& followed) {
  for (std::size_t i = 0; i < spec.bodies.size(); ++i) {
    const engine::BodySpec& body = spec.bodies[i];
    if (followed.empty() ? engine::immovable(body.locked) : body.name != followed) continue;
    paths_.push_back(
        {.body = i, .length = hydro::bounding_box(body.mesh_B).diagonal().norm(), .points_W = {}});
  }
}

void Trail::extend(Path& path, const hydro::BodyState& from, const hydro::BodyState& to,
                   double interval) const {
  const double spacing = kTrailSpacing * path.length;
  const double way =
      std::max((to.position - from.position).norm(),
               std::max(from.linear_velocity.norm(), to.linear_velocity.norm()) * interval);
  const int parts = static_cast<int>(std::clamp(std::ceil(way / spacing), 1.0, kMostBetween));
  for (int i = 1; i <= parts; ++i) {
    const Eigen::Vector3d p =
        i == parts ? to.position : between(from, to, interval, double(i) / parts).position;
    if ((p - path.points_W.back()).norm() >= spacing) path.points_W.push_back(p);
  }
}

void Trail::add(const Shot& shot) {
  for (Path& path : paths_) {
    const hydro::BodyState& now = shot.states[path.body];
    if (last_.empty())
      path.points_W = {now.position};
    else
      extend(path, last_[path.body], now, shot.time - time_);
  }
  time_ = shot.time;
  last_ = shot.states;
}

void Trail::draw(render::Rigging& rigging) const {
  for (const Path& path : paths_) {
    const Eigen::Vector3d& end = last_[path.body].position;
    const bool beyond = path.points_W.back() != end;
    const auto count = static_cast<Eigen::Index>(path.points_W.size());
    if (count + beyond < 2) continue;
    render::Tube tube = {.points_W = Eigen::Matrix3Xd(3, count + beyond),
                         .radius = kTrailRadius * path.length,
                         .color = kTrailColor};
    for (Eigen::Index i = 0; i < count; ++i)
      tube.points_W.col(i) = path.points_W[static_cast<std::size_t>(i)];
    if (beyond) tube.points_W.col(count) = end;
    rigging.tubes.push_back(std::move(tube));
  }
}

}  // namespace app
