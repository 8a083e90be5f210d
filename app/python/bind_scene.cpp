#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <chrono>

#include "app/base/words.h"
#include "app/python/bindings.h"
#include "app/scene/rig_names.h"

namespace python {
namespace {

/// Returns a value as JSON, which is YAML. NumPy's arrays and numbers are those of Python.
std::string to_yaml(const py::object& value) {
  const py::object plain = py::module_::import("plimsoll._values").attr("plain")(value);
  return py::module_::import("json").attr("dumps")(plain).cast<std::string>();
}

/// Returns `main` of `propellers[main].speed_rps`.
std::string owner_of(const std::string& set_point) {
  const std::size_t open = set_point.find('['), close = set_point.find(']');
  return close == std::string::npos ? set_point : set_point.substr(open + 1, close - open - 1);
}

std::string known(const std::string& name, const std::vector<std::string>& names) {
  const std::string hint = app::did_you_mean(name, names);
  if (!hint.empty()) return hint;
  return names.empty() ? "; there is none" : "; expected " + app::enumerate(names, "or");
}

}  // namespace

std::vector<scene::Override> overrides_from(const py::object& values) {
  std::vector<scene::Override> overrides;
  if (values.is_none()) return overrides;
  for (const auto& [key, value] : values.cast<py::dict>())
    overrides.push_back(
        {key.cast<std::string>(), to_yaml(py::reinterpret_borrow<py::object>(value))});
  return overrides;
}

scene::MeshFormats formats_from(bool any_format) {
  return any_format ? scene::MeshFormats::any : scene::MeshFormats::common;
}

std::shared_ptr<SceneSource> scene_from(const py::object& source, const py::object& overrides,
                                        bool any_format) {
  std::vector<scene::Override> set = overrides_from(overrides);
  scene::MeshFormats formats = formats_from(any_format);
  if (py::isinstance<SceneSource>(source)) {
    const auto scene = source.cast<std::shared_ptr<SceneSource>>();
    const scene::MeshFormats present = scene->scene().mesh_formats;
    if (!any_format) formats = present;
    if (set.empty() && formats == present) return scene;
    std::vector<scene::Override> all = scene->overrides();
    all.insert(all.end(), set.begin(), set.end());
    return std::make_shared<SceneSource>(scene->scene().text, scene->scene().file, std::move(all),
                                         formats);
  }
  if (py::isinstance<py::dict>(source)) {
    const auto file = std::filesystem::current_path() / "<dict>";
    return std::make_shared<SceneSource>(to_yaml(source), file, std::move(set), formats);
  }
  const auto file = source.cast<std::filesystem::path>();
  const Unlocked unlocked;
  return std::make_shared<SceneSource>(file, std::move(set), formats);
}

engine::BodyId body_index(const engine::SimulationSpec& spec, const py::object& body) {
  if (py::isinstance<py::str>(body)) {
    const auto name = body.cast<std::string>();
    const std::vector<std::string> names = scene::names_of(spec.bodies);
    const auto found = std::ranges::find(names, name);
    if (found != names.end()) return static_cast<engine::BodyId>(found - names.begin());
    throw py::key_error(fmt::format("there is no body '{}'{}", name, known(name, names)));
  }
  const auto index = body.cast<py::ssize_t>();
  const auto count = static_cast<py::ssize_t>(spec.bodies.size());
  if (index < -count || index >= count)
    throw py::index_error(fmt::format("there is no body {}: the scene has {}", index, count));
  return static_cast<engine::BodyId>(index < 0 ? index + count : index);
}

engine::SetPointId set_point_index(const engine::SimulationSpec& spec, const std::string& name) {
  const std::vector<std::string> names = scene::names_of(spec.set_points);
  std::vector<std::size_t> owned;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return static_cast<engine::SetPointId>(i);
    if (owner_of(names[i]) == name) owned.push_back(i);
  }
  if (owned.size() == 1) return static_cast<engine::SetPointId>(owned.front());
  if (owned.empty())
    throw py::key_error(fmt::format("there is no set point '{}'{}", name, known(name, names)));
  std::vector<std::string> several;
  for (const std::size_t i : owned) several.push_back(names[i]);
  throw py::key_error(
      fmt::format("'{}' has several set points: {}", name, app::enumerate(several, "and")));
}

std::unique_lock<std::mutex> locked(std::mutex& mutex) {
  std::unique_lock lock(mutex, std::try_to_lock);
  if (lock.owns_lock()) return lock;
  Unlocked unlocked;
  lock.lock();
  if (!unlocked.will_return()) lock.unlock();
  return lock;
}

void SignalCheck::operator()() {
  using Clock = std::chrono::steady_clock;
  const double now = std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
  if (last_ == 0) last_ = now;
  if (now - last_ < 0.05) return;
  last_ = now;
  if (is_overtaken()) throw std::runtime_error("Python has ended");
  const py::gil_scoped_acquire locked;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

void bind_scene(py::module_& module) {
  py::class_<SceneSource, std::shared_ptr<SceneSource>>(
      module, "Scene",
      "A scene that has been read and checked. Nothing is simulated until a Simulation or a Batch "
      "is made of it.")
      .def(py::init(&scene_from), py::arg("source"), py::arg("set") = py::none(),
           py::arg("any_format") = false)
      .def_static("load", &scene_from, py::arg("source"), py::arg("set") = py::none(),
                  py::arg("any_format") = false,
                  "Reads a scene: a path of a YAML file, or a dict with the same keys, whose paths "
                  "are relative to the working directory.\n\n"
                  "set: values that replace or add keys, {'bodies[buoy].density': 500}.\n"
                  "any_format: meshes may be in any format, beyond .obj, .stl, .ply, .off, .gltf "
                  "and .glb.\n"
                  "Raises SceneError with every fault.")
      .def_property_readonly(
          "file", [](const SceneSource& s) { return s.scene().file.string(); },
          "Its file; `<dict>` in the working directory for a dict.")
      .def_property_readonly(
          "title", [](const SceneSource& s) { return s.scene().title; }, "Its key `title`.")
      .def_property_readonly(
          "text", [](const SceneSource& s) { return s.scene().text; },
          "The scene as it was written, without `set`.")
      .def_property_readonly(
          "duration", [](const SceneSource& s) { return s.scene().duration; },
          "Time that a run of the scene simulates [s].")
      .def_property_readonly(
          "step", [](const SceneSource& s) { return s.scene().step; }, "Length of a step [s].")
      .def_property_readonly(
          "bodies", [](const SceneSource& s) { return scene::names_of(s.scene().bodies); },
          "Names of the bodies, in order.")
      .def_property_readonly(
          "set_points",
          [](const SceneSource& s) { return scene::names_of(scene::set_points(s.scene())); },
          "Names of what can be set: `propellers[main].speed_rps`.")
      .def("__repr__", [](const SceneSource& s) {
        return fmt::format("<Scene {} of {} bodies>", s.scene().file.string(),
                           s.scene().bodies.size());
      });
}

}  // namespace python
