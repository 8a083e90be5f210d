#include <fmt/format.h>
#include <pybind11/stl.h>

#include <numeric>
#include <set>
#include <utility>

#include "app/python/arrays.h"
#include "app/python/batch.h"
#include "app/python/bindings.h"
#include "app/scene/rig_names.h"

namespace python {
namespace {

/// A batch's scenes, and the simulations that are to be made of them.
struct Members {
  std::vector<std::shared_ptr<SceneSource>> scenes;
  std::vector<BatchMember> members;
};

/// Returns the members of a batch. Without variation they are copies of one.
/// @param vary   Values of keys, one for each member: {'bodies[0].density': array}.
Members members_of(const std::shared_ptr<SceneSource>& base, std::size_t count, int threads,
                   const py::object& vary) {
  Members all;
  if (vary.is_none() || py::len(vary) == 0) {
    all.scenes.assign(count, base);
  } else {
    for (const auto& [key, values] : vary.cast<py::dict>())
      if (py::len(values) != count)
        throw py::value_error(
            fmt::format("vary: '{}' has {} values, expected one for each of {} "
                        "simulations",
                        py::str(key).cast<std::string>(), py::len(values), count));
    for (std::size_t i = 0; i < count; ++i) {
      py::dict own;
      for (const auto& [key, values] : vary.cast<py::dict>()) own[key] = values[py::int_(i)];
      all.scenes.push_back(scene_from(py::cast(base), own));
    }
  }
  const Unlocked unlocked;
  SceneSource::build_together(all.scenes, threads);
  for (const auto& source : all.scenes) {
    const assembly::BuiltScene& built = source->built(1);
    all.members.push_back({.scene = &source->scene(),
                           .spec = built.spec,
                           .sensors = {source->scene().probes, built.centers_of_mass}});
    all.members.back().spec.record_work = false;
  }
  return all;
}

std::shared_ptr<Batch> batch_of(Members made, int threads,
                                const std::vector<std::string>& observe) {
  const Unlocked unlocked;
  return std::make_shared<Batch>(std::move(made.members), threads, observe);
}

/// Python's Batch.
class PyBatch {
 public:
  PyBatch(const py::object& scene, std::size_t count, int threads, const py::object& vary,
          const std::vector<std::string>& observe)
      : scene_(scene_from(scene, py::none())),
        threads_(threads),
        batch_(batch_of(members_of(scene_, count, threads, vary), threads, observe)) {
    // The arrays keep the batch, not this: a cycle would never be freed.
    const py::capsule owner(new std::shared_ptr<Batch>(batch_), [](void* batch) {
      delete static_cast<std::shared_ptr<Batch>*>(batch);
    });
    const auto n = static_cast<py::ssize_t>(batch_->size());
    const auto bodies = static_cast<py::ssize_t>(batch_->bodies());
    const auto points = static_cast<py::ssize_t>(batch_->spec().set_points.size());
    const app::MotionRows rows = batch_->motions().all();
    time = view(rows.time, {n}, owner, false);
    position = view(rows.position, {n, bodies, 3}, owner, false);
    orientation = view(rows.orientation, {n, bodies, 4}, owner, false);
    velocity = view(rows.velocity, {n, bodies, 3}, owner, false);
    angular_velocity = view(rows.angular_velocity, {n, bodies, 3}, owner, false);
    force = view(batch_->forces().data(), {n, bodies, 3}, owner, true);
    torque = view(batch_->torques().data(), {n, bodies, 3}, owner, true);
    control = view(batch_->controls().data(), {n, points}, owner, true);
    const auto observed = static_cast<py::ssize_t>(batch_->observed().size());
    observation = view(batch_->observations().data(), {n, observed}, owner, false);
  }

  Batch& batch() { return *batch_; }

