#include "engine/step/passing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>
#include <vector>

#include "engine/base/constants.h"

namespace engine {
namespace {

/// The shape's box of a body in some frame.
struct Pose {
  Eigen::Vector3d center;
  Eigen::Matrix3d axes;
};

class SweptPair {
 public:
  SweptPair(World& world, const PairMotion& motion) : world_(world), motion_(motion) {
    const auto [first, second] = motion.pair;
    small_ = second;
    large_ = first;
    if (first != kWorld && size_of(first) < size_of(second)) std::swap(small_, large_);
  }

  /// True if the bodies close at a time.
  bool closes(double time) const {
    std::vector<std::pair<BodyId, hydro::BodyState>> places;
    for (const BodyId id : {motion_.pair.first, motion_.pair.second})
      if (id != kWorld) places.emplace_back(id, motion_.state(id, time));
    return !world_.closing_times(places, motion_.pair, motion_.slow).empty();
  }

  /// False if the bodies cannot touch between two times.
  bool paths_meet(double t0, double t1) const {
    return world_.meets(large_, motion_.state(large_, t1), swept(t0, t1));
  }

 private:
  double size_of(BodyId id) const { return world_.shape_box(id).diagonal().norm(); }

  /// The small body's box as the large body sees it, with the large body where it is at `seen_at`.
  Pose pose(double time, const hydro::BodyState& seen_at) const {
    const hydro::BodyState small = motion_.state(small_, time);
    const hydro::BodyState large = motion_.state(large_, time);
    const Eigen::Matrix3d turn =
        (seen_at.orientation * large.orientation.conjugate()).toRotationMatrix();
    const Eigen::Matrix3d axes = small.orientation.toRotationMatrix();
    const Eigen::Vector3d center_W = small.position + axes * world_.shape_box(small_).center();
    return {seen_at.position + turn * (center_W - large.position), turn * axes};
  }

  /// Half the length of the small body's shape along directions, the columns of a rotation.
  Eigen::Vector3d half_along(const Eigen::Matrix3d& directions, const Pose& pose) const {
    const Eigen::Vector3d half = world_.shape_box(small_).sizes() / 2;
    if (world_.is_ball(small_)) return half;
    return (directions.transpose() * pose.axes).cwiseAbs() * half;
  }

  /// The box that holds the small body between two times, with the large one where it is at `t1`.
  OrientedBox swept(double t0, double t1) const {
    const hydro::BodyState seen_at = motion_.state(large_, t1);
    const Pose start = pose(t0, seen_at), end = pose(t1, seen_at);
    const Eigen::Vector3d middle = (start.center + end.center) / 2,
                          path = end.center - start.center;
    const double bend = 2 * (pose((t0 + t1) / 2, seen_at).center - middle).norm();
    const double turn = std::min(2.0, motion_.turning * (t1 - t0)) * size_of(small_) / 2;
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    if (path.norm() > 0) {
      axes.col(0) = path.normalized();
      axes.col(1) = axes.col(0).unitOrthogonal();
      axes.col(2) = axes.col(0).cross(axes.col(1));
    }
    Eigen::Vector3d half = half_along(axes, start).cwiseMax(half_along(axes, end)) +
                           Eigen::Vector3d::Constant(bend + turn);
    half.x() += path.norm() / 2;
    return {.center_W = middle, .axes_W = axes, .sizes = 2 * half};
  }

  World& world_;
  const PairMotion& motion_;
  BodyId small_ = kWorld;
  BodyId large_ = kWorld;
};

/// The time before `t1`, at which the bodies close, from which on they do.
double bisected(const SweptPair& pair, const PairMotion& motion, double t0, double t1,
                int& queries) {
  while (motion.speed * (t1 - t0) > kPassingError * motion.reach) {
    const double middle = (t0 + t1) / 2;
    (pair.closes(middle) ? t1 : t0) = middle;
    --queries;
  }
  return t0;
}

}  // namespace

std::optional<double> unseen_contact(World& world, const PairMotion& motion, int& queries) {
  const SweptPair pair(world, motion);
  if (!pair.paths_meet(0, motion.h)) return std::nullopt;
  std::vector<std::pair<double, double>> open = {{0, motion.h}};  // the earliest interval is last
  for (; !open.empty() && queries > 0; --queries) {
    const auto [t0, t1] = open.back();
    open.pop_back();
    if (!pair.paths_meet(t0, t1)) continue;
    if (motion.speed * (t1 - t0) > kPassingInterval * motion.reach) {
      const double middle = (t0 + t1) / 2;
      open.emplace_back(middle, t1);
      open.emplace_back(t0, middle);
      continue;
    }
    --queries;
    const bool touches = t0 == 0 && pair.closes(0);
    if (!touches && !pair.closes(t1)) continue;
    // Halfway through the next substep, if that is cut short, the contact is seen.
    if (pair.closes(motion.h + motion.reach / motion.speed / 2)) return std::nullopt;
    return touches ? 0 : bisected(pair, motion, t0, t1, queries);
  }
  return std::nullopt;
}

}  // namespace engine
