#include "hydro/bem/dense.h"

#include <tbb/parallel_for.h>

#include "hydro/bem/far_kernel.h"
#include "hydro/bem/pair.h"

namespace hydro::bem {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// What elements T (x) and T' (y) give to the swirl of T.
Matrix3d swirl_of(const Vector3d& first, const Vector3d& second, const Vector3d& normal) {
  Matrix3d swirl = second * normal.transpose();
  swirl.diagonal().array() -= normal.dot(first);
  return swirl;
}

/// The far rule for element `a` against all, 0 for those near it.
Matrix3d far_row(Index a, const std::vector<Element>& elements, const FarPoints& points,
                 std::vector<double>& sums, Eigen::Ref<Eigen::VectorXd> single) {
  const Element& here = elements[static_cast<std::size_t>(a)];
  const auto count = static_cast<std::size_t>(single.size());
  far_sums(points, static_cast<std::size_t>(a), sums.data());
  const auto sum = [&](std::size_t k, std::size_t b) { return sums[k * count + b]; };
  Matrix3d swirl = Matrix3d::Zero();
  const Eigen::Matrix3d x = points.of(static_cast<std::size_t>(a));
  for (std::size_t b = 0; b < count; ++b) {
    const Element& there = elements[b];
    if (!is_far(here, there)) continue;
    const double weight = here.area * there.area / 9;
    const Vector3d at_x(sum(0, b), sum(1, b), sum(2, b));
    const Vector3d at_y(sum(3, b), sum(4, b), sum(5, b));
    single[static_cast<Index>(b)] = weight * at_x.sum();
    swirl += swirl_of(weight * (x * at_x), weight * (points.of(b) * at_y), there.normal);
  }
  return swirl;
}

}  // namespace

std::array<int, 3> shared_corners(const Eigen::Matrix3Xi& faces, Index a, Index b) {
  std::array<int, 3> shared = {-1, -1, -1};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      if (faces(i, a) == faces(j, b)) shared[static_cast<std::size_t>(i)] = j;
  }
  return shared;
}

OrderedPair near_pair(const TriMesh& mesh, const std::vector<Element>& elements, Index a, Index b) {
  const bool turn = a > b;
  const Index low = turn ? b : a, high = turn ? a : b;
  PairIntegrals pair = pair_integrals(elements[static_cast<std::size_t>(low)],
                                      elements[static_cast<std::size_t>(high)],
                                      shared_corners(mesh.faces, low, high));
  if (turn) std::swap(pair.first, pair.second);
  return {pair.single,
          swirl_of(pair.first, pair.second, elements[static_cast<std::size_t>(b)].normal)};
}

DenseInteractions dense_interactions(const TriMesh& mesh, const std::vector<Element>& elements) {
  const auto count = static_cast<Index>(elements.size());
  const FarPoints points(elements);
  DenseInteractions result{Eigen::MatrixXd(count, count), {}};
  result.swirl.resize(elements.size());
  tbb::parallel_for(tbb::blocked_range<Index>(0, count, 8), [&](const auto& range) {
    std::vector<double> sums(6 * elements.size());
    for (Index a = range.begin(); a < range.end(); ++a) {
      // The matrix is symmetric: its columns, which lie together in memory, are its rows.
      auto column = result.single.col(a);
      Matrix3d swirl = far_row(a, elements, points, sums, column);
      for (Index b = 0; b < count; ++b) {
        if (is_far(elements[static_cast<std::size_t>(a)], elements[static_cast<std::size_t>(b)]))
          continue;
        const OrderedPair pair = near_pair(mesh, elements, a, b);
        column[b] = pair.single;
        swirl += pair.swirl;
      }
      result.swirl[static_cast<std::size_t>(a)] = swirl;
    }
  });
  return result;
}

}  // namespace hydro::bem
