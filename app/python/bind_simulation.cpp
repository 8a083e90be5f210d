#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <mutex>
#include <utility>

#include "app/base/thread_count.h"
#include "app/held/held_simulation.h"
#include "app/held/observer.h"
#include "app/logs/force_log.h"
#include "app/logs/hdf5_layout.h"
#include "app/pictures/cameras.h"
#include "app/pictures/snapshot.h"
#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/python/readings.h"
#include "app/python/run_folder.h"
#include "app/render/image.h"
#include "app/scene/rig_names.h"

namespace python {
namespace {

/// Inputs of a simulation: its scene, and the number of threads.
struct Parts {
  engine::SimulationSpec spec;
  app::SensorSpec sensors;
};

Parts parts_of(SceneSource& source, int threads, bool forces) {
  const Unlocked unlocked;
  Parts parts{.spec = source.spec(threads, forces),
              .sensors = {source.scene().probes, source.built(threads).centers_of_mass}};
  parts.spec.threads = app::thread_count(threads);
  parts.spec.record_work = forces || source.scene().log_forces;
  return parts;
}

/// Python's Simulation. Its calls may come from several threads: one at a time is served.
class PySimulation {
 public:
  PySimulation(const std::shared_ptr<SceneSource>& source, int threads, bool forces)
      : PySimulation(source, parts_of(*source, threads, forces)) {}

  PySimulation(std::shared_ptr<SceneSource> source, Parts parts)
      : source_(std::move(source)),
        motions_(std::make_shared<app::MotionArrays>(1, source_->scene().bodies.size())),
        held_(std::move(parts.spec), motions_->all(), parts.sensors),
        observables_(source_->scene(), held_) {
    held_.show();
    // The arrays keep the motions, not this: a cycle would never be freed.
    const py::capsule owner(new std::shared_ptr<app::MotionArrays>(motions_), [](void* motions) {
      delete static_cast<std::shared_ptr<app::MotionArrays>*>(motions);
    });
    const auto bodies = static_cast<py::ssize_t>(spec().bodies.size());
    const app::MotionRows rows = motions_->all();
    position = view(rows.position, {bodies, 3}, owner, false);
    orientation = view(rows.orientation, {bodies, 4}, owner, false);
    velocity = view(rows.velocity, {bodies, 3}, owner, false);
    angular_velocity = view(rows.angular_velocity, {bodies, 3}, owner, false);
  }

  ~PySimulation() {
    try {
      close_log();
    } catch (const std::exception& error) {
      PySys_WriteStderr("plimsoll: the log could not be ended: %.500s\n", error.what());
    }
  }

  const engine::SimulationSpec& spec() const { return engine().spec(); }
  const engine::Simulation& engine() const { return held_.engine(); }
  const std::shared_ptr<SceneSource>& source() const { return source_; }
  double time() const { return engine().time(); }

  void step(long count) {
    if (count < 0) throw py::value_error("step: expected a number of steps >= 0");
    const Unlocked unlocked;
    const std::lock_guard lock(busy_);
    const Showing showing{held_};
    SignalCheck check_signals;
    for (long n = 0; n < count; ++n) {
      if (log_) log_->before_step(engine());
      held_.step();
      if (log_) log_->keep(engine());
      if (count > 1) check_signals();
    }
  }

  void apply(const py::object& body, const py::object& force, const py::object& torque,
             const py::object& at, const std::string& frame) {
    const engine::BodyId id = body_index(spec(), body);
    if (frame != "world" && frame != "body")
      throw py::value_error("frame: found '" + frame + "', expected 'world' or 'body'");
    const auto lock = wait();
    if (force.is_none() && torque.is_none()) return held_.let_go(id);
    app::HeldLoad load{.frame = frame == "world" ? engine::Frame::world : engine::Frame::body};
    if (!force.is_none()) load.wrench.force = to_vector(force.cast<Array>(), "force");
    if (!torque.is_none()) load.wrench.moment = to_vector(torque.cast<Array>(), "torque");
    if (!at.is_none())
      load.at_B = to_vector(at.cast<Array>(), "at") - source_->built(1).centers_of_mass[id];
    held_.hold(id, load);
  }

