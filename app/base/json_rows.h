#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace app {

/// A matrix as a JSON list of its rows.
template <class Matrix>
nlohmann::ordered_json json_rows(const Eigen::MatrixBase<Matrix>& matrix) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    rows.push_back(nlohmann::ordered_json::array());
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) rows.back().push_back(matrix(i, j));
  }
  return rows;
}

}  // namespace app