  /// Steps are taken in portions, so that Ctrl-C ends a long call.
  void step(long count, const py::object& which) {
    if (count < 0) throw py::value_error("step: expected a number of steps >= 0");
    std::vector<std::size_t> some;
    if (!which.is_none()) {
      some = chosen(which);
      if (some.empty()) return;
    }
    const Unlocked unlocked;
    const std::lock_guard lock(busy_);
    constexpr long kPortion = 64;
    SignalCheck check_signals;
    for (long done = 0; done < count; done += kPortion) {
      batch_->step(std::min(kPortion, count - done), some);
      if (count > kPortion) check_signals();
    }
  }

  std::size_t index(py::ssize_t simulation) const {
    const auto n = static_cast<py::ssize_t>(batch_->size());
    if (simulation < -n || simulation >= n)
      throw py::index_error(
          fmt::format("there is no simulation {}: the batch has {}", simulation, n));
    return static_cast<std::size_t>(simulation < 0 ? simulation + n : simulation);
  }

  /// Returns the simulations of an index, a list of them, or a mask, each once and in its order.
  std::vector<std::size_t> chosen(const py::object& which) const {
    const py::module_ numpy = py::module_::import("numpy");
    py::object places = numpy.attr("atleast_1d")(which);
    if (places.attr("dtype").attr("kind").cast<std::string>() == "b") {
      if (py::len(places) != batch_->size())
        throw py::value_error("expected a mask with a value for each simulation");
      places = numpy.attr("flatnonzero")(places);
    }
    std::vector<std::size_t> indices;
    std::set<std::size_t> known;
    for (const py::handle place : places) {
      const std::size_t i = index(place.cast<py::ssize_t>());
      if (known.insert(i).second) indices.push_back(i);
    }
    return indices;
  }

  void reset(const py::object& which, const py::object& vary) {
    std::vector<std::size_t> some(batch_->size());
    std::iota(some.begin(), some.end(), std::size_t{0});
    if (!which.is_none()) some = chosen(which);
    if (vary.is_none() || py::len(vary) == 0) {
      const auto lock = wait();
      for (const std::size_t i : some) batch_->reset(i);
      return;
    }
    Members made = members_of(scene_, some.size(), threads_, vary);
    const Unlocked unlocked;
    const std::lock_guard lock(busy_);
    batch_->replace(some, std::move(made.members));
  }

  void set_motion(py::ssize_t simulation, const py::object& body, const py::object& place,
                  const py::object& turn, const py::object& speed, const py::object& spin) {
    const engine::BodyId id = body_index(batch_->spec(), body);
    const std::size_t i = index(simulation);
    const auto lock = wait();
    const hydro::BodyState before = batch_->at(i).engine().states()[id];
    batch_->set_motion(i, id, moved(before, place, turn, speed, spin));
  }

  py::dict errors() const {
    py::dict errors;
    for (std::size_t i = 0; i < batch_->size(); ++i)
      if (!batch_->errors()[i].empty()) errors[py::int_(i)] = batch_->errors()[i];
    return errors;
  }

  py::bytes save(py::ssize_t simulation) {
    const auto lock = wait();
    return batch_->save(index(simulation));
  }
  void load(py::ssize_t simulation, const std::string& state) {
    const auto lock = wait();
    batch_->load(index(simulation), state);
  }

  py::array time, position, orientation, velocity, angular_velocity, force, torque, control,
      observation;

 private:
  std::unique_lock<std::mutex> wait() { return locked(busy_); }

  std::shared_ptr<SceneSource> scene_;
  int threads_;
  std::shared_ptr<Batch> batch_;
  std::mutex busy_;
};

}  // namespace
}  // namespace python

namespace pybind11::detail {

template <>
struct type_caster<python::PyBatch> : python::MadeCaster<python::PyBatch> {};

}  // namespace pybind11::detail

