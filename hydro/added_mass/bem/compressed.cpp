#include "hydro/added_mass/bem/compressed.h"

#include "hydro/added_mass/bem/near_pairs.h"
#include "hydro/added_mass/bem/quadrature.h"
#include "hydro/parallel.h"

namespace hydro::bem {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Weights of the parent's nodes: one column per node of the child.
Eigen::MatrixXd transfer(const Grid& parent, const Grid& child) {
  Eigen::MatrixXd matrix(parent.count(), child.count());
  for (Index i = 0; i < child.count(); ++i)
    matrix.col(i) = parent.weights_at(child.nodes().row(i).transpose());
  return matrix;
}

/// row += Σ factor · density over the near elements.
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

CompressedInteractions::CompressedInteractions(const Surface& surface)
    : surface_(surface),
      tree_(make_cluster_tree(surface.elements)),
      grids_(grids_of(tree_)),
      leaf_of_(surface.face_count()),
      batch_of_(tree_.clusters.size()),
      self_(surface.face_count()),
      rotation_moments_(surface.face_count()) {
  make_batches();
  store_near();
  add_far_rotation_moments();
}

Vector3d CompressedInteractions::point_of(std::size_t element, std::size_t k) const {
  return point(surface_.elements[element].corners, rule_of_degree_2()[k]);
}

void CompressedInteractions::make_batches() {
  for (std::size_t c = 0; c < tree_.clusters.size(); ++c) {
    const Cluster& cluster = tree_.clusters[c];
    if (!cluster.is_leaf()) continue;
    batch_of_[c] = batches_.size();
    std::vector<Element> elements;
    for (int i = cluster.first; i < cluster.last; ++i) {
      const auto place = static_cast<std::size_t>(i);
      leaf_of_[place] = static_cast<int>(c);
      if (elements.size() % kLanes == 0) batches_.emplace_back();
      batches_.back().elements.push_back(static_cast<std::size_t>(tree_.order[place]));
      elements.push_back(surface_.elements[batches_.back().elements.back()]);
    }
    const std::vector<Batch> batches = batches_of(elements);
    for (std::size_t k = 0; k < batches.size(); ++k) batches_[batch_of_[c] + k].batch = batches[k];
  }
}

template <class Function>
void CompressedInteractions::for_near(std::size_t place, Function&& f) const {
  const auto a = static_cast<std::size_t>(tree_.order[place]);
  const Element& element = surface_.elements[a];
  LanePairs pairs;
  for (const int leaf : tree_.clusters[static_cast<std::size_t>(leaf_of_[place])].near) {
    const Cluster& cluster = tree_.clusters[static_cast<std::size_t>(leaf)];
    const auto count =
        (static_cast<std::size_t>(cluster.last - cluster.first) + kLanes - 1) / kLanes;
    for (std::size_t k = 0; k < count; ++k) {
      const LeafBatch& batch = batches_[batch_of_[static_cast<std::size_t>(leaf)] + k];
      pairs_by_points(element, batch.batch, pairs);
      for (std::size_t lane = 0; lane < batch.elements.size(); ++lane) {
        const std::size_t b = batch.elements[lane];
        if (!is_beyond(kNear, element, surface_.elements[b]))
          set_lane(near_integrals(surface_, a, b), lane, pairs);
      }
      f(batch, pairs);
    }
  }
}

void CompressedInteractions::store_near() {
  row_start_.assign(1, 0);
  for (const int leaf : leaf_of_) {
    for (const int other : tree_.clusters[static_cast<std::size_t>(leaf)].near)
      for (int j = tree_.clusters[static_cast<std::size_t>(other)].first;
           j < tree_.clusters[static_cast<std::size_t>(other)].last; ++j)
        near_.push_back(tree_.order[static_cast<std::size_t>(j)]);
    row_start_.push_back(near_.size());
  }
  single_.resize(near_.size());
  parallel_for(tree_.order.size(), [&](std::size_t place) {
    const auto a = static_cast<std::size_t>(tree_.order[place]);
    std::size_t next = row_start_[place];
    LaneRotationMoments moments = {};
    for_near(place, [&](const LeafBatch& batch, const LanePairs& pairs) {
      add_rotation_moments(batch.batch, pairs, moments);
      for (std::size_t lane = 0; lane < batch.elements.size(); ++lane) {
        const Matrix3d hats = hats_of_lane(pairs, lane);
        single_[next++] = hats.sum();
        if (batch.elements[lane] == a) self_[a] = hats;
      }
    });
    rotation_moments_[a] = summed(moments);
  });
}

void CompressedInteractions::add_far_rotation_moments() {
  Columns charges(3 * surface_.mesh.face_count(), 12);
  for (std::size_t f = 0; f < surface_.face_count(); ++f) {
    const Element& element = surface_.elements[f];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d charge = element.area / 3 * element.normal;
      const Matrix3d moment = point_of(f, k) * charge.transpose();
      charges.row(static_cast<Index>(3 * f + k)) << charge.transpose(),
          moment.reshaped().transpose();
    }
  }
  const Columns potentials = far_potentials(charges);
  for (std::size_t f = 0; f < surface_.face_count(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = potentials.row(static_cast<Index>(3 * f + k));
      Matrix3d rotation_moments = at.tail<9>().transpose().reshaped(3, 3);
      rotation_moments.diagonal().array() -= at.head<3>().dot(point_of(f, k));
      for (std::size_t i = 0; i < 3; ++i)
        rotation_moments_[f][i] += hat_weight(f, k, i) * rotation_moments;
    }
  }
}

