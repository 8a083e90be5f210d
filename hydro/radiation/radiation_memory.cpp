#include "hydro/radiation/radiation_memory.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hydro/radiation/long_waves.h"
#include "hydro/radiation/oscillator_fit.h"

namespace hydro {
namespace {

// Motions whose loads are below this part of the strongest one's make no waves [-]: the loads on a
// smooth body of revolution about its axis are those of its facets.
constexpr double kNoWaves = 1e-5;
// Motions act on each other where their coupling is above this part of the geometric mean of their
// own loads [-]. Couplings below it are as small as the error of a solution on patches.
constexpr double kCoupled = 1e-2;

void check_radiation(const RadiationData& data) {
  const std::size_t count = data.frequencies.size();
  if (count == 0) throw std::invalid_argument("radiation data without frequencies");
  if (data.added_mass.size() != count || data.damping.size() != count)
    throw std::invalid_argument("radiation data whose frequencies lack added mass or damping");
  bool sound = data.infinite_added_mass.allFinite();
  double last = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!(data.frequencies[i] > last))
      throw std::invalid_argument("radiation data whose frequencies do not ascend from above 0");
    last = data.frequencies[i];
    sound = sound && data.added_mass[i].allFinite() && data.damping[i].allFinite();
  }
  if (!sound || !std::isfinite(last))
    throw std::invalid_argument("radiation data with numbers that are not finite");
}

/// H of (1) for each frequency.
std::vector<Matrix6cd> responses(const RadiationData& data) {
  std::vector<Matrix6cd> result;
  for (std::size_t k = 0; k < data.frequencies.size(); ++k) {
    const Matrix6d A = data.added_mass[k] - data.infinite_added_mass;
    const Matrix6d& B = data.damping[k];
    Matrix6cd H;
    H.real() = (B + B.transpose()) / 2;
    H.imag() = data.frequencies[k] * (A + A.transpose()) / 2;
    result.push_back(H);
  }
  return result;
}

Matrix6d largest_entries(const std::vector<Matrix6cd>& H) {
  Matrix6d largest = Matrix6d::Zero();
  for (const Matrix6cd& at : H) largest = largest.cwiseMax(at.cwiseAbs());
  return largest;
}

/// A length that turns rotations into translations of the body's size [m].
double body_length(const RadiationData& data, const Matrix6d& largest) {
  if (data.volume > 0) return std::cbrt(data.volume);
  const double translation = largest.diagonal().head<3>().maxCoeff();
  const double rotation = largest.diagonal().tail<3>().maxCoeff();
  return translation > 0 && rotation > 0 ? std::sqrt(rotation / translation) : 1;
}

/// Motions that make waves, in sets of which no motion acts on one of another set.
std::vector<std::vector<int>> independent_motions(const Matrix6d& largest, double length) {
  Vector6d scale;
  scale << Eigen::Vector3d::Ones(), Eigen::Vector3d::Constant(1 / length);
  const Vector6d own = scale.cwiseAbs2().cwiseProduct(largest.diagonal());
  std::array<int, 6> set = {0, 1, 2, 3, 4, 5};
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < i; ++j)
      if (largest(i, j) > kCoupled * std::sqrt(largest(i, i) * largest(j, j)))
        std::replace(set.begin(), set.end(), std::max(set[i], set[j]), std::min(set[i], set[j]));
  std::vector<std::vector<int>> sets;
  for (int first = 0; first < 6; ++first) {
    std::vector<int> motions;
    for (int i = 0; i < 6; ++i)
      if (set[i] == first && own[i] > kNoWaves * own.maxCoeff()) motions.push_back(i);
    if (!motions.empty()) sets.push_back(motions);
  }
  return sets;
}

/// Adds oscillators that drive these motions alone.
void append_block(const Oscillators& block, const std::vector<int>& motions,
                  RadiationMemory& memory) {
  const Eigen::Index before = memory.size(), more = block.frequencies.size();
  memory.frequencies.conservativeResize(before + more);
  memory.frequencies.tail(more) = block.frequencies;
  memory.damping.conservativeResize(before + more);
  memory.damping.tail(more) = block.damping;
  memory.port.conservativeResizeLike(Eigen::MatrixXd::Zero(before + more, 6));
  for (std::size_t i = 0; i < motions.size(); ++i)
    memory.port.col(motions[i]).tail(more) = block.port.col(static_cast<Eigen::Index>(i));
}

void set_errors(const std::vector<double>& frequencies, const std::vector<Matrix6cd>& H,
                RadiationMemory& memory) {
  const Matrix6d largest = largest_entries(H);
  const Vector6d root = largest.diagonal().cwiseSqrt();
  Matrix6d squares = Matrix6d::Zero(), worst = squares;
  for (std::size_t k = 0; k < H.size(); ++k) {
    const Matrix6d off = (response(memory, frequencies[k]) - H[k]).cwiseAbs();
    squares += off.cwiseAbs2();
    worst = worst.cwiseMax(off);
  }
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      const double scale = root[i] * root[j];
      if (!(scale > 0) || memory.port.col(i).isZero(0) || memory.port.col(j).isZero(0)) continue;
      memory.rms_error(i, j) = std::sqrt(squares(i, j) / static_cast<double>(H.size())) / scale;
      memory.largest_error(i, j) = worst(i, j) / scale;
    }
}

}  // namespace

Matrix6cd response(const RadiationMemory& memory, double frequency) {
  if (memory.size() == 0) return Matrix6cd::Zero();
  const Oscillators all{
      .frequencies = memory.frequencies, .damping = memory.damping, .port = memory.port};
  return response(all, frequency);
}

RadiationMemory fit_memory(const RadiationData& data) {
  check_radiation(data);
  const RadiationData longer = with_long_waves(data);
  const std::vector<Matrix6cd> H = responses(data), to_fit = responses(longer);
  const Matrix6d largest = largest_entries(H);
  RadiationMemory memory;
  for (const std::vector<int>& motions : independent_motions(largest, body_length(data, largest))) {
    std::vector<Eigen::MatrixXcd> block;
    for (const Matrix6cd& at : to_fit) block.push_back(at(motions, motions));
    append_block(fit_oscillators(longer.frequencies, block), motions, memory);
  }
  set_errors(data.frequencies, H, memory);
  return memory;
}

}  // namespace hydro
