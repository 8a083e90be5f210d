#include "hydro/bem/compressed.h"

#include <tbb/parallel_for.h>

#include "hydro/bem/dense.h"
#include "hydro/bem/far_kernel.h"
#include "hydro/bem/interpolation.h"
#include "hydro/bem/quadrature.h"

namespace hydro::bem {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// For each node of the child, a column, the weights of its parent's nodes.
Eigen::MatrixXd transfer(const Grid& parent, const Grid& child) {
  Eigen::MatrixXd matrix(parent.count(), child.count());
  for (Index i = 0; i < child.count(); ++i)
    matrix.col(i) = parent.weights_at(child.nodes().row(i).transpose());
  return matrix;
}

/// row += Σ factor · densities of near elements.
PLIMSOLL_VECTOR_CLONES
void add_rows(const double* factors, const int* near, std::size_t count, const double* densities,
              Index columns, double* row) {
  for (std::size_t k = 0; k < count; ++k) {
    const double* density = densities + near[k] * columns;
    const double factor = factors[k];
    for (Index c = 0; c < columns; ++c) row[c] += factor * density[c];
  }
}

std::vector<Grid> grids_of(const ClusterTree& tree) {
  std::vector<Grid> grids;
  for (const Cluster& cluster : tree.clusters) grids.emplace_back(cluster.box);
  return grids;
}

}  // namespace

CompressedInteractions::CompressedInteractions(const TriMesh& mesh,
                                               const std::vector<Element>& elements)
    : elements_(elements),
      tree_(make_cluster_tree(elements)),
      grids_(grids_of(tree_)),
      self_(elements.size()),
      swirl_(elements.size(), Matrix3d::Zero()) {
  store_near(mesh);
  add_far_swirl();
}

Vector3d CompressedInteractions::point_of(std::size_t element, std::size_t k) const {
  return point(elements_[element].corners, rule_of_degree_2()[k]);
}

void CompressedInteractions::store_near(const TriMesh& mesh) {
  std::vector<int> leaf_of(tree_.order.size());  // by place in the order
  row_start_.assign(1, 0);
  for (std::size_t c = 0; c < tree_.clusters.size(); ++c) {
    if (!tree_.clusters[c].is_leaf()) continue;
    for (int i = tree_.clusters[c].first; i < tree_.clusters[c].last; ++i)
      leaf_of[static_cast<std::size_t>(i)] = static_cast<int>(c);
  }
  for (const int leaf : leaf_of) {
    for (const int other : tree_.clusters[static_cast<std::size_t>(leaf)].near)
      for (int j = tree_.clusters[static_cast<std::size_t>(other)].first;
           j < tree_.clusters[static_cast<std::size_t>(other)].last; ++j)
        near_.push_back(tree_.order[static_cast<std::size_t>(j)]);
    row_start_.push_back(near_.size());
  }
  single_.resize(near_.size());
  tbb::parallel_for(std::size_t{0}, tree_.order.size(), [&](std::size_t i) {
    const int a = tree_.order[i];
    for (std::size_t k = row_start_[i]; k < row_start_[i + 1]; ++k) {
      const OrderedPair pair = near_pair(mesh, elements_, a, near_[k]);
      single_[k] = pair.single;
      swirl_[static_cast<std::size_t>(a)] += pair.swirl;
      if (near_[k] == a) self_[static_cast<std::size_t>(a)] = pair.single;
    }
  });
}

void CompressedInteractions::add_far_swirl() {
  Columns charges(3 * static_cast<Index>(elements_.size()), 12);
  for (std::size_t f = 0; f < elements_.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d charge = elements_[f].area / 3 * elements_[f].normal;
      const Matrix3d moment = point_of(f, k) * charge.transpose();
      charges.row(static_cast<Index>(3 * f + k)) << charge.transpose(),
          moment.reshaped().transpose();
    }
  }
  const Columns potentials = far_potentials(charges);
  for (std::size_t f = 0; f < elements_.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = potentials.row(static_cast<Index>(3 * f + k));
      Matrix3d swirl = at.tail<9>().transpose().reshaped(3, 3);
      swirl.diagonal().array() -= at.head<3>().dot(point_of(f, k));
      swirl_[f] += elements_[f].area / 3 * swirl;
    }
  }
}

