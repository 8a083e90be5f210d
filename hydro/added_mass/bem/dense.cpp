#include "hydro/added_mass/bem/dense.h"

#include <algorithm>
#include <array>
#include <utility>

#include "hydro/added_mass/bem/galerkin.h"
#include "hydro/added_mass/bem/near_pairs.h"
#include "hydro/added_mass/bem/pair.h"
#include "hydro/parallel.h"

namespace hydro::bem {
namespace {

using Eigen::Index;

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

/// Adds the upper triangle to the lower one, by squares that fit into a processor's memory. The
/// diagonal counts twice.
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

/// Zeros, written by all threads: a processor is handed new memory while it writes.
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
    result_.rotation_moments.resize(surface.face_count());
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
    LaneRotationMoments moments = {};
    const Element& element = surface_.elements[a];
    auto near = near_.of(a).begin();
    for (std::size_t batch = 0; batch < batches_.size(); ++batch) {
      pairs_by_points(element, batches_[batch], pairs);
      for (; near != near_.of(a).end() && near->element / kLanes == batch; ++near)
        set_lane(near->integrals, near->element % kLanes, pairs);
      add_rotation_moments(batches_[batch], pairs, moments);
      if (kLanes * (batch + 1) <= a) continue;
      couple(element, batches_[batch], pairs, couplings);
      scatter(a, kLanes * batch, couplings);
    }
    result_.rotation_moments[a] = summed(moments);
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

}  // namespace

DenseEquations dense_equations(const Surface& surface) { return Assembly(surface).run(); }

}  // namespace hydro::bem
