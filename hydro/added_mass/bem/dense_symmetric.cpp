#include "hydro/added_mass/bem/dense_symmetric.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <utility>
#include <vector>

#include "hydro/added_mass/bem/column_sums.h"
#include "hydro/parallel.h"

namespace hydro::bem {
namespace {

using Eigen::Index;

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

using Block = Eigen::Block<const Eigen::MatrixXd>;

/// kColumns columns of a block, from a row on down.
EightColumns eight_columns(const Block& block, Index row, Index column) {
  return {block.data() + column * block.outerStride() + row, block.outerStride(),
          block.rows() - row};
}

Index blocks_of(Index columns) { return (columns + kColumns - 1) / kColumns; }

/// y += of x the part that kColumns columns of a symmetric matrix, from its diagonal on down, and
/// the rows they stand for give. The last columns may be fewer: there is nothing below them.
void add_symmetric(const Block& lower, Index first, const Rows& x, Rows& y) {
  const Index width = std::min(kColumns, lower.rows() - first), below = first + kColumns;
  Row sums[kColumns];
  if (below < lower.rows())
    dot_and_add_columns(eight_columns(lower, below, first), &at(x, below), &at(y, below),
                        &at(x, first), sums);
  for (Index c = 0; c < width; ++c) {
    Lanes sum = sums[c].lanes + lower(first + c, first + c) * at(x, first + c).lanes;
    for (Index i = c + 1; i < width; ++i) {
      sum += lower(first + i, first + c) * at(x, first + i).lanes;
      at(y, first + i).lanes += lower(first + i, first + c) * at(x, first + c).lanes;
    }
    at(y, first + c).lanes += sum;
  }
}

/// y += kColumns columns of a block times x, or the fewer last ones.
void add_product(const Block& block, Index first, const Rows& x, Rows& y) {
  if (first + kColumns <= block.cols()) {
    add_columns(eight_columns(block, 0, first), &at(x, first), y.data());
    return;
  }
  for (Index c = first; c < block.cols(); ++c)
    for (Index i = 0; i < block.rows(); ++i) at(y, i).lanes += block(i, c) * at(x, c).lanes;
}

/// Sums that threads take side by side: fixed, so that the result is the same for any number.
constexpr std::size_t kChunks = 16;

/// Σ f(block, sum) over blocks of columns, each chunk to a sum of its own.
template <class Function>
Rows summed_by_chunks(Index rows, Index blocks, Function f) {
  std::vector<Rows> parts(kChunks);
  parallel_for(kChunks, [&](std::size_t chunk) {
    parts[chunk].resize(static_cast<std::size_t>(rows));
    // One after the other, for columns get shorter.
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
      dot_columns(eight_columns(block, 0, first), x.data(), &at(result, first));
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
    if (below < count) add_columns(eight_columns(L, below, first), sums, &at(x, below));
  }
  for (Index first = kColumns * (blocks_of(count) - 1); first >= 0; first -= kColumns) {
    const Index below = std::min(first + kColumns, count);
    if (below < count) {
      dot_columns(eight_columns(L, below, first), &at(x, below), sums);
      for (Index c = first; c < below; ++c) at(x, c).lanes -= sums[c - first].lanes;
    }
    for (Index c = below - 1; c >= first; --c) {
      for (Index i = c + 1; i < below; ++i) at(x, c).lanes -= L(i, c) * at(x, i).lanes;
      at(x, c).lanes /= L(c, c);
    }
  }
}

/// Overwrites the lower triangle of the first `count` rows and columns by its factor.
/// @return false if it is not positive.
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

Eliminated::Eliminated(Eigen::MatrixXd lower_triangle, Index count)
    : matrix_(std::move(lower_triangle)), count_(count) {
  assert(matrix_.rows() == matrix_.cols() && 0 <= count && count <= matrix_.rows());
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
