#include <pybind11/stl.h>

#include "app/base/output_error.h"
#include "app/held/observer.h"
#include "app/python/bindings.h"
#include "app/render/image.h"
#include "app/scene/diagnostics.h"

namespace python {
namespace {

/// A new exception of the module, which lives as long as the program.
PyObject* new_exception(py::module_& module, const char* name, const char* text,
                        const py::handle& base) {
  const std::string full = std::string("plimsoll.") + name;
  PyObject* exception = PyErr_NewExceptionWithDoc(full.c_str(), text, base.ptr(), nullptr);
  if (exception == nullptr) throw py::error_already_set();
  module.add_object(name, exception);
  return exception;
}

PyObject* scene_error = nullptr;
PyObject* simulation_error = nullptr;
PyObject* render_error = nullptr;

void raise_scene_error(const scene::InputError& error) {
  py::object instance = py::reinterpret_borrow<py::object>(scene_error)(error.what());
  instance.attr("faults") = py::cast(error.faults());
  PyErr_SetObject(scene_error, instance.ptr());
}

void raise_simulation_error(const engine::SimulationError& error) {
  py::object instance = py::reinterpret_borrow<py::object>(simulation_error)(error.what());
  instance.attr("time") = error.time();
  instance.attr("body") = error.body();
  PyErr_SetObject(simulation_error, instance.ptr());
}

void translate(std::exception_ptr pointer) {
  try {
    if (pointer) std::rethrow_exception(pointer);
  } catch (const scene::InputError& error) {
    raise_scene_error(error);
  } catch (const engine::SimulationError& error) {
    raise_simulation_error(error);
  } catch (const app::UnknownName& error) {
    PyErr_SetString(PyExc_KeyError, error.what());
  } catch (const py::cast_error& error) {
    // By itself pybind11 makes a RuntimeError of an argument of another type.
    PyErr_SetString(PyExc_TypeError, error.what());
  } catch (const render::Error& error) {
    PyErr_SetString(render_error, error.what());
  } catch (const app::OutputError& error) {
    PyErr_SetString(PyExc_OSError, error.what());
  }
}

/// A file's name may be no text, and so stands as bytes.
py::tuple saved_fault(const scene::Fault& fault) {
  return py::make_tuple(py::bytes(fault.place.file.string()), fault.place.line, fault.place.column,
                        fault.key_path, fault.message);
}

scene::Fault restored_fault(const py::tuple& saved) {
  if (saved.size() != 5) throw py::value_error("these are not the values of a fault");
  return {.place = {.file = saved[0].cast<std::string>(),
                    .line = saved[1].cast<int>(),
                    .column = saved[2].cast<int>()},
          .key_path = saved[3].cast<std::string>(),
          .message = saved[4].cast<std::string>()};
}

}  // namespace

void bind_errors(py::module_& module) {
  py::class_<scene::Fault>(module, "Fault", "A single fault of a scene or another input.")
      .def_property_readonly(
          "file", [](const scene::Fault& fault) { return fault.place.file.string(); },
          "File of the fault.")
      .def_property_readonly(
          "line", [](const scene::Fault& fault) { return fault.place.line; },
          "Counted from 1; 0 if there is none.")
      .def_property_readonly(
          "column", [](const scene::Fault& fault) { return fault.place.column; },
          "Counted from 1; 0 if there is none.")
      .def_readonly("path", &scene::Fault::key_path, "Path of the key: `bodies[1].mass`.")
      .def_readonly("text", &scene::Fault::message,
                    "Text that says what was found and what was expected.")
      .def(py::pickle(&saved_fault, &restored_fault))
      .def("__str__", [](const scene::Fault& fault) { return scene::to_string(fault); })
      .def("__repr__",
           [](const scene::Fault& fault) { return "<Fault " + scene::to_string(fault) + ">"; });
  scene_error = new_exception(
      module, "SceneError",
      "A scene or another input is wrong. `faults` is the list of everything that is.",
      py::handle(PyExc_ValueError));
  simulation_error =
      new_exception(module, "SimulationError",
                    "A simulation cannot go on, at `time` [s], because of `body` (empty: no single "
                    "one).",
                    py::handle(PyExc_RuntimeError));
  render_error = new_exception(module, "RenderError", "There is no graphics to draw with.",
                               py::handle(PyExc_RuntimeError));
  py::register_exception_translator(translate);
}

}  // namespace python
