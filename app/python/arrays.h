#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "hydro/spatial.h"

/// @file
/// Numbers between Eigen and NumPy. Arrays are of double precision, and C-contiguous.

namespace python {

namespace py = pybind11;

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Returns an array over memory that `owner` keeps alive.
py::array view(double* data, std::vector<py::ssize_t> shape, const py::object& owner,
               bool writeable);

/// Returns a new array.
py::array to_array(const Eigen::Vector3d& vector);
py::array to_array(const hydro::Vector6d& vector);
py::array to_array(const std::vector<double>& numbers);
/// Row by row.
py::array to_array(const Eigen::MatrixXd& matrix);

/// Returns three numbers. @throws std::invalid_argument, naming `what`, unless they are three
/// finite ones
Eigen::Vector3d to_vector(const Array& array, const std::string& what);
/// Returns the rotation of a quaternion w, x, y, z, which is normalised.
Eigen::Quaterniond to_rotation(const Array& array, const std::string& what);

/// Returns a state of motion with other values where they are not None.
hydro::BodyState moved(hydro::BodyState state, const py::object& position,
                       const py::object& orientation, const py::object& velocity,
                       const py::object& angular_velocity);

}  // namespace python
