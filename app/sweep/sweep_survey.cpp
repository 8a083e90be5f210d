#include "app/sweep/sweep_survey.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "app/assembly/build.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

struct Shape {
  std::string operator()(const scene::Shapes& s) const {
    std::string text = "shapes";
    for (const scene::PlacedShape& part : s.parts) {
      const Eigen::Vector3d& p = part.position;
      const Eigen::Vector4d& q = part.orientation.coeffs();
      text += fmt::format(" {} at {} {} {} by {} {} {} {}", std::visit(*this, part.shape), p.x(),
                          p.y(), p.z(), q[0], q[1], q[2], q[3]);
    }
    return text;
  }
  std::string operator()(const scene::Mesh& s) const {
    return fmt::format("mesh {} {} {} {}", s.file.string(), s.scale,
                       s.up ? scene::name_of(*s.up) : "", s.unit.value_or(0));
  }
  std::string operator()(const scene::Box& s) const {
    return fmt::format("box {} {} {} {}", s.size.x(), s.size.y(), s.size.z(), s.divisions);
  }
  std::string operator()(const scene::Sphere& s) const {
    return fmt::format("sphere {} {} {}", s.radius, s.slices, s.stacks);
  }
  std::string operator()(const scene::Icosphere& s) const {
    return fmt::format("icosphere {} {}", s.radius, s.subdivisions);
  }
  std::string operator()(const scene::Ellipsoid& s) const {
    return fmt::format("ellipsoid {} {} {} {} {}", s.semi_axes.x(), s.semi_axes.y(),
                       s.semi_axes.z(), s.slices, s.stacks);
  }
  std::string operator()(const scene::Cylinder& s) const {
    return fmt::format("cylinder {} {} {} {}", s.radius, s.height, s.slices, s.stacks);
  }
};

/// Returns a key of everything on which a body's added mass depends; empty if none is solved for.
std::string added_mass_of(const scene::Body& body) {
  using Model = scene::AddedMass::Model;
  const scene::AddedMass& added_mass = body.hydro.added_mass;
  if (added_mass.model != Model::automatic && added_mass.model != Model::deep) return "";
  return fmt::format("{} {}", std::visit(Shape(), body.shape), added_mass.tolerance);
}

void add_files(const scene::Scene& scene, std::set<std::filesystem::path>& files) {
  for (const scene::Body& body : scene.bodies) {
    if (const auto* mesh = std::get_if<scene::Mesh>(&body.shape)) files.insert(mesh->file);
    const auto* shapes = std::get_if<scene::Shapes>(&body.shape);
    for (std::size_t i = 0; shapes != nullptr && i < shapes->parts.size(); ++i)
      if (const auto* mesh = std::get_if<scene::Mesh>(&shapes->parts[i].shape))
        files.insert(mesh->file);
  }
  if (const auto* mesh = std::get_if<scene::Mesh>(&scene.ground)) files.insert(mesh->file);
  if (const auto* heights = std::get_if<scene::HeightField>(&scene.ground))
    files.insert(heights->file);
  if (!scene.water) return;
  if (const auto* heights = std::get_if<scene::HeightField>(&scene.water->surface))
    files.insert(heights->file);
}

/// Distinct faults of several scenes. Faults of overrides that are not in `--set` are attributed to
/// `--vary`.
class AllFaults {
 public:
  explicit AllFaults(const SweepPlan& plan) : plan_(plan) {}

  void add(const scene::InputError& error) {
    for (scene::Fault fault : error.faults()) {
      if (fault.place.file == scene::kOverridePlace && !is_set(fault.key_path))
        fault.place.file = kVaryPlace;
      if (known_.insert(to_string(fault)).second) faults_.push_back(std::move(fault));
    }
  }
  void throw_if_any() const {
    if (!faults_.empty()) throw scene::InputError(faults_);
  }

 private:
  bool is_set(const std::string& key_path) const {
    return std::any_of(
        plan_.overrides.begin(), plan_.overrides.end(),
        [&](const scene::Override& override) { return key_path.starts_with(override.key_path); });
  }

  const SweepPlan& plan_;
  std::set<std::string> known_;
  std::vector<scene::Fault> faults_;
};

/// Fault of each run's scene, if it has one.
using RunFaults = std::vector<std::optional<scene::InputError>>;

bool is_right_alone(const SweepPlan& plan, const scene::Override& override) {
  std::vector<scene::Override> overrides = plan.overrides;
  overrides.push_back(override);
  try {
    scene::read(plan.scene, overrides);
  } catch (const scene::InputError&) {
    return false;
  }
  return true;
}

/// Checks every value of one parameter: a value that is invalid alone and in all its runs is a
/// fault.
void check_values(const SweepPlan& plan, std::size_t parameter, const RunFaults& faults,
                  AllFaults& all) {
  std::map<std::string, std::vector<std::size_t>> runs;  // by value
  for (std::size_t i = 0; i < plan.points.size(); ++i) runs[plan.points[i][parameter]].push_back(i);
  for (const auto& [value, its_runs] : runs) {
    const auto fails = [&](std::size_t run) { return faults[run].has_value(); };
    if (!std::all_of(its_runs.begin(), its_runs.end(), fails)) continue;
    if (!is_right_alone(plan, {plan.parameters[parameter].key_path, value}))
      all.add(*faults[its_runs.front()]);
  }
}

/// Reports faults that all runs would have, such as a missing mesh, before any run starts. The
/// first scene that can be assembled ends the check.
void check_assembly(const SweepPlan& plan, const std::vector<std::size_t>& candidates) {
  AllFaults all(plan);
  for (const std::size_t run : candidates) {
    try {
      assembly::build_without_added_mass(
          scene::read(plan.scene, plan.overrides_of(run), plan.formats));
      return;
    } catch (const scene::InputError& error) {
      all.add(error);
    }
  }
  all.throw_if_any();
}

}  // namespace

std::vector<scene::Override> SweepPlan::overrides_of(std::size_t run) const {
  std::vector<scene::Override> all = overrides;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    all.push_back({parameters[i].key_path, points[run][i]});
  return all;
}

SweepSurvey survey(const SweepPlan& plan) {
  SweepSurvey survey;
  std::set<std::string> names, added_masses;
  std::vector<std::size_t> leaders, others, sound;
  RunFaults faults(plan.points.size());
  for (std::size_t i = 0; i < plan.points.size(); ++i) {
    bool leads = false;
    try {
      const scene::Scene scene = scene::read(plan.scene, plan.overrides_of(i));
      for (const scene::Body& body : scene.bodies) {
        if (names.insert(body.name).second) survey.bodies.push_back(body.name);
        const std::string added_mass = added_mass_of(body);
        if (!added_mass.empty()) leads = added_masses.insert(added_mass).second || leads;
      }
      add_files(scene, survey.files);
      sound.push_back(i);
    } catch (const scene::InputError& error) {
      faults[i] = error;
    }
    (leads ? leaders : others).push_back(i);
  }
  AllFaults all(plan);
  for (std::size_t i = 0; i < plan.parameters.size(); ++i) check_values(plan, i, faults, all);
  all.throw_if_any();
  check_assembly(plan, sound);
  survey.order = leaders;
  survey.order.insert(survey.order.end(), others.begin(), others.end());
  return survey;
}

}  // namespace app
