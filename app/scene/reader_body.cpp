#include <fmt/format.h>

#include <algorithm>

#include "app/scene/reader_blocks.h"
#include "app/scene/repeat.h"
#include "hydro/decompositions.h"

namespace scene {

namespace {

/// The block `calibrate`.
struct Calibration {
  std::optional<Eigen::Vector3d> drag;
};

void read(MapReader& map, Calibration& calibration) {
  map.required("drag", calibration.drag, positive());
}

void read_name(MapReader& map, std::string& name) {
  map.required("name", name, NameRule{"bodies"});
  if (name == "world") map.fault("name", "found world, which stands for the world in joints");
}

/// Round-off of the principal moments, relative to the largest.
constexpr double kMomentRoundOff = 1e-9;

/// Checks that no principal moment of inertia exceeds the sum of the other two.
void check_inertia(MapReader& map, const Inertia& inertia) {
  Eigen::Matrix3d matrix;
  matrix << inertia.xx, inertia.xy, inertia.xz, inertia.xy, inertia.yy, inertia.yz, inertia.xz,
      inertia.yz, inertia.zz;
  const double scale = matrix.cwiseAbs().maxCoeff();
  if (scale == 0)
    return map.fault("inertia", "found a zero matrix, expected a positive definite one");
  const Eigen::Vector3d moments = scale * hydro::eigenvalues(Eigen::Matrix3d(matrix / scale));
  const std::string found =
      fmt::format("found the principal moments {:.6g}, {:.6g} and {:.6g} kg m^2", moments[0],
                  moments[1], moments[2]);
  if (moments[0] <= 0)
    map.fault("inertia", found + ", expected positive ones");
  else if (moments[2] - moments[1] > moments[0] + kMomentRoundOff * moments[2])
    map.fault("inertia", found + ", expected the largest to be at most the sum of the others");
}

void read_inertia(MapReader& map, std::optional<Inertia>& inertia) {
  std::optional<std::array<double, 6>> entries;
  if (!map.optional("inertia", entries, number("kg m^2"))) return;
  const std::array<double, 6>& e = *entries;
  inertia = Inertia{.xx = e[0], .yy = e[1], .zz = e[2], .xy = e[3], .xz = e[4], .yz = e[5]};
  check_inertia(map, *inertia);
}

/// Reads gyradii k, which make the moments of inertia mass · k².
void read_gyration(MapReader& map, Body& body) {
  std::optional<Eigen::Vector3d> gyradii;
  if (!map.optional("gyration", gyradii, positive("m"))) return;
  const double scale = gyradii->maxCoeff();
  const Eigen::Vector3d squares = (*gyradii / scale).array().square();
  if (2 * squares.maxCoeff() > squares.sum() + kMomentRoundOff)
    return map.fault(
        "gyration",
        fmt::format("found the gyradii {:.6g}, {:.6g} and {:.6g} m, expected the "
                    "largest squared to be at most the sum of the squares of the others",
                    gyradii->x(), gyradii->y(), gyradii->z()));
  if (!body.mass) return;
  const Eigen::Vector3d moments = *body.mass * gyradii->array().square();
  body.inertia = Inertia{.xx = moments.x(), .yy = moments.y(), .zz = moments.z()};
}

void read_mass(MapReader& map, Body& body) {
  map.exactly_one_of({"density", "mass"});
  map.optional("density", body.density, positive("kg/m^3"));
  map.optional("mass", body.mass, positive("kg"));
  map.optional("center_of_mass", body.center_of_mass, number("m"));
  read_inertia(map, body.inertia);
  read_gyration(map, body);
  map.at_most_one_of({"inertia", "gyration"});
  map.note_condition("center_of_mass", "", {"mass"}, {});
  map.note_condition("inertia", "", {"mass"}, {});
  map.note_condition("gyration", "", {"mass"}, {"inertia"});
  if (!map.has("density") || map.has("mass")) return;
  for (const char* key : {"center_of_mass", "inertia", "gyration"})
    if (map.has(key))
      map.fault(key, "follows from density and the mesh; it is allowed with mass only");
}

/// Reads the block `calibrate`. Tabulated drag scales the panels' drag, so there must be some.
void read_calibration(MapReader& map, Body& body) {
  Calibration calibration;
  if (!map.block("calibrate", calibration)) return;
  body.calibrated_drag = calibration.drag;
  if (body.hydro.pressure_drag.none())
    map.fault("calibrate", "scales the pressure drag, which is switched off");
}

const std::vector<std::string> kFreedoms = {"x", "y", "z", "roll", "pitch", "yaw"};

/// Locks one degree of freedom, or all.
void read_lock(const Value& value, std::array<bool, 6>& locked) {
  std::vector<std::string> words = kFreedoms;
  words.push_back("all");
  std::size_t index = 0;
  if (!read_word(value, words, index)) return;
  if (index == kFreedoms.size()) {
    locked.fill(true);
  } else if (locked[index]) {
    value.fault(fmt::format("found {}, which is locked already", value.node.text));
  } else {
    locked[index] = true;
  }
}

void read_locks(MapReader& map, std::array<bool, 6>& locked) {
  const std::string expected = "a list of x, y, z, roll, pitch and yaw, or all";
  ValueShape list = list_shape(words_shape(kFreedoms), 0);
  list.distinct = true;
  ValueShape one = words_shape(kFreedoms);
  one.words.push_back("all");
  const auto value = map.find("lock", expected, "[]", {list, one});
  if (!value) return;
  if (value->node.is(YamlNode::Kind::scalar)) return read_lock(*value, locked);
  if (!value->node.is(YamlNode::Kind::list)) {
    value->refuse(expected);
    return;
  }
  for (std::size_t i = 0; i < value->node.items.size(); ++i) read_lock(value->item(i), locked);
}

Eigen::Quaterniond from_euler(const Eigen::Vector3d& angles) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  return AngleAxisd(angles[2], Vector3d::UnitZ()) * AngleAxisd(angles[1], Vector3d::UnitY()) *
         AngleAxisd(angles[0], Vector3d::UnitX());
}

void read_quaternion(MapReader& map, Eigen::Quaterniond& orientation) {
  std::optional<Eigen::Vector4d> q;
  if (!map.optional("quaternion", q, number())) return;
  if (q->isZero(0))
    return map.fault("quaternion", "found a zero quaternion, expected [w, x, y, z]");
  *q /= q->cwiseAbs().maxCoeff();
  q->normalize();
  orientation = Eigen::Quaterniond((*q)[0], (*q)[1], (*q)[2], (*q)[3]);
}

void read_axis_angle(MapReader& map, Eigen::Quaterniond& orientation) {
  std::optional<Eigen::Vector3d> axis;
  std::optional<double> angle;
  map.optional("axis", axis, number());
  map.optional("angle_deg", angle, degrees());
  map.note_condition("axis", "", {"angle_deg"}, {});
  map.note_condition("angle_deg", "", {"axis"}, {});
  if (map.has("axis") && !map.has("angle_deg"))
    map.fault("angle_deg", "missing, expected the angle about the axis [deg]");
  if (map.has("angle_deg") && !map.has("axis"))
    map.fault("axis", "missing, expected the axis of the angle");
  if (axis && axis->isZero(0)) map.fault("axis", "found a zero axis, expected a direction");
  if (axis && angle && !axis->isZero(0))
    orientation = Eigen::AngleAxisd(*angle, (*axis / axis->cwiseAbs().maxCoeff()).normalized());
}

const ChoiceRule<Collision> kCollisions = {{{"mesh", Collision::mesh},
                                            {"box", Collision::box},
                                            {"sphere", Collision::sphere},
                                            {"none", Collision::none}}};

const ChoiceRule<Start> kStarts = {{{"given", Start::given}, {"equilibrium", Start::equilibrium}}};

/// Checks that a body with `start: equilibrium` has buoyancy and is free to heave, roll or pitch.
void check_start(MapReader& map, const Body& body) {
  if (body.start != Start::equilibrium) {
    if (map.has("heel")) map.fault("heel", "is only used with start: equilibrium");
    return;
  }
  if (body.locked[2] && body.locked[3] && body.locked[4])
    map.fault("start", "equilibrium needs z, roll or pitch to be free, but lock holds all three");
  if (!body.hydro.buoyancy)
    map.fault("start", "equilibrium needs buoyancy, which is false for this body");
}

}  // namespace

