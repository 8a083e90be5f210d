#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "app/scene/formula.h"
#include "app/scene/reader_blocks.h"
#include "app/scene/rig_names.h"

namespace scene {

namespace {

/// Most names that a fault lists.
constexpr std::size_t kMostNamesListed = 8;

/// Largest distance of an anchor from the bottom that carries its line [m]: of rounding in a scene.
constexpr double kAnchorOffBottom = 0.01;

template <class T>
std::vector<std::string> all_names(const std::vector<T>& named) {
  std::vector<std::string> names;
  for (const T& one : named) names.push_back(one.name);
  return names;
}

/// Ends of a fault of a name that is not there: a similar one, or all if there are few.
std::string advice_for(const std::string& name, const std::vector<std::string>& known) {
  const std::string hint = app::did_you_mean(name, known);
  if (!hint.empty() || known.empty() || known.size() > kMostNamesListed) return hint;
  return ", expected " + app::enumerate(known, "or");
}

/// Checks of one scene's lines, machines and controls.
class RigCheck {
 public:
  RigCheck(MapReader& map, const Scene& scene)
      : map_(map), scene_(scene), bodies_(all_names(scene.bodies)) {}

  void all() {
    check_names();
    check_lines();
    check_machines();
    check_loads();
    check_controls();
  }

 private:
  void check_names() {
    check_unique(map_, "springs", all_names(scene_.springs));
    check_unique(map_, "ropes", all_names(scene_.ropes));
    check_unique(map_, "moorings", all_names(scene_.moorings));
    check_unique(map_, "propellers", all_names(scene_.propellers));
    check_unique(map_, "rudders", all_names(scene_.rudders));
    check_unique(map_, "sails", all_names(scene_.sails));
    check_pumps();
    for (std::size_t i = 0; i < scene_.sails.size(); ++i) {
      const std::string& name = scene_.sails[i].name;
      if (!name.empty() && find_named(scene_.rudders, name) != nullptr)
        map_.fault(fmt::format("sails[{}].name", i),
                   fmt::format("found {}, which is the name of a rudder; expected another", name));
    }
  }

  void check_pumps() {
    std::vector<std::pair<std::string, std::string>> pumps;
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i)
      for (std::size_t k = 0; k < scene_.bodies[i].pumps.size(); ++k)
        pumps.emplace_back(fmt::format("bodies[{}].pumps[{}]", i, k),
                           scene_.bodies[i].pumps[k].name);
    check_unique(map_, pumps);
  }

  void check_body(const std::string& path, const std::string& name, bool world = false) {
    if (name.empty() || (world && name == "world")) return;
    if (std::find(bodies_.begin(), bodies_.end(), name) == bodies_.end())
      map_.fault(
          path, fmt::format("there is no body named {}{}", name, app::did_you_mean(name, bodies_)));
  }

  template <class Tethers>
  void check_tethers(const char* list, const Tethers& tethers) {
    for (std::size_t i = 0; i < tethers.size(); ++i)
      for (std::size_t k = 0; k < 2; ++k)
        check_body(fmt::format("{}[{}].bodies[{}]", list, i, k), tethers[i].bodies[k], true);
  }

  void check_lines() {
    check_tethers("springs", scene_.springs);
    check_tethers("ropes", scene_.ropes);
    for (std::size_t i = 0; i < scene_.moorings.size(); ++i) {
      const std::string path = fmt::format("moorings[{}]", i);
      check_body(path + ".body", scene_.moorings[i].body);
      check_anchor(path, scene_.moorings[i]);
      if (scene_.moorings[i].drag.diameter > 0) need_water(path + ".drag");
    }
    for (std::size_t i = 0; i < scene_.ropes.size(); ++i)
      if (scene_.ropes[i].drag.diameter > 0) need_water(fmt::format("ropes[{}].drag", i));
    if (!scene_.moordyn) return;
    for (std::size_t i = 0; i < scene_.moordyn->bodies.size(); ++i)
      check_body(fmt::format("moorings.bodies[{}]", i), scene_.moordyn->bodies[i]);
  }

