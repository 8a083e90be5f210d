#include "app/pictures/rig_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "app/logs/rig_log.h"
#include "app/render/part_meshes.h"
#include "hydro/mesh/mesh_union.h"
#include "hydro/mesh/primitives.h"

namespace app {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using engine::JointSpec;
using engine::LineSpec;

const Vector3d kBronze = {0.74, 0.52, 0.20};
const Vector3d kRudder = {0.55, 0.22, 0.18};
const Vector3d kSail = {0.95, 0.93, 0.87};
const Vector3d kIron = {0.20, 0.21, 0.24};
const Vector3d kSteel = {0.60, 0.63, 0.68};

using Mesh = std::shared_ptr<const hydro::TriMesh>;

Mesh shared(hydro::TriMesh mesh) { return std::make_shared<const hydro::TriMesh>(std::move(mesh)); }

double extent_of(const engine::BodySpec& body) {
  return hydro::bounding_box(body.mesh_B).diagonal().norm();
}

/// Drawn radius of a line without a diameter, as a share of the size of the body that it holds.
constexpr double kLineShare = 0.003;

/// Size of the smaller of two bodies [m]; 1 if both are the world.
double least_size(const engine::SimulationSpec& spec, engine::BodyId a, engine::BodyId b) {
  double size = std::numeric_limits<double>::infinity();
  for (const engine::BodyId body : {a, b})
    if (body != engine::kWorld)
      size = std::min(size, extent_of(spec.bodies[static_cast<std::size_t>(body)]));
  return std::isfinite(size) && size > 0 ? size : 1;
}

/// The frame at `at` with x and z along two unit vectors that are normal to each other.
Isometry3d axes_at(const Vector3d& at, const Vector3d& x, const Vector3d& z) {
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() << x, z.cross(x), z;
  pose.translation() = at;
  return pose;
}

/// The same with x alone given, or z.
Isometry3d x_axis_at(const Vector3d& at, const Vector3d& x) {
  return axes_at(at, x, x.unitOrthogonal());
}
Isometry3d z_axis_at(const Vector3d& at, const Vector3d& z) {
  return axes_at(at, z.unitOrthogonal(), z);
}

render::ScrewShape screw_of(const engine::PropellerSpec& propeller) {
  render::ScrewShape shape = {.diameter = propeller.screw.diameter,
                              .right_handed = propeller.right_handed};
  if (const auto* series = std::get_if<hydro::WageningenB>(&propeller.screw.model)) {
    shape.blades = series->blades;
    shape.area_ratio = series->area_ratio;
    shape.pitch_ratio = series->pitch_ratio;
  }
  if (const auto* table = std::get_if<hydro::OpenWaterTable>(&propeller.screw.model))
    shape.area_ratio = std::clamp(table->area_ratio, 0.3, 1.0);
  return shape;
}

void add_machines(const engine::SimulationSpec& spec, std::vector<RigPart>& parts) {
  for (std::size_t i = 0; i < spec.propellers.size(); ++i) {
    const engine::PropellerSpec& p = spec.propellers[i];
    parts.push_back({.name = log_name(p),
                     .kind = RigPart::Kind::propeller,
                     .index = i,
                     .body = p.body,
                     .mesh_P = shared(render::screw_mesh(screw_of(p))),
                     .X_BP = x_axis_at(p.at_B, p.axis_B),
                     .color = kBronze});
  }
  for (std::size_t i = 0; i < spec.foils.size(); ++i) {
    const engine::FoilSpec& f = spec.foils[i];
    const bool sail = f.fluid == engine::FoilSpec::Fluid::air;
    parts.push_back(
        {.name = log_name(f),
         .kind = RigPart::Kind::foil,
         .index = i,
         .body = f.body,
         .mesh_P = shared(render::wing_mesh(f.foil.span, f.foil.chord, sail ? 0.03 : 0.15)),
         .X_BP = axes_at(f.at_B, f.chord_B, f.span_B),
         .color = sail ? kSail : kRudder});
  }
}

/// An anchor that lies on the bottom with its shank toward the fairlead; another end in the world
/// is a ball.
RigPart end_in_world(const engine::SimulationSpec& spec, const LineSpec& line,
                     const engine::AttachmentPoint& end, const engine::AttachmentPoint& other) {
  const double size = least_size(spec, line.first.body, line.second.body);
  RigPart part = {.name = log_name(line), .color = kIron};
  part.X_BP.translation() = end.at;
  if (line.kind != LineSpec::Kind::mooring || !line.on_bottom) {
    part.mesh_P =
        shared(hydro::make_icosphere(std::max(0.012 * size, 3 * line_radius(spec, line)), 2));
    return part;
  }
  std::vector<hydro::BodyState> states;
  for (const engine::BodySpec& body : spec.bodies) states.push_back(body.initial);
  Vector3d toward = place_of(other, states) - end.at;
  toward.z() = 0;
  toward = toward.norm() > 0 ? Vector3d(toward.normalized()) : Vector3d::UnitX();
  part.mesh_P = shared(render::anchor_mesh(std::min(0.25 * size, 0.05 * line.length)));
  part.X_BP = axes_at(end.at, toward, Vector3d::UnitZ());
  return part;
}

void add_ends(const engine::SimulationSpec& spec, std::vector<RigPart>& parts) {
  for (const LineSpec& line : spec.lines) {
    if (line.first.body == engine::kWorld)
      parts.push_back(end_in_world(spec, line, line.first, line.second));
    if (line.second.body == engine::kWorld)
      parts.push_back(end_in_world(spec, line, line.second, line.first));
  }
}

hydro::TriMesh pin(double radius, double length) {
  return hydro::make_cylinder(radius, length, 16, 1);
}

/// The mesh of a joint of a size, its axis along z and the second one along x; none for a fixed
/// joint.
std::optional<hydro::TriMesh> joint_mesh(const JointSpec& joint, double size) {
  const double radius = 0.02 * size, length = 0.3 * size;
  switch (joint.type) {
    case JointSpec::Type::ball:
      return hydro::make_icosphere(2 * radius, 2);
    case JointSpec::Type::hinge:
      return hydro::side_by_side(
          {pin(radius, length),
           hydro::translated(pin(1.6 * radius, 0.02 * size), {0, 0, 0.5 * length}),
           hydro::translated(pin(1.6 * radius, 0.02 * size), {0, 0, -0.5 * length})});
    case JointSpec::Type::universal: {
      const Isometry3d across(Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitY()));
      return hydro::side_by_side(
          {pin(radius, length), hydro::transformed(pin(radius, length), across)});
    }
    case JointSpec::Type::slider: {
      double low = -size, high = size;
      if (joint.drive.limits) {
        low = joint.drive.limits->front() - 0.1 * size;
        high = joint.drive.limits->back() + 0.1 * size;
      }
      return hydro::translated(pin(radius, high - low), {0, 0, 0.5 * (low + high)});
    }
    case JointSpec::Type::fixed:
      break;
  }
  return std::nullopt;
}