void read(MapReader& map, Heel& heel) {
  map.optional("roll_deg", heel.roll, degrees());
  map.optional("pitch_deg", heel.pitch, degrees());
}

namespace {

const ChoiceRule<bool> kFrames = {{{"world", false}, {"body", true}}};

}  // namespace

void read(MapReader& map, Body& body) {
  read_name(map, body.name);
  read_shape(map, body.shape);
  read_mass(map, body);
  map.optional("position", body.position, number("m"));
  map.block("orientation", body.orientation);
  map.optional("start", body.start, kStarts);
  map.note_condition("heel", "", {"start"}, {});
  map.block("heel", body.heel);
  map.optional("linear_velocity", body.linear_velocity, number("m/s"));
  map.optional("angular_velocity", body.angular_velocity, number("rad/s"));
  read_interior(map, body);
  map.block("hydro", body.hydro);
  read_calibration(map, body);
  map.optional("collision", body.collision, kCollisions);
  read_surface(map, body.friction, body.restitution);
  read_locks(map, body.locked);
  map.blocks("forces", body.forces);
  map.optional("color", body.color, between(0, 1));
  // Bodies that are read have been repeated; here the key is listed.
  Repeat repeat;
  map.block("repeat", repeat);
  check_start(map, body);
}

void read(MapReader& map, Eigen::Quaterniond& orientation) {
  const bool angle_only = map.has("angle_deg") && !map.has("axis");
  map.exactly_one_of({"euler_deg", "quaternion", angle_only ? "angle_deg" : "axis"});
  std::optional<Eigen::Vector3d> angles;
  if (map.optional("euler_deg", angles, degrees())) orientation = from_euler(*angles);
  read_quaternion(map, orientation);
  read_axis_angle(map, orientation);
}

void read(MapReader& map, AppliedLoad& load) {
  map.optional("force", load.force, number("N"));
  map.optional("torque", load.torque, number("N m"));
  map.optional("frame", load.in_body_frame, kFrames);
  map.optional("at", load.at, number("m"));
  const bool start_is_right = map.optional("start", load.start, number("s")) || !map.has("start");
  if (map.optional("end", load.end, number("s")) && start_is_right && load.end < load.start)
    map.fault("end", fmt::format("found {:g}, expected a time from start ({:g}) on [s]", load.end,
                                 load.start));
  map.block("sine", load.sine);
  map.optional("factor", load.factor, number());
  std::string formula;
  if (read_formula(map, "formula", formula, false)) load.formula = formula;
  CommandFile file;
  if (read_command_file(map, file)) load.file = file;
  map.at_most_one_of({"sine", "formula", "file"});
  map.at_most_one_of({"factor", "formula", "file"});
  map.note_condition("formula", "", {}, {"sine", "factor", "file"});
  map.note_condition("file", "", {}, {"sine", "factor"});
}

void read(MapReader& map, AppliedLoad::Sine& sine) {
  map.required("frequency_hz", sine.frequency, positive("Hz"));
  map.optional("phase_deg", sine.phase, degrees());
}

}  // namespace scene