  void check_anchor(const std::string& path, const Mooring& mooring) {
    const std::optional<double> bottom = bottom_of(scene_);
    if (!bottom || !map_.has("moorings")) return;
    const double height = mooring.anchor.z() - *bottom;
    if (height < -kAnchorOffBottom)
      map_.fault(path + ".anchor", fmt::format("lies {:.4g} m below the bottom, expected a height "
                                               "of {:g} m or more",
                                               -height, *bottom));
    else if (height > kAnchorOffBottom && mooring.on_bottom)
      map_.fault(path + ".anchor",
                 fmt::format("lies {:.4g} m above the bottom, expected a height of {:g} m, or "
                             "bottom: false for a line that hangs free",
                             height, *bottom));
  }

  void need_water(const std::string& path) {
    if (!scene_.water && !map_.has("water"))
      map_.fault(path, "needs water, and the scene has none");
  }

  void check_machines() {
    for (std::size_t i = 0; i < scene_.propellers.size(); ++i) {
      const std::string path = fmt::format("propellers[{}]", i);
      check_body(path + ".body", scene_.propellers[i].body);
      need_water(path);
    }
    for (std::size_t i = 0; i < scene_.rudders.size(); ++i) {
      const std::string path = fmt::format("rudders[{}]", i);
      check_body(path + ".body", scene_.rudders[i].body);
      need_water(path);
      check_race(path + ".behind", scene_.rudders[i]);
    }
    for (std::size_t i = 0; i < scene_.sails.size(); ++i) {
      const std::string path = fmt::format("sails[{}]", i);
      check_body(path + ".body", scene_.sails[i].body);
      if (!scene_.air && !map_.has("air")) map_.fault(path, "needs air, and the scene has none");
    }
  }

  void check_race(const std::string& path, const Rudder& rudder) {
    if (!rudder.behind) return;
    const Propeller* propeller = find_named(scene_.propellers, *rudder.behind);
    if (propeller == nullptr)
      map_.fault(path, fmt::format("there is no propeller named {}{}", *rudder.behind,
                                   advice_for(*rudder.behind, all_names(scene_.propellers))));
    else if (propeller->body != rudder.body)
      map_.fault(path, fmt::format("{} is a propeller of {}, expected one of the rudder's body {}",
                                   *rudder.behind, propeller->body, rudder.body));
  }

  /// Refuses a formula whose value is not finite at one of two times.
  void check_formula(const std::string& path, const std::string& text, double from, double to) {
    if (text.empty()) return;
    const Formula formula(text);
    for (const double time : {from, to}) {
      const double value = formula.at(time);
      if (std::isfinite(value)) continue;
      return map_.fault(path, fmt::format("is {} at t = {:g} s, expected a finite value",
                                          std::isnan(value) ? "no number" : "infinite", time));
    }
  }

  void check_loads() {
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i)
      for (std::size_t k = 0; k < scene_.bodies[i].forces.size(); ++k) {
        const AppliedLoad& load = scene_.bodies[i].forces[k];
        if (load.formula)
          check_formula(fmt::format("bodies[{}].forces[{}].formula", i, k), *load.formula,
                        std::clamp(load.start, 0.0, scene_.duration),
                        std::clamp(load.end, 0.0, scene_.duration));
      }
  }

  void check_controls() {
    if (scene_.controls.empty()) return;
    const std::vector<SetPoint> points = settable(scene_);
    const std::vector<Measurable> quantities = measurable(scene_);
    std::map<std::string, std::size_t> first_uses;
    for (std::size_t i = 0; i < scene_.controls.size(); ++i) {
      const Control& control = scene_.controls[i];
      const std::string path = fmt::format("controls[{}]", i);
      check_set_point(path + ".set", control.set, points);
      check_only_one(i, first_uses);
      const double end = std::max(scene_.duration, control.start);
      if (const auto* formula = std::get_if<std::string>(&control.source))
        check_formula(path + ".formula", *formula, control.start, end);
      if (const auto* pid = std::get_if<PidControl>(&control.source)) {
        check_measured(path + ".pid.of", pid->of, quantities);
        check_formula(path + ".pid.target", pid->target, control.start, end);
      }
      if (const auto* relay = std::get_if<RelayControl>(&control.source))
        check_measured(path + ".relay.of", relay->of, quantities);
    }
  }