/// A joint's part is fixed to its first body.
void add_joint(const engine::SimulationSpec& spec, const JointSpec& joint,
               std::vector<RigPart>& parts) {
  const std::optional<hydro::TriMesh> mesh =
      joint_mesh(joint, least_size(spec, joint.first, joint.second));
  if (!mesh) return;
  Vector3d at_W = joint.anchor_W;
  if (joint.type == JointSpec::Type::slider) {
    const engine::BodyId moving = joint.second != engine::kWorld ? joint.second : joint.first;
    if (moving != engine::kWorld)
      at_W = spec.bodies[static_cast<std::size_t>(moving)].initial.position;
  }
  RigPart part = {.body = joint.first, .mesh_P = shared(*mesh), .color = kSteel};
  part.X_BP = joint.type == JointSpec::Type::universal ? axes_at(at_W, joint.axis2_W, joint.axis_W)
                                                       : z_axis_at(at_W, joint.axis_W);
  if (joint.type == JointSpec::Type::ball) part.X_BP = Isometry3d(Eigen::Translation3d(at_W));
  if (part.body != engine::kWorld)
    part.X_BP =
        pose_of(spec.bodies[static_cast<std::size_t>(part.body)].initial).inverse() * part.X_BP;
  parts.push_back(std::move(part));
}

}  // namespace

Isometry3d pose_of(const hydro::BodyState& state) {
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() = state.orientation.toRotationMatrix();
  pose.translation() = state.position;
  return pose;
}

Isometry3d RigPart::turned_B(const engine::SimulationSpec& spec, const DrawnRig& rig) const {
  Eigen::Matrix3d turn_B = Eigen::Matrix3d::Identity();
  if (kind == Kind::foil)
    turn_B =
        Eigen::AngleAxisd(-rig.foil_angles[index], spec.foils[index].span_B).toRotationMatrix();
  if (kind == Kind::propeller) {
    const engine::PropellerSpec& p = spec.propellers[index];
    const DrawnPropeller& now = rig.propellers[index];
    turn_B = Eigen::AngleAxisd(now.azimuth, p.pivot_B) *
             Eigen::AngleAxisd(p.right_handed ? now.turn : -now.turn, p.axis_B);
  }
  Isometry3d pose = X_BP;
  pose.linear() = turn_B * X_BP.linear();
  return pose;
}

std::vector<RigPart> rig_parts(const engine::SimulationSpec& spec, bool joints) {
  std::vector<RigPart> parts;
  add_machines(spec, parts);
  add_ends(spec, parts);
  if (joints)
    for (const JointSpec& joint : spec.joints) add_joint(spec, joint, parts);
  return parts;
}

double line_radius(const engine::SimulationSpec& spec, const LineSpec& line) {
  if (line.drag_diameter > 0) return line.drag_diameter / 2;
  return kLineShare * least_size(spec, line.first.body, line.second.body);
}

double broken_length(const engine::SimulationSpec& spec, const LineSpec& line) {
  return std::min(line.length / 3, 0.3 * least_size(spec, line.first.body, line.second.body));
}

Coil coil_of(const engine::SimulationSpec& spec, const LineSpec& line) {
  const double size = least_size(spec, line.first.body, line.second.body);
  const double radius = line.length > 0 ? std::min(0.05 * size, 0.1 * line.length) : 0.05 * size;
  const double turns = line.length / (1.5 * radius);
  return {.radius = radius, .turns = static_cast<int>(std::clamp(turns, 6.0, 24.0))};
}

}  // namespace app