  void set_motion(const py::object& body, const py::object& place, const py::object& turn,
                  const py::object& speed, const py::object& spin) {
    const engine::BodyId id = body_index(spec(), body);
    const auto lock = wait();
    const hydro::BodyState state = moved(engine().states()[id], place, turn, speed, spin);
    held_.set_motion(id, state);
  }

  void set(const std::string& name, double value) {
    const engine::SetPointId id = set_point_index(spec(), name);
    const auto lock = wait();
    held_.set(id, value);
  }
  void release(const std::string& name) {
    const engine::SetPointId id = set_point_index(spec(), name);
    const auto lock = wait();
    held_.release(id);
  }
  double control(const std::string& name) const {
    const engine::SetPointId id = set_point_index(spec(), name);
    const auto lock = wait();
    return engine().set_value(id).value_or(engine().rig().set_points[id]);
  }

  py::dict forces(const py::object& body) const {
    const engine::BodyId id = body_index(spec(), body);
    if (!spec().record_work)
      throw py::value_error("this simulation was made with forces=False, so it keeps none");
    std::vector<double> row;
    {
      const auto lock = wait();
      const Unlocked unlocked;
      row = app::force_row(engine().forces()[id]);
    }
    return forces_of(row);
  }

  py::dict readings() const {
    const auto lock = wait();
    return readings_of(held_);
  }

  std::vector<std::string> observables() const { return observables_.names(); }

  py::array observe(const std::vector<std::string>& names) const {
    const app::Observer observer(observables_, names);
    std::vector<double> numbers(observer.size());
    const auto lock = wait();
    observer.read(held_, numbers.data());
    return to_array(numbers);
  }

  py::bytes save() const {
    const auto lock = wait();
    return held_.save();
  }
  void load(const std::string& state) {
    const auto lock = wait();
    held_.load(state);
  }
  void reset() {
    const auto lock = wait();
    held_.reset();
  }

  void log_to(const std::filesystem::path& folder, const std::string& format) {
    if (format != "csv" && format != "hdf5")
      throw py::value_error("format: found '" + format + "', expected 'csv' or 'hdf5'");
    if (format == "hdf5" && !app::why_no_hdf5().empty())
      throw py::value_error("format: " + app::why_no_hdf5());
    close_log();
    const auto lock = wait();
    log_ = std::make_unique<RunFolder>(source_->scene(), source_->built(1), source_->overrides(),
                                       format == "csv" ? app::LogFormat::csv : app::LogFormat::hdf5,
                                       folder, spec().threads);
    log_->keep(engine());
  }
  void close_log() {
    const auto lock = wait();
    if (const std::unique_ptr<RunFolder> log = std::exchange(log_, nullptr)) log->finish(engine());
  }

  py::array render(const py::object& camera, const py::object& size, bool overlay) {
    const scene::Camera view = camera_from(camera);
    const scene::Render look = source_->scene().render.value_or(scene::Render());
    const auto pixels = size.is_none() ? look.size : size.cast<std::array<int, 2>>();
    if (pixels[0] < 1 || pixels[1] < 1)
      throw py::value_error("size: expected a width and a height of at least one pixel");
    render::Image image;
    std::vector<std::string> warnings;
    {
      const auto lock = wait();
      const Unlocked unlocked;
      if (!snapshots_) {
        snapshots_.emplace(source_->scene(), source_->built(1));
        warnings = snapshots_->warnings();
      }
      image = snapshots_->draw(engine(), view, pixels, overlay && look.overlay);
    }
    for (const std::string& warning : warnings)
      if (PyErr_WarnEx(PyExc_UserWarning, warning.c_str(), 1) < 0) throw py::error_already_set();
    return py::array_t<std::uint8_t>({image.height, image.width, 3}, image.rgb.data());
  }

  py::array position, orientation, velocity, angular_velocity;

 private:
  /// Shows the motion at the end of a call, whether it throws or not.
  struct Showing {
    const app::HeldSimulation& held;
    ~Showing() { held.show(); }
  };

  std::unique_lock<std::mutex> wait() const { return locked(busy_); }

