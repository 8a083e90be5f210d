#include "hydro/statics/equilibrium.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "hydro/decompositions.h"
#include "hydro/interior/interior.h"
#include "hydro/statics/trust_region.h"

namespace hydro {
namespace {

constexpr double kLongestStep = 0.2;   ///< [rad] Bound that keeps the search in its first valley.
constexpr double kProbe = 1e-3;        ///< [rad] Turn of the attitudes tried around a result.
constexpr int kMostSteps = 500;        ///< Step limit of one search; most take about ten.
constexpr int kMostSearches = 100;     ///< Search limit; nearly always one search suffices.
constexpr double kRoundOff = 1e-15;    ///< Round-off of moment arms, over the radius.
constexpr double kNoStability = 1e-9;  ///< Metacentric heights that count as zero, over the radius.
constexpr double kEnergyNoise = 1e-12;  ///< Round-off of energy differences, over the radius.

/// The water in a tank at an orientation, seen as a body of water that floats: in G.
Hydrostatics tank_statics(const Tank& tank, const Eigen::Quaterniond& orientation) {
  const Eigen::Matrix3d R_WB = orientation.toRotationMatrix();
  const TriMesh water_G = flipped({R_WB * tank.hull.mesh_B.vertices, tank.hull.mesh_B.faces});
  return hydrostatics(water_G, -water_of(tank.hull, R_WB, tank.volume).level);
}

/// Rotations allowed in a search.
enum class Freedom { all, pitch_only };

/// Energy over weight as a function of small rotations about the horizontal axes [m].
struct Model {
  double energy = 0;
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
  Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
};

/// Returns the model; an excluded axis has no gradient and is stiff, so no step rotates about it.
Model model_of(const Flotation& flotation, Freedom freedom) {
  Model model{.energy = -flotation.effective_centre().z(),
              .gradient = flotation.gradient(),
              .hessian = flotation.effective_metacentric_heights()};
  if (freedom == Freedom::all) return model;
  model.gradient[0] = 0;
  model.hessian(0, 1) = model.hessian(1, 0) = 0;
  model.hessian(0, 0) = 1 + std::abs(model.hessian(1, 1));
  return model;
}

double lowest_eigenvalue(const Eigen::Matrix2d& m) { return eigenvalues(m)[0]; }

Eigen::Quaterniond turned(const Eigen::Quaterniond& orientation, const Eigen::Vector2d& turn) {
  const double angle = turn.norm();
  if (angle == 0) return orientation;
  const Eigen::Vector3d axis(turn.x() / angle, turn.y() / angle, 0);
  return (Eigen::AngleAxisd(angle, axis) * orientation).normalized();
}

/// One body's search for an attitude of least energy.
class Descent {
 public:
  Descent(const ImmersedMesh& mesh, double volume, const std::vector<Tank>& tanks, Freedom freedom)
      : mesh_(mesh), volume_(volume), tanks_(tanks), freedom_(freedom), size_(mesh.radius()) {}

  Flotation from(const Eigen::Quaterniond& start) const {
    Flotation found = search(afloat(mesh_, volume_, start, tanks_));
    for (int i = 1; i < kMostSearches; ++i) {
      const std::optional<Flotation> lower = lower_nearby(found);
      if (!lower) break;
      found = search(*lower);
    }
    return found;
  }

 private:
  bool settled(const Model& m) const {
    return m.gradient.norm() <= kRoundOff * size_ &&
           lowest_eigenvalue(m.hessian) >= -kNoStability * size_;
  }

  /// Quality of a step: actual over predicted decrease of energy. Where round-off hides both, the
  /// moment decides.
  double merit(const Model& before, const Model& after, const Eigen::Vector2d& step) const {
    const double foreseen = -(before.gradient.dot(step) + 0.5 * step.dot(before.hessian * step));
    if (foreseen > kEnergyNoise * size_) return (before.energy - after.energy) / foreseen;
    return after.gradient.norm() < before.gradient.norm() ? 1 : -1;
  }

  Flotation search(Flotation here) const {
    double reach = kLongestStep;
    Model model = model_of(here, freedom_);
    for (int i = 0; i < kMostSteps && reach > 1e-16 && !settled(model); ++i) {
      const Eigen::Vector2d step =
          trust_region_step(model.gradient, model.hessian, reach, kEnergyNoise * size_);
      const Flotation there =
          afloat(mesh_, volume_, turned(here.orientation, step), tanks_, here.height);
      const Model model_there = model_of(there, freedom_);
      const double quality = merit(model, model_there, step);
      if (quality < 0.25) reach = 0.25 * std::min(reach, step.norm());
      if (quality > 0.75) reach = std::min(std::max(reach, 2 * step.norm()), kLongestStep);
      if (quality < 0.01) continue;
      here = there;
      model = model_there;
    }
    return here;
  }

