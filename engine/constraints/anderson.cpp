#include "engine/constraints/anderson.h"

#include <Eigen/QR>

namespace engine {

Eigen::VectorXd Anderson::next(const Eigen::VectorXd& x, const Eigen::VectorXd& image) {
  const Eigen::VectorXd residual = image - x;
  if (last_image_.size() > 0) {
    residual_changes_.push_back(residual - last_residual_);
    image_changes_.push_back(image - last_image_);
    if (residual_changes_.size() > depth_) {
      residual_changes_.pop_front();
      image_changes_.pop_front();
    }
  }
  last_residual_ = residual;
  last_image_ = image;
  const auto count = static_cast<Eigen::Index>(residual_changes_.size());
  if (count == 0) return image;
  Eigen::MatrixXd changes(x.size(), count);
  for (Eigen::Index i = 0; i < count; ++i) changes.col(i) = residual_changes_[i];
  // The rank-revealing solution is the least one where changes repeat each other.
  const Eigen::VectorXd weights =
      Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(changes).solve(residual);
  Eigen::VectorXd next = image;
  for (Eigen::Index i = 0; i < count; ++i) next -= weights[i] * image_changes_[i];
  return next;
}

}  // namespace engine
