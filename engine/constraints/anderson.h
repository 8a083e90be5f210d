#pragma once

#include <Eigen/Core>
#include <deque>

namespace engine {

/// Anderson's acceleration of a fixed-point iteration x ← g(x) [WN11]: the next x is the
/// combination of the last few images g(x_i) whose residuals g(x_i) − x_i combine to the least. On
/// an affine map it ends after as many steps as the map has dimensions, whether or not the plain
/// iteration converges.
///
/// [WN11] Walker, Ni. Anderson acceleration for fixed-point iterations. SIAM J. Numer. Anal. 49
///        (2011) 1715-1735.
class Anderson {
 public:
  /// @param depth   Number of earlier steps that are kept.
  explicit Anderson(std::size_t depth) : depth_(depth) {}

  /// The next x after g(x) was found to be `image`.
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& image);

 private:
  std::size_t depth_;
  std::deque<Eigen::VectorXd> residual_changes_;
  std::deque<Eigen::VectorXd> image_changes_;
  Eigen::VectorXd last_residual_;
  Eigen::VectorXd last_image_;
};

}  // namespace engine