namespace python {

void bind_batch(py::module_& module) {
  using B = PyBatch;
  const auto none = py::none();
  py::class_<B>(module, "Batch",
                "n simulations of one scene that are stepped together on several threads. Each "
                "gives the bits that it would give alone.\n\n"
                "All arrays are live views. time, position, orientation, velocity, "
                "angular_velocity and observation are read-only; force, torque and control are "
                "written to.")
      .def(py::init<const py::object&, std::size_t, int, const py::object&,
                    const std::vector<std::string>&>(),
           py::arg("scene"), py::arg("n"), py::arg("threads") = 0, py::arg("vary") = none,
           py::arg("observe") = std::vector<std::string>(),
           "scene: a Scene, a path or a dict. threads: 0 for all cores. vary: values of keys, one "
           "for each simulation: {'bodies[buoy].density': numpy.linspace(300, 900, n)}. Bodies of "
           "one mesh share their hull and its added mass. observe: names of what observation "
           "holds, of those that Simulation.observables lists.")
      .def("step", &B::step, py::arg("count") = 1, py::arg("which") = none,
           "Takes steps of all simulations, or of some: an index, a list, or a mask. One that "
           "fails stands still from then on; errors tells why.")
      .def("__len__", [](B& b) { return b.batch().size(); })
      .def_property_readonly(
          "bodies", [](B& b) { return scene::names_of(b.batch().spec().bodies); },
          "Names of the bodies, in order.")
      .def_property_readonly(
          "set_points", [](B& b) { return scene::names_of(b.batch().spec().set_points); },
          "Names of what can be set, in the order of the columns of control.")
      .def_property_readonly(
          "step_length", [](B& b) { return b.batch().spec().step; }, "[s]")
      .def_readonly("time", &B::time, "(n,) [s]")
      .def_readonly("position", &B::position, "(n, bodies, 3): the centres of mass, in W [m].")
      .def_readonly("orientation", &B::orientation, "(n, bodies, 4): w, x, y, z.")
      .def_readonly("velocity", &B::velocity, "(n, bodies, 3), in W [m/s].")
      .def_readonly("angular_velocity", &B::angular_velocity, "(n, bodies, 3), in W [rad/s].")
      .def_readonly("force", &B::force,
                    "(n, bodies, 3): forces that act at the centres of mass in every step, in W "
                    "[N].")
      .def_readonly("torque", &B::torque, "(n, bodies, 3): the same for torques [N m].")
      .def_readonly("control", &B::control,
                    "(n, set points): values in the units of their names; NaN, as at first, "
                    "leaves a set point to the scene.")
      .def_readonly("observation", &B::observation,
                    "(n, observed names): numbers in the units of their names, as "
                    "Simulation.observe gives them.")
      .def_property_readonly(
          "observed", [](B& b) { return b.batch().observed(); },
          "Names of the columns of observation.")
      .def(
          "index", [](B& b, const py::object& body) { return body_index(b.batch().spec(), body); },
          py::arg("body"), "Index of a body by its name.")
      .def(
          "set_point",
          [](B& b, const std::string& name) { return set_point_index(b.batch().spec(), name); },
          py::arg("name"), "Column of a set point in control, by its name.")
      .def_property_readonly("errors", &B::errors,
                             "Why simulations stand still: {index: text}. A reset or a load ends "
                             "it.")
      .def("reset", &B::reset, py::arg("which") = none, py::arg("vary") = none,
           "Back to time 0, without loads and set values: all, an index, a list, or a mask. vary: "
           "values of keys, one for each of those that are reset, which begin with them in place "
           "of the scene's: {'water.surface.spectrum.seed': [7, 8]} gives two another sea. They "
           "hold until the next reset with vary, and bodies and set points keep their names.")
      .def("set_motion", &B::set_motion, py::arg("simulation"), py::arg("body"),
           py::arg("position") = none, py::arg("orientation") = none, py::arg("velocity") = none,
           py::arg("angular_velocity") = none, "As Simulation.set_motion.")
      .def("save", &B::save, py::arg("simulation"),
           "Everything that changes in a simulation, as bytes, which Simulation.load takes, too.")
      .def("load", &B::load, py::arg("simulation"), py::arg("state"),
           "Restores a simulation from what save gave for any of them.")
      .def("__repr__", [](B& b) {
        return fmt::format("<Batch of {} simulations of {} bodies>", b.batch().size(),
                           b.batch().bodies());
      });
}

}  // namespace python
