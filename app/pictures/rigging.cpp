#include "app/pictures/rigging.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/pictures/force_annotations.h"
#include "app/render/part_meshes.h"

namespace app {
namespace {

using Eigen::Vector3d;
using engine::LineSpec;

/// Points of a drawn mooring.
constexpr int kMooringPoints = 64;

/// Colours of tensions, evenly spaced from none to the largest, and of the largest push.
const std::array<Vector3d, 4> kTension = {Vector3d(0.58, 0.59, 0.62), Vector3d(0.10, 0.62, 0.26),
                                          Vector3d(0.98, 0.80, 0.10), Vector3d(0.88, 0.10, 0.10)};
const Vector3d kPush = {0.12, 0.35, 0.88};
const Vector3d kBroken = {0.16, 0.15, 0.15};

render::Rgb rgb(const Vector3d& color) {
  const auto byte = [](double c) { return static_cast<std::uint8_t>(std::lround(255 * c)); };
  return {byte(color.x()), byte(color.y()), byte(color.z())};
}

/// Returns the smallest round value that is not below `value` > 0.
double round_up(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (value <= factor * power * (1 + 1e-9)) return factor * power;
  return 10 * power;
}

Eigen::Matrix3Xd mooring_shape(const LineSpec& line, double length, const Vector3d& fairlead,
                               const Vector3d& anchor) {
  const Vector3d chord = fairlead - anchor;
  const double x = chord.head<2>().norm();
  const hydro::CatenaryLine catenary = catenary_of(line, length);
  const hydro::CatenarySolution solution =
      hydro::solve_catenary(catenary, x, chord.z(), line.on_bottom);
  const std::vector<Eigen::Vector2d> shape =
      hydro::catenary_shape(catenary, solution, x, chord.z(), kMooringPoints);
  Vector3d ahead(chord.x(), chord.y(), 0);
  if (x > 0) ahead /= x;
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(shape.size()));
  for (std::size_t i = 0; i < shape.size(); ++i)
    points.col(static_cast<Eigen::Index>(shape.size() - 1 - i)) =
        anchor + shape[i].x() * ahead + shape[i].y() * Vector3d::UnitZ();
  return points;
}

Eigen::Matrix3Xd points_of(const std::vector<Vector3d>& nodes_W) {
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(nodes_W.size()));
  for (std::size_t i = 0; i < nodes_W.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) = nodes_W[i];
  return points;
}

}  // namespace

Vector3d tension_color(double share) {
  if (share < 0) return kTension[0] + std::min(-share, 1.0) * (kPush - kTension[0]);
  const double place = std::min(share, 1.0) * (kTension.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(place), kTension.size() - 2);
  return kTension[low] + (place - static_cast<double>(low)) * (kTension[low + 1] - kTension[low]);
}

Eigen::Matrix3Xd shape_of(const LineSpec& line, const DrawnLine& now,
                          const std::vector<hydro::BodyState>& states, const GroundHeight& ground,
                          double radius) {
  if (!now.nodes_W.empty()) return points_of(now.nodes_W);
  const Vector3d first = place_of(line.first, states), second = place_of(line.second, states);
  if (line.kind == LineSpec::Kind::mooring) return mooring_shape(line, now.length, first, second);
  Eigen::Matrix3Xd points =
      hanging_line(first, second, line.kind == LineSpec::Kind::rope ? now.length : 0);
  if (points.cols() > 2) ground.lift(points, radius);
  return points;
}

RigPictures::RigPictures(const engine::SimulationSpec& spec, bool joints)
    : spec_(spec), ground_(spec.ground), parts_(rig_parts(spec, joints)) {}

void RigPictures::include(const Shot& shot) {
  for (const DrawnLine& line : shot.rig.lines) {
    largest_ = std::max(largest_, std::abs(line.tension));
    pushes_ = pushes_ || line.tension < 0;
  }
}

Vector3d RigPictures::color_of(const DrawnLine& line) const {
  return tension_color(largest_ > 0 ? line.tension / scale_top() : 0);
}

double RigPictures::scale_top() const { return largest_ > 0 ? round_up(largest_) : 0; }

void RigPictures::add_line(std::size_t index, const Shot& shot, render::Rigging& rigging) const {
  const LineSpec& line = spec_.lines[index];
  const DrawnLine& now = shot.rig.lines[index];
  const double radius = line_radius(spec_, line);
  if (now.broken) {
    for (const engine::AttachmentPoint& end : {line.first, line.second}) {
      if (end.body == engine::kWorld) continue;
      Eigen::Matrix3Xd points(3, 2);
      points << place_of(end, shot.states), place_of(end, shot.states);
      points(2, 1) -= broken_length(spec_, line);
      ground_.lift(points, radius);
      rigging.tubes.push_back({.points_W = points, .radius = radius, .color = kBroken});
    }
    return;
  }
  render::Tube tube = {.points_W = shape_of(line, now, shot.states, ground_, radius),
                       .radius = radius,
                       .color = color_of(now)};
  if (line.kind == LineSpec::Kind::spring) {
    const Coil coil = coil_of(spec_, line);
    tube.radius = 0.15 * coil.radius;
    tube.points_W =
        render::helix(tube.points_W.col(0), tube.points_W.col(1), coil.radius, coil.turns);
  }
  rigging.tubes.push_back(std::move(tube));
}

render::Rigging RigPictures::of(const Shot& shot) const {
  render::Rigging rigging;
  for (const RigPart& part : parts_) {
    Eigen::Isometry3d pose = part.turned_B(spec_, shot.rig);
    if (part.body != engine::kWorld)
      pose = pose_of(shot.states[static_cast<std::size_t>(part.body)]) * pose;
    rigging.parts.push_back({.mesh_P = part.mesh_P, .X_WP = pose, .color = part.color});
  }
  for (std::size_t i = 0; i < spec_.lines.size(); ++i) add_line(i, shot, rigging);
  return rigging;
}

void RigPictures::explain(render::Annotations& notes) const {
  if (largest_ == 0) return;
  constexpr int kSteps = 64;
  render::LegendRamp ramp;
  const double low = pushes_ ? -1 : 0;
  for (int i = 0; i < kSteps; ++i)
    ramp.colors.push_back(rgb(tension_color(low + (1 - low) * (i + 0.5) / kSteps)));
  const std::string top = force_text(scale_top());
  ramp.name = fmt::format("tension {} to {}", pushes_ ? "-" + top : "0", top);
  notes.ramp = std::move(ramp);
}

}  // namespace app
