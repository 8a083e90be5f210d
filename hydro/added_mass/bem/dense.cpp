#include "hydro/added_mass/bem/dense.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "hydro/added_mass/bem/galerkin.h"
#include "hydro/added_mass/bem/near_pairs.h"
#include "hydro/added_mass/bem/pair.h"
#include "hydro/parallel.h"

namespace hydro::bem {
namespace {

using Eigen::Index;

/// Returns the elements in groups without common vertices: threads can add to the rows of one group
/// at the same time, and the groups fix the order of summation.
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

/// Adds the upper triangle to the lower one, in blocks that fit into a processor's cache. The
/// diagonal is doubled.
void fold(Eigen::MatrixXd& matrix) {
  constexpr Index kSide = 64;
  const Index count = matrix.rows();
  parallel_for(static_cast<std::size_t>((count + kSide - 1) / kSide), [&](std::size_t strip) {
    const Index j = kSide * static_cast<Index>(strip), columns = std::min(kSide, count - j);
    for (Index i = j; i < count; i += kSide) {
      const Index rows = std::min(kSide, count - i);
      matrix.block(i, j, rows, columns) += matrix.block(j, i, columns, rows).transpose().eval();
    }
  });
}

/// A matrix of zeros, written by all threads because memory pages are mapped at the first write.
Eigen::MatrixXd zeros(Index count) {
  Eigen::MatrixXd matrix(count, count);
  parallel_for(static_cast<std::size_t>(count),
               [&](std::size_t j) { matrix.col(static_cast<Index>(j)).setZero(); });
  return matrix;
}

class Assembly {
 public:
  explicit Assembly(const Surface& surface)
      : surface_(surface), batches_(batches_of(surface.elements)), near_(surface) {
    for (std::size_t f = 0; f < surface.face_count(); ++f)
      functions_.push_back(functions_of(surface, f));
    result_.matrix = zeros(function_count(surface));
    result_.swirl.resize(surface.face_count());
  }

