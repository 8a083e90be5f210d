#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "app/held/held_simulation.h"

/// @file
/// The readings of a simulation at a time as dicts of Python.

namespace python {

/// Returns the tables of lines, joints, machines and controls, and the probes, each a dict of rows
/// by name: readings["lines"]["ropes[tow]"]["tension"].
pybind11::dict readings_of(const app::HeldSimulation& simulation);

/// Returns the loads and numbers of a row of forces.csv (app/logs/force_log.h) by name.
pybind11::dict forces_of(const std::vector<double>& row);

}  // namespace python