  /// The lowest of the attitudes tried around `found`, if it is lower.
  std::optional<Flotation> lower_nearby(const Flotation& found) const {
    std::optional<Flotation> lowest;
    double least = model_of(found, freedom_).energy - kEnergyNoise * size_;
    for (int k = 0; k < 8; ++k) {
      if (freedom_ == Freedom::pitch_only && k % 4 != 2) continue;
      const Eigen::Vector2d turn = kProbe * Eigen::Vector2d(std::cos(k * std::numbers::pi / 4),
                                                            std::sin(k * std::numbers::pi / 4));
      const Eigen::Vector2d allowed =
          freedom_ == Freedom::all ? turn : Eigen::Vector2d(0, turn.y());
      const Flotation there =
          afloat(mesh_, volume_, turned(found.orientation, allowed), tanks_, found.height);
      const double energy = model_of(there, freedom_).energy;
      if (energy >= least) continue;
      least = energy;
      lowest = there;
    }
    return lowest;
  }

  const ImmersedMesh& mesh_;
  double volume_;
  const std::vector<Tank>& tanks_;
  Freedom freedom_;
  double size_;  ///< The body's radius [m].
};

}  // namespace

Eigen::Vector3d Flotation::effective_centre() const {
  Eigen::Vector3d centre = hydrostatics.centre_of_buoyancy;
  for (const Hydrostatics& tank : tanks)
    centre -= tank.volume / hydrostatics.volume * tank.centre_of_buoyancy;
  return centre;
}

Eigen::Matrix2d Flotation::effective_metacentric_heights() const {
  Eigen::Matrix2d heights = metacentric_heights(hydrostatics);
  for (const Hydrostatics& tank : tanks)
    heights -= tank.volume / hydrostatics.volume * metacentric_heights(tank);
  return heights;
}

Eigen::Vector2d Flotation::gradient() const {
  const Eigen::Vector3d centre = effective_centre();
  return {-centre.y(), centre.x()};
}

Flotation afloat(const ImmersedMesh& mesh, double volume, const Eigen::Quaterniond& orientation,
                 const std::vector<Tank>& tanks, std::optional<double> guess) {
  const FloatingMesh body = mesh.afloat(orientation.toRotationMatrix(), volume, guess);
  Flotation flotation{.orientation = orientation,
                      .height = body.height,
                      .draught = body.draught,
                      .hydrostatics = body.hydrostatics};
  for (const Tank& tank : tanks) flotation.tanks.push_back(tank_statics(tank, orientation));
  return flotation;
}

Stability stability(const ImmersedMesh& mesh, const Flotation& flotation) {
  const double size = mesh.radius();
  const double lowest = lowest_eigenvalue(flotation.effective_metacentric_heights());
  if (lowest < -kNoStability * size) return Stability::unstable;
  return lowest > kNoStability * size ? Stability::stable : Stability::neutral;
}

Flotation equilibrium(const ImmersedMesh& mesh, double volume, const Eigen::Quaterniond& start,
                      const std::vector<Tank>& tanks) {
  return Descent(mesh, volume, tanks, Freedom::all).from(start);
}

std::vector<RightingArm> righting_arms(const ImmersedMesh& mesh, double volume,
                                       const std::vector<double>& heels,
                                       const std::vector<Tank>& tanks) {
  const Descent descent(mesh, volume, tanks, Freedom::pitch_only);
  std::vector<RightingArm> arms;
  double trim = 0;
  for (const double heel : heels) {
    const Eigen::Quaterniond start(Eigen::AngleAxisd(trim, Eigen::Vector3d::UnitY()) *
                                   Eigen::AngleAxisd(heel, Eigen::Vector3d::UnitX()));
    const Flotation found = descent.from(start);
    const Eigen::Vector3d x_axis = found.orientation * Eigen::Vector3d::UnitX();
    trim = std::atan2(-x_axis.z(), x_axis.x());
    arms.push_back(
        {.heel = heel, .trim = trim, .draught = found.draught, .lever = found.gradient().x()});
  }
  return arms;
}

Eigen::Vector3d euler_angles(const Eigen::Quaterniond& orientation) {
  const Eigen::Matrix3d R = orientation.toRotationMatrix();
  const double pitch = std::atan2(-R(2, 0), std::hypot(R(2, 1), R(2, 2)));
  return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

Eigen::Quaterniond with_heading(const Eigen::Quaterniond& orientation, double heading) {
  const Eigen::Vector3d x_axis = orientation * Eigen::Vector3d::UnitX();
  if (x_axis.head<2>().norm() < 1e-9) return orientation;
  const double turn = heading - std::atan2(x_axis.y(), x_axis.x());
  return (Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) * orientation).normalized();
}

}  // namespace hydro
