#include "hydro/radiation/linear_response.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "hydro/decompositions.h"

namespace hydro {
namespace {

/// Eigenvalues of (3) up to this part of the largest are round-off [-].
constexpr double kNoRestoring = 1e-9;

/// Halvings of an interval, of a factor of two at first, that leave round-off.
constexpr int kHalvings = 52;
/// Doublings within which the frequency of a mode is sought.
constexpr int kDoublings = 100;

/// The eigenvalues λ and vectors of C ξ = λ M ξ, ξᵀ M ξ = 1, by descending λ.
struct Modes {
  std::vector<double> squares;
  std::vector<Vector6d> shapes;
};

Modes modes_of(const Matrix6d& inertia, const Matrix6d& stiffness) {
  const Cholesky6 cholesky(inertia);
  if (!cholesky.positive_definite()) return {};
  Matrix6d relative = cholesky.relative(stiffness);
  relative = (0.5 * (relative + relative.transpose())).eval();
  const EigenDecomposition6 found = eigen_decomposition(relative);
  std::array<Eigen::Index, 6> order = {0, 1, 2, 3, 4, 5};
  std::ranges::sort(order, [&](auto a, auto b) { return found.values[a] > found.values[b]; });
  Modes modes;
  for (const Eigen::Index i : order) {
    modes.squares.push_back(found.values[i]);
    modes.shapes.push_back(cholesky.solve_upper(Vector6d(found.vectors.col(i))));
  }
  return modes;
}

/// The frequency at which a function that is positive below it and negative above vanishes; none
/// where there is no such change of sign.
template <class Function>
std::optional<double> zero_of(const Function& function, double guess) {
  double low = guess, high = guess;
  for (int i = 0; i < kDoublings && !(function(high) <= 0); ++i)
    low = std::exchange(high, 2 * high);
  for (int i = 0; i < kDoublings && !(function(low) >= 0); ++i) high = std::exchange(low, low / 2);
  if (!(function(low) >= 0 && function(high) <= 0)) return std::nullopt;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (function(middle) > 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

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

Matrix6d memory_mass(const Matrix6cd& memory, double frequency) {
  return memory.imag() / frequency;
}

std::vector<NaturalMode> natural_modes(const LinearBody& body,
                                       const std::function<Matrix6d(double)>& excess) {
  Matrix6d stiffness = 0.5 * (body.stiffness + body.stiffness.transpose());
  Matrix6d constant = body.inertia;
  // A locked motion is one by itself that has no restoring.
  const auto lock = [&](Matrix6d& matrix, double diagonal) {
    for (Eigen::Index i = 0; i < 6; ++i) {
      if (!body.locked[static_cast<std::size_t>(i)]) continue;
      matrix.row(i).setZero();
      matrix.col(i).setZero();
      matrix(i, i) = diagonal;
    }
  };
  lock(stiffness, 0);
  const auto at = [&](double frequency) {
    Matrix6d inertia = excess ? Matrix6d(constant + excess(frequency)) : constant;
    lock(inertia, 1);
    return modes_of(inertia, stiffness);
  };
  lock(constant, 1);
  const Modes guess = modes_of(constant, stiffness);
  std::vector<NaturalMode> modes;
  for (std::size_t k = 0; k < guess.squares.size(); ++k) {
    if (!(guess.squares[k] > kNoRestoring * guess.squares.front())) break;
    const auto surplus = [&](double frequency) {
      const Modes now = at(frequency);
      return now.squares.empty() ? std::nan("") : now.squares[k] - frequency * frequency;
    };
    const double first = std::sqrt(guess.squares[k]);
    const std::optional<double> frequency = excess ? zero_of(surplus, first) : first;
    if (!frequency) continue;
    const Vector6d shape = at(*frequency).shapes[k];
    modes.push_back({*frequency, shape / std::sqrt(0.5 * shape.dot(stiffness * shape))});
  }
  std::ranges::sort(modes, {}, &NaturalMode::frequency);
  return modes;
}

Matrix6d turn_of_heading(double heading) {
  Matrix6d turn = Matrix6d::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() =
      Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return turn;
}

}  // namespace hydro