  void check_set_point(const std::string& path, const std::string& name,
                       const std::vector<SetPoint>& points) {
    if (name.empty()) return;
    if (const SetPoint* point = find_named(points, name)) return check_own(path, *point);
    for (const Joint& joint : scene_.joints) {
      if (!name.starts_with(fmt::format("joints[{}].motor.", joint.name))) continue;
      return map_.fault(path, joint.drive.motor
                                  ? fmt::format("found {}, expected joints[{}].motor.{}, which is "
                                                "what drives that motor",
                                                name, joint.name, motor_key(joint))
                                  : fmt::format("joint {} has no motor", joint.name));
    }
    map_.fault(path, fmt::format("there is no set point named {}{}", name,
                                 points.empty() ? ", and the scene has none"
                                                : advice_for(name, all_names(points))));
  }

  /// Refuses a control of what another key of the same block drives.
  void check_own(const std::string& path, const SetPoint& point) {
    if (point.of == SetPoint::Of::load_factor) {
      const AppliedLoad& load = scene_.bodies[point.index].forces[point.load];
      if (load.formula || load.file)
        map_.fault(path, fmt::format("the load has a {} already, expected only one of the two",
                                     load.formula ? "formula" : "file"));
    }
    if (point.of == SetPoint::Of::rope_length && scene_.ropes[point.index].rate != 0)
      map_.fault(fmt::format("ropes[{}].rate", point.index),
                 "not used with a control of the rope's length");
  }

  /// Refuses two controls of one set point, or of both of a winch.
  void check_only_one(std::size_t i, std::map<std::string, std::size_t>& first_uses) {
    const std::string& name = scene_.controls[i].set;
    if (name.empty()) return;
    const bool winch = name.starts_with("ropes[");
    const std::string key = winch ? name.substr(0, name.rfind('.')) : name;
    const auto [first, is_new] = first_uses.emplace(key, i);
    if (is_new) return;
    map_.fault(fmt::format("controls[{}].set", i),
               fmt::format("found {}, but controls[{}] sets {} already; expected only one control",
                           name, first->second, scene_.controls[first->second].set));
  }

  void check_measured(const std::string& path, const std::string& name,
                      const std::vector<Measurable>& quantities) {
    if (name.empty()) return;
    if (const Measurable* found = find_named(quantities, name)) {
      if (found->quantity == "depth") need_water(path);
      return;
    }
    const std::string object = name.substr(0, std::min(name.rfind('.'), name.size()));
    std::vector<std::string> of_object;
    for (const Measurable& quantity : quantities)
      if (quantity.name == object + "." + quantity.quantity) of_object.push_back(quantity.quantity);
    if (of_object.empty())
      return map_.fault(path, fmt::format("there is no quantity named {}{}", name,
                                          advice_for(name, all_names(quantities))));
    map_.fault(path, fmt::format("{} has no quantity {}, expected {}", object,
                                 name.size() > object.size() ? name.substr(object.size() + 1) : "",
                                 app::enumerate(of_object, "or")));
  }

  MapReader& map_;
  const Scene& scene_;
  const std::vector<std::string> bodies_;
};

}  // namespace

std::optional<double> bottom_of(const Scene& scene) {
  if (const auto* plane = std::get_if<PlaneGround>(&scene.ground)) return plane->z;
  if (!std::holds_alternative<std::monostate>(scene.ground)) return std::nullopt;
  if (scene.water && scene.water->depth) return scene.water->level - *scene.water->depth;
  return std::nullopt;
}

void check_rig(MapReader& map, const Scene& scene) { RigCheck(map, scene).all(); }

}  // namespace scene