  /// Returns the camera of a name or a dict; by default the scene's first.
  scene::Camera camera_from(const py::object& camera) const {
    if (py::isinstance<py::dict>(camera)) {
      py::dict set;
      set["render"] = py::dict(py::arg("camera") = camera);
      return scene_from(py::cast(source_), set)->scene().render->camera;
    }
    const auto look = source_->scene().render.value_or(scene::Render());
    const std::vector<scene::Camera> cameras = app::cameras_of(look);
    if (camera.is_none()) return cameras.front();
    const auto name = camera.cast<std::string>();
    for (const scene::Camera& one : cameras)
      if (one.name == name) return one;
    throw py::key_error("there is no camera '" + name + "'");
  }

  std::shared_ptr<SceneSource> source_;
  std::shared_ptr<app::MotionArrays> motions_;
  app::HeldSimulation held_;
  app::Observables observables_;
  std::unique_ptr<RunFolder> log_;
  std::optional<app::Snapshots> snapshots_;
  mutable std::mutex busy_;
};

/// The set points of a simulation as a mapping.
struct Control {
  PySimulation& simulation;
};

}  // namespace
}  // namespace python

namespace pybind11::detail {

template <>
struct type_caster<python::PySimulation> : python::MadeCaster<python::PySimulation> {};
template <>
struct type_caster<python::Control> : python::MadeCaster<python::Control> {};

}  // namespace pybind11::detail

