#include "hydro/radiation/linear_response.h"

#include <cassert>
#include <vector>

#include "hydro/decompositions.h"

namespace hydro {

Vector6cd linear_response(const LinearBody& body, const Matrix6cd& memory, double frequency,
                          const Vector6cd& load) {
  assert(frequency > 0);
  const std::complex<double> rate(0, -frequency);  // s = −iω
  const Matrix6cd dynamic = (rate * rate * body.inertia.cast<std::complex<double>>() +
                             rate * (body.damping + memory.conjugate()) + body.stiffness)
                                .eval();
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < 6; ++i)
    if (!body.locked[static_cast<std::size_t>(i)]) free.push_back(i);
  const auto n = static_cast<Eigen::Index>(free.size());
  // The real and the imaginary part of the equations one below the other.
  Eigen::MatrixXd matrix(2 * n, 2 * n), side(2 * n, 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto row = free[static_cast<std::size_t>(i)];
    side(i, 0) = load[row].real();
    side(n + i, 0) = load[row].imag();
    for (Eigen::Index j = 0; j < n; ++j) {
      const std::complex<double> entry = dynamic(row, free[static_cast<std::size_t>(j)]);
      matrix(i, j) = matrix(n + i, n + j) = entry.real();
      matrix(i, n + j) = -entry.imag();
      matrix(n + i, j) = entry.imag();
    }
  }
  Vector6cd motion = Vector6cd::Zero();
  if (n == 0) return motion;
  const Eigen::MatrixXd found = solve_dense(matrix, side);
  for (Eigen::Index i = 0; i < n; ++i)
    motion[free[static_cast<std::size_t>(i)]] = {found(i, 0), found(n + i, 0)};
  return motion;
}

Matrix6d turn_of_heading(double heading) {
  Matrix6d turn = Matrix6d::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() =
      Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return turn;
}

}  // namespace hydro