double CompressedInteractions::hat_weight(std::size_t element, std::size_t k, std::size_t i) const {
  return surface_.elements[element].area / 3 * rule_of_degree_2()[k].at[static_cast<Index>(i)];
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
    parallel_for(level->size(), [&](std::size_t i) { gather(charges, (*level)[i], moments); });
  std::vector<FloatColumns> single(count);
  parallel_for(count, [&](std::size_t c) { single[c] = moments[c].cast<float>(); });
  parallel_for(count, [&](std::size_t c) {
    for (const int other : tree_.clusters[c].far) {
      const auto from = static_cast<std::size_t>(other);
      add_interaction(grids_[c], grids_[from], single[from], fields[c].data());
    }
  });
  Columns potentials(charges.rows(), charges.cols());
  for (const std::vector<std::size_t>& level : tree_.levels)
    parallel_for(level.size(), [&](std::size_t i) { spread(level[i], fields, potentials); });
  return potentials;
}

Columns CompressedInteractions::charges_of(const Columns& densities) const {
  Columns charges(3 * densities.rows(), densities.cols());
  for (Index f = 0; f < densities.rows(); ++f)
    charges.middleRows<3>(3 * f).rowwise() =
        surface_.elements[static_cast<std::size_t>(f)].area / 3 * densities.row(f);
  return charges;
}

Columns CompressedInteractions::apply(const Columns& densities) const {
  const Columns potentials = far_potentials(charges_of(densities));
  Columns result(densities.rows(), densities.cols());
  parallel_for(tree_.order.size(), [&](std::size_t i) {
    const Index f = tree_.order[i];
    auto row = result.row(f);
    row = surface_.elements[static_cast<std::size_t>(f)].area / 3 *
          potentials.middleRows<3>(3 * f).colwise().sum();
    const std::size_t start = row_start_[i];
    add_rows(single_.data() + start, near_.data() + start, row_start_[i + 1] - start,
             densities.data(), densities.cols(), row.data());
  });
  return result;
}

Columns CompressedInteractions::apply_to_hats(const Columns& densities) const {
  const Columns potentials = far_potentials(charges_of(densities));
  Columns result = Columns::Zero(3 * densities.rows(), densities.cols());
  parallel_for(tree_.order.size(), [&](std::size_t place) {
    const auto f = static_cast<std::size_t>(tree_.order[place]);
    auto rows = result.middleRows<3>(static_cast<Index>(3 * f));
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        rows.row(static_cast<Index>(i)) +=
            hat_weight(f, k, i) * potentials.row(static_cast<Index>(3 * f + k));
    for_near(place, [&](const LeafBatch& batch, const LanePairs& pairs) {
      for (std::size_t lane = 0; lane < batch.elements.size(); ++lane)
        rows += hats_of_lane(pairs, lane).rowwise().sum() *
                densities.row(static_cast<Index>(batch.elements[lane]));
    });
  });
  return result;
}

double CompressedInteractions::bytes() const {
  double nodes = 0;
  for (const Grid& grid : grids_) nodes += static_cast<double>(grid.count());
  return static_cast<double>(near_.size()) * (sizeof(double) + sizeof(int)) +
         static_cast<double>(self_.size()) *
             (2 * sizeof(Element) + sizeof(RotationMoments) + 8.0 * (9 + 3 * 18 * 2)) +
         nodes * 24 * (2.0 * sizeof(double) + sizeof(float));
}

}  // namespace hydro::bem