namespace python {
namespace {

void bind_control(py::module_& module) {
  const auto names = [](const Control& control) {
    return py::list(py::cast(scene::names_of(control.simulation.spec().set_points)));
  };
  py::class_<Control>(
      module, "Control",
      "The set points of a simulation by name, in the units of their names: "
      "control['propellers[main].speed_rps'] = 2.5, or control['main'] where the "
      "propeller has a single one. A value that is set replaces the scene's control "
      "until it is deleted.")
      .def("__getitem__",
           [](const Control& c, const std::string& n) { return c.simulation.control(n); })
      .def("__setitem__",
           [](Control& c, const std::string& n, double value) { c.simulation.set(n, value); })
      .def("__delitem__", [](Control& c, const std::string& n) { c.simulation.release(n); })
      .def("__len__", [](const Control& c) { return c.simulation.spec().set_points.size(); })
      .def("__iter__", [names](const Control& c) { return names(c).attr("__iter__")(); })
      .def("__contains__",
           [names](const Control& c, const py::object& name) { return names(c).contains(name); })
      .def("keys", names, "Names of all set points.");
}

py::array masses(const PySimulation& s) {
  std::vector<double> masses;
  for (const engine::BodySpec& body : s.spec().bodies) masses.push_back(body.mass);
  return to_array(masses);
}

std::string repr(const PySimulation& s) {
  return fmt::format("<Simulation of {} at {:g} s>", s.source()->scene().file.string(), s.time());
}

}  // namespace

void bind_simulation(py::module_& module) {
  bind_control(module);
  using S = PySimulation;
  const auto none = py::none();
  py::class_<S>(module, "Simulation",
                "A scene that is stepped. Quantities are in SI units; W is the world, z up.\n\n"
                "position, orientation, velocity and angular_velocity are read-only views with a "
                "row for each of N bodies. They always show the present state; copy them to keep "
                "one.")
      .def(py::init([](const py::object& scene, int threads, bool forces) {
             return std::make_unique<S>(scene_from(scene, py::none()), threads, forces);
           }),
           py::arg("scene"), py::arg("threads") = 1, py::arg("forces") = true,
           "scene: a Scene, a path or a dict. threads: how many compute at most, 0 for all cores; "
           "results do not depend on it. forces: keep what forces() tells.\n\n"
           "The first simulation of a scene reads meshes and finds the added mass, from the store "
           "in the user's cache or anew, which may take minutes. Raises SceneError.")
      .def("step", &S::step, py::arg("count") = 1,
           "Takes steps. Raises SimulationError if the state or a load is no longer finite; the "
           "state before that step is kept.")
      .def_property_readonly("scene", &S::source, "The Scene that it was made of.")
      .def_property_readonly("time", &S::time, "[s]")
      .def_property_readonly(
          "steps", [](const S& s) { return s.engine().steps(); }, "Number of steps taken.")
      .def_property_readonly(
          "bodies", [](const S& s) { return scene::names_of(s.spec().bodies); },
          "Names of the bodies, in order.")
      .def_property_readonly("mass", &masses, "(N,) [kg]")
      .def_readonly("position", &S::position, "(N, 3): the centres of mass, in W [m].")
      .def_readonly("orientation", &S::orientation,
                    "(N, 4): w, x, y, z, from the body's axes to W.")
      .def_readonly("velocity", &S::velocity, "(N, 3): of the centres of mass, in W [m/s].")
      .def_readonly("angular_velocity", &S::angular_velocity, "(N, 3): in W [rad/s].")
      .def(
          "index", [](const S& s, const py::object& b) { return body_index(s.spec(), b); },
          py::arg("body"), "Row of a body in the arrays, by its name. Raises KeyError.")
      .def("apply", &S::apply, py::arg("body"), py::arg("force") = none, py::arg("torque") = none,
           py::arg("at") = none, py::arg("frame") = "world",
           "Holds a load on a body in all steps until it is changed; without force and torque it "
           "ends.\n\nforce (3,) [N]; torque (3,) [N m] beside it; at (3,): where the force acts, "
           "a point of the body in the frame of its mesh [m], by default its centre of mass; "
           "frame: axes of force and torque, 'world' or 'body'.")
      .def("set_motion", &S::set_motion, py::arg("body"), py::arg("position") = none,
           py::arg("orientation") = none, py::arg("velocity") = none,
           py::arg("angular_velocity") = none,
           "Puts a body in another state of motion, as far as its locks allow. Arguments that "
           "are not given leave their quantities unchanged.")
      .def_property_readonly(
          "control", [](S& s) { return Control{s}; }, py::keep_alive<0, 1>(),
          "The set points by name (Control).")
      .def("forces", &S::forces, py::arg("body"),
           "The loads on a body in its present state, as in forces.csv: each load as (6,), force "
           "[N] and moment [N m] about the centre of mass, in W; areas, energies and works as "
           "numbers.")
      .def("readings", &S::readings,
           "Lines, joints, machines and controls in the present state, as in lines.csv and the "
           "other tables: readings()['lines']['ropes[tow]']['tension']. 'probes' has those of the "
           "scene's log.probes by name. A point of a body reads as instruments on board do, in "
           "body axes: velocity vx, vy, vz [m/s], acceleration ax, ay, az [m/s^2], angular "
           "velocity wx, wy, wz [rad/s], and specific force a - g as specific_x, specific_y, "
           "specific_z [m/s^2]. An acceleration is the change of velocity in the last step over "
           "the step, and zero before the first.")
      .def_property_readonly("observables", &S::observables,
                             "Names that observe() takes: quantities of bodies as "
                             "'tug.heading_deg', columns of readings() as 'ropes[tow].tension' "
                             "and 'probes[imu].specific_z'.")
      .def("observe", &S::observe, py::arg("names"),
           "Some observables in the present state, (names,), in the units of their names. Raises "
           "KeyError for an unknown name.")
      .def("save", &S::save,
           "Everything that changes, as bytes. A simulation of the same scene that loads them goes "
           "on to the same bits.")
      .def("load", &S::load, py::arg("state"),
           "Restores what save() gave. Raises ValueError for the state of another scene.")
      .def("reset", &S::reset, "Back to time 0, without held loads and set values.")
      .def("log_to", &S::log_to, py::arg("folder"), py::arg("format") = "csv",
           "Logs the present and all coming states, as `plimsoll run` does: every `log.every` "
           "seconds of the scene, forces if it asks for them. format: 'csv' or 'hdf5'. Ends an "
           "earlier log.")
      .def("close_log", &S::close_log,
           "Ends the log and writes summary.json, so that `plimsoll report` and the others take "
           "the folder. Leaving a `with` block and deleting the simulation do it, too.")
      .def("render", &S::render, py::arg("camera") = none, py::arg("size") = none,
           py::arg("overlay") = true,
           "Draws the present state, without a display: an array (height, width, 3) of bytes, "
           "red, green, blue.\n\ncamera: the name of one of the scene's, or a dict as in a "
           "scene, {'from': [6, -8, 3], 'to': [0, 0, 0]}; by default the scene's first. size: "
           "width and height [px]. overlay: False leaves out text, scales and legends. Automatic "
           "scales enclose the states drawn so far. Raises RenderError without graphics.")
      .def("__enter__", [](const py::object& self) { return self; })
      .def("__exit__", [](S& s, const py::args&) { s.close_log(); })
      .def("__repr__", &repr);
}

}  // namespace python