  DenseEquations run() {
    for (const std::vector<std::size_t>& group : apart(surface_))
      parallel_for(group.size(), [&](std::size_t i) { add_rows(group[i]); });
    fold(result_.matrix);
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

  /// Adds the pairs of an element with itself and later ones to columns of the matrix, which are
  /// contiguous in memory; pairs with earlier elements follow by symmetry.
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

/// Number of columns of the matrix processed at a time: with one, each addition would wait for the
/// previous one.
constexpr Index kColumns = 8;

/// A row of six numbers and two zeros.
struct alignas(kAligned) Row {
  Lanes lanes = {};
};
using Rows = std::vector<Row>;

Row& at(Rows& rows, Index i) { return rows[static_cast<std::size_t>(i)]; }
const Row& at(const Rows& rows, Index i) { return rows[static_cast<std::size_t>(i)]; }

Rows rows_of(const SixColumns& vectors) {
  Rows rows(static_cast<std::size_t>(vectors.rows()));
  for (Index m = 0; m < 6; ++m)
    for (Index i = 0; i < vectors.rows(); ++i) at(rows, i).lanes[m] = vectors(i, m);
  return rows;
}

SixColumns columns_of(const Rows& rows) {
  SixColumns vectors(static_cast<Index>(rows.size()), 6);
  for (Index m = 0; m < 6; ++m)
    for (Index i = 0; i < vectors.rows(); ++i) vectors(i, m) = at(rows, i).lanes[m];
  return vectors;
}

/// sums[c] = Σ_i columns[c·stride + i] x[i] for kColumns columns.
PLIMSOLL_VECTOR_CLONES
void dot_columns(const double* columns, Index stride, Index rows, const Row* x, Row* sums) {
  const Lanes zero = {};
  Lanes sum[kColumns] = {zero, zero, zero, zero, zero, zero, zero, zero};
  for (Index i = 0; i < rows; ++i)
    for (Index c = 0; c < kColumns; ++c) sum[c] += columns[c * stride + i] * x[i].lanes;
  for (Index c = 0; c < kColumns; ++c) sums[c].lanes = sum[c];
}

/// y[i] += Σ_c columns[c·stride + i] factors[c] for kColumns columns.
PLIMSOLL_VECTOR_CLONES
void add_columns(const double* columns, Index stride, Index rows, const Row* factors, Row* y) {
  for (Index i = 0; i < rows; ++i) {
    Lanes sum = y[i].lanes;
    for (Index c = 0; c < kColumns; ++c) sum += columns[c * stride + i] * factors[c].lanes;
    y[i].lanes = sum;
  }
}

/// Does the work of dot_columns and add_columns with one read of each number of the matrix.
PLIMSOLL_VECTOR_CLONES
void dot_and_add_columns(const double* columns, Index stride, Index rows, const Row* x, Row* y,
                         const Row* factors, Row* sums) {
  const Lanes zero = {};
  Lanes sum[kColumns] = {zero, zero, zero, zero, zero, zero, zero, zero};
  for (Index i = 0; i < rows; ++i) {
    const Lanes here = x[i].lanes;
    Lanes other = y[i].lanes;
    for (Index c = 0; c < kColumns; ++c) {
      const double entry = columns[c * stride + i];
      sum[c] += entry * here;
      other += entry * factors[c].lanes;
    }
    y[i].lanes = other;
  }
  for (Index c = 0; c < kColumns; ++c) sums[c].lanes = sum[c];
}

using Block = Eigen::Block<const Eigen::MatrixXd>;

const double* place(const Block& block, Index row, Index column) {
  return block.data() + column * block.outerStride() + row;
}

Index blocks_of(Index columns) { return (columns + kColumns - 1) / kColumns; }

/// y += A x for kColumns columns of a symmetric matrix A from its diagonal down, and for their
/// mirror rows. The last block may have fewer columns; no rows are below it.
void add_symmetric(const Block& lower, Index first, const Rows& x, Rows& y) {
  const Index width = std::min(kColumns, lower.rows() - first), below = first + kColumns;
  Row sums[kColumns];
  if (below < lower.rows())
    dot_and_add_columns(place(lower, below, first), lower.outerStride(), lower.rows() - below,
                        &at(x, below), &at(y, below), &at(x, first), sums);
  for (Index c = 0; c < width; ++c) {
    Lanes sum = sums[c].lanes + lower(first + c, first + c) * at(x, first + c).lanes;
    for (Index i = c + 1; i < width; ++i) {
      sum += lower(first + i, first + c) * at(x, first + i).lanes;
      at(y, first + i).lanes += lower(first + i, first + c) * at(x, first + c).lanes;
    }
    at(y, first + c).lanes += sum;
  }
}

/// y += kColumns columns of a block times x; the last block may have fewer columns.
void add_product(const Block& block, Index first, const Rows& x, Rows& y) {
  if (first + kColumns <= block.cols()) {
    add_columns(place(block, 0, first), block.outerStride(), block.rows(), &at(x, first), y.data());
    return;
  }
  for (Index c = first; c < block.cols(); ++c)
    for (Index i = 0; i < block.rows(); ++i) at(y, i).lanes += block(i, c) * at(x, c).lanes;
}

/// Number of partial sums. It is fixed, so that the result is the same for any number of threads.
constexpr std::size_t kChunks = 16;

/// Σ f(block, sum) over blocks of columns, with a partial sum for each chunk.
template <class Function>
Rows summed_by_chunks(Index rows, Index blocks, Function f) {
  std::vector<Rows> parts(kChunks);
  parallel_for(kChunks, [&](std::size_t chunk) {
    parts[chunk].resize(static_cast<std::size_t>(rows));
    // Blocks are dealt in turn, because columns get shorter.
    for (auto block = static_cast<Index>(chunk); block < blocks;
         block += static_cast<Index>(kChunks))
      f(block, parts[chunk]);
  });
  constexpr Index kStrip = 256;
  parallel_for(static_cast<std::size_t>((rows + kStrip - 1) / kStrip), [&](std::size_t strip) {
    const Index first = kStrip * static_cast<Index>(strip), last = std::min(first + kStrip, rows);
    for (std::size_t chunk = 1; chunk < kChunks; ++chunk)
      for (Index i = first; i < last; ++i) at(parts[0], i).lanes += at(parts[chunk], i).lanes;
  });
  return parts[0];
}

/// blockᵀ x.
Rows transposed_product(const Block& block, const Rows& x) {
  Rows result(static_cast<std::size_t>(block.cols()));
  parallel_for(static_cast<std::size_t>(blocks_of(block.cols())), [&](std::size_t i) {
    const Index first = kColumns * static_cast<Index>(i);
    if (first + kColumns <= block.cols()) {
      dot_columns(place(block, 0, first), block.outerStride(), block.rows(), x.data(),
                  &at(result, first));
      return;
    }
    for (Index c = first; c < block.cols(); ++c)
      for (Index k = 0; k < block.rows(); ++k) at(result, c).lanes += block(k, c) * at(x, k).lanes;
  });
  return result;
}

/// x = L⁻ᵀ L⁻¹ x.
void solve_triangles(const Block& L, Rows& x) {
  const Index count = L.rows();
  Row sums[kColumns];
  for (Index first = 0; first < count; first += kColumns) {
    const Index below = std::min(first + kColumns, count);
    for (Index c = first; c < below; ++c) {
      at(x, c).lanes /= L(c, c);
      for (Index i = c + 1; i < below; ++i) at(x, i).lanes -= L(i, c) * at(x, c).lanes;
      sums[c - first].lanes = -at(x, c).lanes;
    }
    if (below < count)
      add_columns(place(L, below, first), L.outerStride(), count - below, sums, &at(x, below));
  }
  for (Index first = kColumns * (blocks_of(count) - 1); first >= 0; first -= kColumns) {
    const Index below = std::min(first + kColumns, count);
    if (below < count) {
      dot_columns(place(L, below, first), L.outerStride(), count - below, &at(x, below), sums);
      for (Index c = first; c < below; ++c) at(x, c).lanes -= sums[c - first].lanes;
    }
    for (Index c = below - 1; c >= first; --c) {
      for (Index i = c + 1; i < below; ++i) at(x, c).lanes -= L(i, c) * at(x, i).lanes;
      at(x, c).lanes /= L(c, c);
    }
  }
}

/// Overwrites the lower triangle of the first `count` rows and columns by its Cholesky factor.
/// @return false if the matrix is not positive definite.
bool factorize(Eigen::MatrixXd& matrix, Index count) {
  constexpr Index kSide = 96;
  for (Index k = 0; k < count; k += kSide) {
    const Index width = std::min(kSide, count - k), below = k + width;
    auto corner = matrix.block(k, k, width, width);
    const Eigen::LLT<Eigen::MatrixXd> factor(corner);
    if (factor.info() != Eigen::Success) return false;
    corner.triangularView<Eigen::Lower>() = factor.matrixLLT();
    const auto strips = static_cast<std::size_t>((count - below + kSide - 1) / kSide);
    const auto strip = [&](std::size_t i, Index column, Index columns) {
      const Index first = below + kSide * static_cast<Index>(i);
      return matrix.block(first, column, std::min(kSide, count - first), columns);
    };
    parallel_for(strips, [&](std::size_t i) {
      auto panel = strip(i, k, width);
      factor.matrixU().solveInPlace<Eigen::OnTheRight>(panel);
    });
    parallel_for(strips * strips, [&](std::size_t pair) {
      const std::size_t i = pair / strips, j = pair % strips;
      if (j > i) return;
      const auto other = strip(j, k, width);
      strip(i, below + kSide * static_cast<Index>(j), other.rows()).noalias() -=
          strip(i, k, width) * other.transpose();
    });
  }
  return true;
}

}  // namespace

DenseEquations dense_equations(const Surface& surface) { return Assembly(surface).run(); }

Eliminated::Eliminated(Eigen::MatrixXd lower_triangle, Index count)
    : matrix_(std::move(lower_triangle)), count_(count) {
  if (!factorize(matrix_, count))
    throw std::invalid_argument("the panels are too thin to solve for the added mass");
}

double Eliminated::remaining(Index i, Index j) const {
  return matrix_(count_ + std::max(i, j), count_ + std::min(i, j));
}

SixColumns Eliminated::solve(const SixColumns& f) const {
  Rows x = rows_of(f);
  solve_triangles(Block(matrix_, 0, 0, count_, count_), x);
  return columns_of(x);
}

SixColumns Eliminated::forward(const SixColumns& x) const {
  const Rows rows = rows_of(x);
  const Block C(matrix_, count_, 0, rest(), count_);
  return columns_of(summed_by_chunks(rest(), blocks_of(count_), [&](Index block, Rows& sum) {
    add_product(C, kColumns * block, rows, sum);
  }));
}

SixColumns Eliminated::backward(const SixColumns& y) const {
  return columns_of(transposed_product(Block(matrix_, count_, 0, rest(), count_), rows_of(y)));
}

SixColumns Eliminated::apply(const SixColumns& y) const {
  const Block C(matrix_, count_, 0, rest(), count_), B(matrix_, count_, count_, rest(), rest());
  const Rows rows = rows_of(y);
  Rows x = transposed_product(C, rows);
  solve_triangles(Block(matrix_, 0, 0, count_, count_), x);
  for (Row& row : x) row.lanes = -row.lanes;
  const Index own = blocks_of(rest());
  return columns_of(summed_by_chunks(rest(), own + blocks_of(count_), [&](Index block, Rows& sum) {
    if (block < own) {
      add_symmetric(B, kColumns * block, rows, sum);
    } else {
      add_product(C, kColumns * (block - own), x, sum);
    }
  }));
}

}  // namespace hydro::bem
