#include <fmt/format.h>

#include "app/scene/reader_blocks.h"

namespace scene {

namespace {

/// Reads `points`: a list of two points.
void read_points(MapReader& map, std::array<Eigen::Vector3d, 2>& points) {
  const NumberRule rule = number("m");
  const std::string expected = "a list of 2 points, each a list of 3 numbers [m]";
  const auto value =
      map.find("points", expected, "required", {list_shape(shape(rule, false, 3), points.size())});
  if (!value) return;
  if (!value->node.is(YamlNode::Kind::list) || value->node.items.size() != points.size()) {
    value->refuse(expected);
    return;
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    read_numbers(value->item(i), rule, {points[i].data(), 3});
}

/// Reads the keys that springs and ropes share.
void read_tether(MapReader& map, Tether& tether, const char* among) {
  map.required("name", tether.name, NameRule{among, false});
  read_pair(map, tether.bodies);
  read_points(map, tether.points);
  map.optional("length", tether.length, not_negative("m"));
  map.required("stiffness", tether.stiffness, positive("N/m"));
  map.optional("damping", tether.damping, not_negative("N s/m"));
  map.optional("breaks_at", tether.breaks_at, positive("N"));
}

constexpr int kMostSegments = 1000;

/// Reads the keys of inertia where the line has it, or refuses them with the key that they need.
void read_inertia(MapReader& map, const LineDrag& drag, std::optional<LineInertia>& inertia,
                  const char* needed) {
  LineInertia read;
  map.optional("segments", read.segments, between(1, kMostSegments));
  map.optional("mass", read.mass, positive("kg/m"));
  if (inertia) {
    inertia = read;
    return;
  }
  for (const auto& [key, given] :
       {std::pair("segments", map.has("segments")), std::pair("mass", map.has("mass")),
        std::pair("drag.along", drag.along.has_value()),
        std::pair("drag.added_mass", drag.added_mass.has_value())})
    if (given) map.fault(key, fmt::format("is only used with {}", needed));
}

}  // namespace

void read(MapReader& map, LineDrag& drag) {
  map.required("diameter", drag.diameter, positive("m"));
  map.optional("coefficient", drag.coefficient, not_negative());
  map.optional("along", drag.along, not_negative());
  map.optional("added_mass", drag.added_mass, not_negative());
}

void read(MapReader& map, Spring& spring) { read_tether(map, spring, "springs"); }

void read(MapReader& map, Rope& rope) {
  read_tether(map, rope, "ropes");
  map.optional("rate", rope.rate, number("m/s"));
  map.optional("shortest", rope.shortest, not_negative("m"));
  if (rope.length && rope.shortest > *rope.length)
    map.fault("shortest", fmt::format("found {:g}, expected at most the length of {:g} m",
                                      rope.shortest, *rope.length));
  map.optional("weight", rope.weight, number("N/m"));
  map.block("drag", rope.drag);
  if (map.has("weight")) rope.inertia.emplace();
  read_inertia(map, rope.drag, rope.inertia, "weight, which makes a rope hang");
  if (map.has("drag") && !rope.inertia)
    map.fault("drag", "is only used with weight, which makes a rope hang");
}

void read(MapReader& map, Mooring& mooring) {
  map.required("name", mooring.name, NameRule{"moorings", false});
  map.required("body", mooring.body, TextRule{"the name of a body"});
  map.required("fairlead", mooring.fairlead, number("m"));
  map.required("anchor", mooring.anchor, number("m"));
  map.required("length", mooring.length, positive("m"));
  map.required("weight", mooring.weight, not_negative("N/m"));
  map.required("stiffness", mooring.stiffness, positive("N"));
  map.optional("friction", mooring.friction, not_negative());
  map.optional("bottom", mooring.on_bottom, TruthRule{});
  map.block("drag", mooring.drag);
  map.optional("breaks_at", mooring.breaks_at, positive("N"));
  bool dynamic = false;
  map.optional("model", dynamic, ChoiceRule<bool>{{{"static", false}, {"dynamic", true}}});
  if (dynamic) mooring.inertia.emplace();
  read_inertia(map, mooring.drag, mooring.inertia, "model: dynamic");
  if (map.has("friction") && !mooring.on_bottom)
    map.fault("friction", "is only used with bottom: true, where the line lies on the bottom");
}

void read(MapReader& map, MoorDyn& moordyn) {
  map.required("moordyn", moordyn.file, FileRule{});
  const std::string expected = "a list of names of bodies";
  ValueShape names = list_shape({.kind = ValueShape::Kind::text}, 0);
  names.least = 1;
  const auto value = map.find("bodies", expected, "required", {names});
  if (!value) return;
  if (!value->node.is(YamlNode::Kind::list) || value->node.items.empty()) {
    value->refuse(expected);
    return;
  }
  const TextRule name{"the name of a body"};
  for (std::size_t i = 0; i < value->node.items.size(); ++i)
    Field<TextRule, std::string>::read(value->item(i), name, moordyn.bodies.emplace_back());
}

}  // namespace scene
