#include "hydro/bem/dense.h"

#include <algorithm>
#include <numbers>

#include "hydro/bem/galerkin.h"
#include "hydro/bem/near_pairs.h"
#include "hydro/bem/pair.h"
#include "hydro/parallel.h"

namespace hydro::bem {
namespace {

using Eigen::Index;

constexpr double kPerSphere = 1 / (4 * std::numbers::pi);

/// Elements in groups none of which has two at one vertex: the rows of one group's equations can
/// be added to at the same time, and group by group all are in one order.
std::vector<std::vector<std::size_t>> apart(const Surface& surface) {
  std::vector<std::vector<std::size_t>> groups;
  std::vector<std::vector<bool>> taken(static_cast<std::size_t>(surface.vertex_count()));
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    std::size_t group = 0;
    const auto is_taken = [&](std::size_t corner) {
      const auto& at = taken[static_cast<std::size_t>(surface.vertex(f, corner))];
      return group < at.size() && at[group];
    };
    while (is_taken(0) || is_taken(1) || is_taken(2)) ++group;
    if (group >= groups.size()) groups.resize(group + 1);
    groups[group].push_back(f);
    for (std::size_t i = 0; i < 3; ++i) {
      auto& at = taken[static_cast<std::size_t>(surface.vertex(f, i))];
      if (group >= at.size()) at.resize(group + 1);
      at[group] = true;
    }
  }
  return groups;
}

/// matrix + matrixᵀ, by squares that fit into a processor's memory.
void add_transpose(Eigen::MatrixXd& matrix) {
  constexpr Index kSide = 64;
  const Index count = matrix.rows();
  parallel_for(static_cast<std::size_t>((count + kSide - 1) / kSide), [&](std::size_t strip) {
    const Index j = kSide * static_cast<Index>(strip), columns = std::min(kSide, count - j);
    for (Index i = 0; i <= j; i += kSide) {
      const Index rows = std::min(kSide, count - i);
      const Eigen::MatrixXd sum =
          matrix.block(i, j, rows, columns) + matrix.block(j, i, columns, rows).transpose();
      matrix.block(i, j, rows, columns) = sum;
      matrix.block(j, i, columns, rows) = sum.transpose();
    }
  });
}

class Assembly {
 public:
  explicit Assembly(const Surface& surface)
      : surface_(surface), batches_(batches_of(surface.elements)), near_(surface) {
    for (std::size_t f = 0; f < surface.face_count(); ++f)
      functions_.push_back(functions_of(surface, f));
    const Index count = function_count(surface);
    result_.matrix = Eigen::MatrixXd::Zero(count, count);
    result_.swirl.resize(surface.face_count());
  }

  DenseEquations run() {
    for (const std::vector<std::size_t>& group : apart(surface_))
      parallel_for(group.size(), [&](std::size_t i) { add_rows(group[i]); });
    add_transpose(result_.matrix);
    return std::move(result_);
  }

 private:
  void add_rows(std::size_t a) {
    LanePairs pairs;
    LaneCouplings couplings;
    LaneSwirls swirls = {};
    const Element& element = surface_.elements[a];
    auto near = near_.of(a).begin();
    for (std::size_t batch = 0; batch < batches_.size(); ++batch) {
      pairs_by_points(element, batches_[batch], pairs);
      for (; near != near_.of(a).end() && near->element / kLanes == batch; ++near)
        set_lane(near->integrals, near->element % kLanes, pairs);
      add_swirls(batches_[batch], pairs, swirls);
      if (kLanes * (batch + 1) <= a) continue;
      couple(element, batches_[batch], pairs, couplings);
      scatter(a, kLanes * batch, couplings);
    }
    result_.swirl[a] = summed(swirls);
  }

  /// Adds the pairs of an element and those behind it to columns of the matrix, which lie together
  /// in memory; those before it follow by symmetry.
  void scatter(std::size_t a, std::size_t first, const LaneCouplings& couplings) {
    const std::size_t begin = std::max(first, a);
    const std::size_t end = std::min(first + kLanes, surface_.face_count());
    for (std::size_t k = 0; k < 6; ++k) {
      double* column = result_.matrix.col(functions_[a][k]).data();
      for (std::size_t b = begin; b < end; ++b) {
        const double factor = b == a ? 0.5 * kPerSphere : kPerSphere;
        for (std::size_t l = 0; l < 6; ++l)
          column[functions_[b][l]] += factor * couplings.functions[k][l][b - first];
      }
    }
  }

  const Surface& surface_;
  std::vector<Batch> batches_;
  NearPairs near_;
  std::vector<std::array<int, 6>> functions_;
  DenseEquations result_;
};

/// Columns of the matrix taken at a time: one after another, each sum would wait for its last
/// addition.
constexpr Index kColumns = 8;

/// A row of six numbers and two zeros.
struct alignas(kAligned) Row {
  Lanes lanes = {};
};

/// results[c] = Σ_i columns[c·rows + i] vectors[i].
PLIMSOLL_VECTOR_CLONES
void multiply_columns(const double* columns, Index rows, const Row* vectors, Row* results) {
  const Lanes zero = {};
  Lanes sums[kColumns] = {zero, zero, zero, zero, zero, zero, zero, zero};
  for (Index i = 0; i < rows; ++i)
    for (Index c = 0; c < kColumns; ++c) sums[c] += columns[c * rows + i] * vectors[i].lanes;
  for (Index c = 0; c < kColumns; ++c) results[c].lanes = sums[c];
}

}  // namespace

DenseEquations dense_equations(const Surface& surface) { return Assembly(surface).run(); }

Potential product(const Eigen::MatrixXd& matrix, const Potential& vectors) {
  const Index count = matrix.rows(), blocks = count / kColumns;
  std::vector<Row> rows(static_cast<std::size_t>(count));
  for (Index i = 0; i < count; ++i)
    for (Index m = 0; m < 6; ++m) rows[static_cast<std::size_t>(i)].lanes[m] = vectors(i, m);
  Potential result(count, 6);
  parallel_for(static_cast<std::size_t>(blocks), [&](std::size_t block) {
    const Index first = kColumns * static_cast<Index>(block);
    Row sums[kColumns];
    multiply_columns(matrix.col(first).data(), count, rows.data(), sums);
    for (Index c = 0; c < kColumns; ++c)
      for (Index m = 0; m < 6; ++m) result(first + c, m) = sums[c].lanes[m];
  });
  for (Index i = kColumns * blocks; i < count; ++i)
    result.row(i).noalias() = matrix.col(i).transpose() * vectors;
  return result;
}

}  // namespace hydro::bem
