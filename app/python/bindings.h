#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/python/scene_source.h"
#include "app/python/unlocked.h"
#include "app/scene/diagnostics.h"
#include "engine/simulation.h"
#include "hydro/mesh/mesh.h"

/// @file
/// The parts of the Python module; plimsoll/_core.pyi tells their signatures. Everything that
/// computes releases Python's lock (the GIL) meanwhile.

namespace python {

namespace py = pybind11;

/// Refuses an object whose __init__ has not been called, as `Simulation.__new__(Simulation)`, by a
/// TypeError. By itself pybind11 gives it memory in which nothing has been made.
template <class T>
struct MadeCaster : py::detail::type_caster_base<T> {
  bool load(py::handle source, bool convert) {
    if (py::isinstance<T>(source)) {
      auto* const instance = reinterpret_cast<py::detail::instance*>(source.ptr());
      if (instance->owned && !instance->get_value_and_holder().holder_constructed()) return false;
    }
    return py::detail::type_caster_base<T>::load(source, convert);
  }
};

}  // namespace python

namespace pybind11::detail {

template <>
struct type_caster<scene::Fault> : python::MadeCaster<scene::Fault> {};
template <>
struct type_caster<python::SceneSource> : python::MadeCaster<python::SceneSource> {};
template <>
struct type_caster<hydro::TriMesh> : python::MadeCaster<hydro::TriMesh> {};

}  // namespace pybind11::detail

namespace python {

void bind_errors(py::module_& module);
void bind_scene(py::module_& module);
void bind_simulation(py::module_& module);
void bind_batch(py::module_& module);
void bind_hydro(py::module_& module);

/// Returns the scene of an object of Python: a Scene, a path, or a dict.
/// @param overrides   A dict from key paths to values, or None.
/// @param any_format   True: meshes of any format are read, and not only those of the common ones.
std::shared_ptr<SceneSource> scene_from(const py::object& source, const py::object& overrides,
                                        bool any_format = false);

/// Returns the formats that the argument `any_format` of a function stands for.
scene::MeshFormats formats_from(bool any_format);

/// Returns values of Python as overrides.
std::vector<scene::Override> overrides_from(const py::object& values);

/// Returns the index of a body, which is named by its index or its name.
/// @throws py::key_error, py::index_error
engine::BodyId body_index(const engine::SimulationSpec& spec, const py::object& body);

/// Returns the index of a set point by its name, or by the name of its machine, joint or rope
/// alone where that has a single one. @throws py::key_error
engine::SetPointId set_point_index(const engine::SimulationSpec& spec, const std::string& name);

/// Returns the mutex locked, waiting without the GIL for whoever has it. It is called with the GIL.
std::unique_lock<std::mutex> locked(std::mutex& mutex);

/// Lets Python handle signals, so that Ctrl-C ends a long computation. To be called without the
/// GIL; at most twenty times a second it takes it.
/// @throws py::error_already_set, and std::runtime_error in a thread that Python's end has
/// overtaken
class SignalCheck {
 public:
  void operator()();

 private:
  double last_ = 0;  ///< [s]
};

}  // namespace python
