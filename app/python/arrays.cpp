#include "app/python/arrays.h"

#include <algorithm>
#include <stdexcept>

namespace python {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

void require(bool right, const std::string& what, const std::string& expected) {
  if (!right) throw std::invalid_argument(what + ": expected " + expected);
}

bool all_finite(const Array& array) {
  return Eigen::Map<const Eigen::VectorXd>(array.data(), array.size()).allFinite();
}

}  // namespace

py::array view(double* data, std::vector<py::ssize_t> shape, const py::object& owner,
               bool writeable) {
  // An array over no memory would be a copy, so one without entries gets a place of its own.
  static double nothing = 0;
  py::array_t<double> array(std::move(shape), data == nullptr ? &nothing : data, owner);
  if (!writeable) array.attr("flags").attr("writeable") = false;
  return array;
}

py::array to_array(const Eigen::Vector3d& vector) { return py::array_t<double>(3, vector.data()); }

py::array to_array(const hydro::Vector6d& vector) { return py::array_t<double>(6, vector.data()); }

py::array to_array(const std::vector<double>& numbers) {
  return py::array_t<double>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

py::array to_array(const Eigen::MatrixXd& matrix) {
  py::array_t<double> array({matrix.rows(), matrix.cols()});
  Eigen::Map<RowMajor>(array.mutable_data(), matrix.rows(), matrix.cols()) = matrix;
  return array;
}

Eigen::Vector3d to_vector(const Array& array, const std::string& what) {
  require(array.ndim() == 1 && array.size() == 3 && all_finite(array), what,
          "three finite numbers");
  return Eigen::Map<const Eigen::Vector3d>(array.data());
}

Eigen::Quaterniond to_rotation(const Array& array, const std::string& what) {
  require(array.ndim() == 1 && array.size() == 4 && all_finite(array), what,
          "the four numbers w, x, y, z of a quaternion");
  const Eigen::Quaterniond q(array.at(0), array.at(1), array.at(2), array.at(3));
  require(q.norm() > 1e-3 && std::isfinite(q.norm()), what, "a quaternion that is not zero");
  return q.normalized();
}

hydro::BodyState moved(hydro::BodyState state, const py::object& position,
                       const py::object& orientation, const py::object& velocity,
                       const py::object& angular_velocity) {
  const auto put = [](const py::object& given, const char* what, Eigen::Vector3d& vector) {
    if (!given.is_none()) vector = to_vector(given.cast<Array>(), what);
  };
  put(position, "position", state.position);
  if (!orientation.is_none())
    state.orientation = to_rotation(orientation.cast<Array>(), "orientation");
  put(velocity, "velocity", state.linear_velocity);
  put(angular_velocity, "angular_velocity", state.angular_velocity);
  return state;
}

}  // namespace python