void CompressedInteractions::gather(const Columns& charges, std::size_t c,
                                    std::vector<Columns>& moments) const {
  const Cluster& cluster = tree_.clusters[c];
  const Grid& grid = grids_[c];
  for (const int child : cluster.children) {
    if (child < 0) continue;
    const auto at = static_cast<std::size_t>(child);
    moments[c].noalias() += transfer(grid, grids_[at]) * moments[at];
  }
  for (int i = cluster.first; cluster.is_leaf() && i < cluster.last; ++i) {
    const auto f = static_cast<std::size_t>(tree_.order[static_cast<std::size_t>(i)]);
    for (std::size_t k = 0; k < 3; ++k)
      moments[c].leftCols(charges.cols()).noalias() +=
          grid.weights_at(point_of(f, k)) * charges.row(static_cast<Index>(3 * f + k));
  }
}

void CompressedInteractions::spread(std::size_t c, std::vector<Columns>& fields,
                                    Columns& potentials) const {
  const Cluster& cluster = tree_.clusters[c];
  const Grid& grid = grids_[c];
  if (cluster.parent >= 0) {
    const auto up = static_cast<std::size_t>(cluster.parent);
    fields[c].noalias() += transfer(grids_[up], grid).transpose() * fields[up];
  }
  for (int i = cluster.first; cluster.is_leaf() && i < cluster.last; ++i) {
    const auto f = static_cast<std::size_t>(tree_.order[static_cast<std::size_t>(i)]);
    for (std::size_t k = 0; k < 3; ++k)
      potentials.row(static_cast<Index>(3 * f + k)).noalias() =
          grid.weights_at(point_of(f, k)).transpose() * fields[c].leftCols(potentials.cols());
  }
}

Columns CompressedInteractions::far_potentials(const Columns& charges) const {
  const std::size_t count = tree_.clusters.size();
  const int width = (static_cast<int>(charges.cols()) + kBlock - 1) / kBlock * kBlock;
  std::vector<Columns> moments;
  for (const Grid& grid : grids_) moments.push_back(Columns::Zero(grid.count(), width));
  std::vector<Columns> fields = moments;
  for (auto level = tree_.levels.rbegin(); level != tree_.levels.rend(); ++level)
    tbb::parallel_for(std::size_t{0}, level->size(),
                      [&](std::size_t i) { gather(charges, (*level)[i], moments); });
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t c) {
    for (const int other : tree_.clusters[c].far) {
      const auto from = static_cast<std::size_t>(other);
      add_interaction(grids_[c], grids_[from], moments[from].data(), width, fields[c].data());
    }
  });
  Columns potentials(charges.rows(), charges.cols());
  for (const std::vector<std::size_t>& level : tree_.levels)
    tbb::parallel_for(std::size_t{0}, level.size(),
                      [&](std::size_t i) { spread(level[i], fields, potentials); });
  return potentials;
}

Columns CompressedInteractions::apply(const Columns& densities) const {
  Columns charges(3 * densities.rows(), densities.cols());
  for (Index f = 0; f < densities.rows(); ++f)
    charges.middleRows<3>(3 * f).rowwise() =
        elements_[static_cast<std::size_t>(f)].area / 3 * densities.row(f);
  const Columns potentials = far_potentials(charges);
  Columns result(densities.rows(), densities.cols());
  tbb::parallel_for(std::size_t{0}, tree_.order.size(), [&](std::size_t i) {
    const Index f = tree_.order[i];
    auto row = result.row(f);
    row = elements_[static_cast<std::size_t>(f)].area / 3 *
          potentials.middleRows<3>(3 * f).colwise().sum();
    const std::size_t start = row_start_[i];
    add_rows(single_.data() + start, near_.data() + start, row_start_[i + 1] - start,
             densities.data(), densities.cols(), row.data());
  });
  return result;
}

double CompressedInteractions::bytes() const {
  double nodes = 0;
  for (const Grid& grid : grids_) nodes += static_cast<double>(grid.count());
  return static_cast<double>(near_.size()) * (sizeof(double) + sizeof(int)) +
         static_cast<double>(elements_.size()) * (sizeof(Element) + 8.0 * 3 * 18 * 2) +
         nodes * 24 * 8.0 * 2;
}

}  // namespace hydro::bem
