#include "hydro/added_mass/wetted_added_mass.h"

#include <cassert>
#include <optional>

#include "hydro/airy_waves.h"
#include "hydro/decompositions.h"
#include "hydro/loads/kernel/water_surface.h"
#include "hydro/loads/loads.h"
#include "hydro/loads/refine.h"

namespace hydro {

using Eigen::Vector3d;

Matrix6d semi_definite_part(const Matrix6d& matrix) {
  const Matrix6d symmetric = 0.5 * (matrix + matrix.transpose());
  if (Cholesky6(symmetric).positive_definite()) return symmetric;
  const EigenDecomposition6 eigen = eigen_decomposition(symmetric);
  if (eigen.values.minCoeff() >= 0) return symmetric;
  const Vector6d kept = eigen.values.cwiseMax(0);
  const Matrix6d part = eigen.vectors * kept.asDiagonal() * eigen.vectors.transpose();
  return 0.5 * (part + part.transpose());
}

struct WettedAddedMass::PreparedSea {
  PreparedSea(const WettedAddedMass& model, const Sea& of)
      : sea(of),
        felt(sea, kSmallestPanel * model.radius_, model.panels_.longest_edge, model.head_error(),
             {SplitFor::surface, SplitFor::head}) {}

  Sea sea;
  kernel::FeltSea felt;  ///< It refers to `sea`.
};

WettedAddedMass::WettedAddedMass(const TriMesh& mesh_B, const AddedMassSolution& solution,
                                 const Sea* sea)
    : radius_(mesh_B.vertices.colwise().norm().maxCoeff()),
      whole_(semi_definite_part(solution.matrix)),
      panels_(kernel::make_panels(mesh_B)),
      tree_(kernel::make_tree(panels_)),
      potentials_(kernel::make_potentials(mesh_B, panels_, tree_, solution.potentials)) {
  assert(is_symmetric(solution.matrix));
  if (sea && has_airy_waves(*sea) && !tree_.nodes.empty())
    prepared_ = std::make_shared<const PreparedSea>(*this, *sea);
}

HeadError WettedAddedMass::head_error() const {
  return {LoadAccuracy{}.wave_tolerance, volume_over_area(tree_)};
}

/// The inputs of the kernel, which refer to the surface: neither copied nor moved.
struct WettedAddedMass::Immersion {
  Immersion(const WettedAddedMass& model, const BodyState& state, const Sea& sea, double time,
            SplitFor what) {
    assert(is_unit(state.orientation));
    const PreparedSea* prepared = model.prepared_.get();
    if (prepared && !prepared->felt.is_like(sea)) prepared = nullptr;
    const SurfaceBounds bounds = prepared ? prepared->felt.bounds() : surface_bounds(sea);
    if (model.tree_.nodes.empty() || state.position.z() - model.radius_ >= bounds.highest) return;
    const Vector3d up_B = state.orientation.conjugate() * Vector3d::UnitZ();
    const kernel::Node& root = model.tree_.nodes.front();
    const double middle = state.position.z() + up_B.dot(Vector3d::Map(root.centre));
    const double half = up_B.cwiseAbs().dot(Vector3d::Map(root.half));
    if (middle - half >= bounds.highest) return;
    dry = false;
    in.wet = middle + half < bounds.lowest;
    Vector3d::Map(in.up) = up_B;
    in.below = sea.level - state.position.z();
    if (is_flat(sea) || (in.wet && !has_airy_waves(sea))) return;
    const HeadError error = model.head_error();
    if (!prepared)
      felt.emplace(sea, kSmallestPanel * model.radius_, model.panels_.longest_edge, error,
                   std::initializer_list<SplitFor>{what});
    surface.emplace(prepared ? prepared->felt : *felt, state, time, what);
    in.surface = &*surface;
    in.wave_error = kernel::allowed_wave_error(error.tolerance, error.volume_over_area, *surface);
  }
  Immersion(const Immersion&) = delete;
  Immersion& operator=(const Immersion&) = delete;

  bool dry = true;
  kernel::LoadInputs in;
  std::optional<kernel::FeltSea> felt;  ///< For a sea that is not prepared.
  std::optional<kernel::WaterSurface> surface;
};

Matrix6d WettedAddedMass::at(const BodyState& state, const Sea& sea, double time) const {
  return sea.density * share(state, sea, time).share;
}

kernel::WettedShare WettedAddedMass::share(const BodyState& state, const Sea& sea,
                                           double time) const {
  const Immersion water(*this, state, sea, time, SplitFor::surface);
  if (water.dry) return {};
  if (water.in.wet) return {.share = whole_, .cut = {}};
  kernel::WettedShare part = kernel::wetted_share(panels_, tree_, potentials_, water.in);
  part.share = semi_definite_part(part.share);
  return part;
}

kernel::WaveShare WettedAddedMass::wave_share(const BodyState& state, const Sea& sea,
                                              double time) const {
  const Immersion water(*this, state, sea, time, SplitFor::head);
  if (water.dry || !water.in.surface) return {};
  return kernel::wave_share(panels_, tree_, potentials_, water.in);
}

Wrench WettedAddedMass::wave_load(const BodyState& state, const Sea& sea, double time) const {
  return load_of_waves(state, sea, time).load;
}

WettedAddedMass::WaveLoad WettedAddedMass::load_of_waves(const BodyState& state, const Sea& sea,
                                                         double time) const {
  if (!has_airy_waves(sea)) return {};
  const kernel::WaveShare part = wave_share(state, sea, time);
  const Matrix6d A = semi_definite_part(part.share);
  const Vector3d u_B =
      state.orientation.conjugate() * water_at(sea, state.position, time).acceleration;
  const Vector6d load_B = sea.density * (part.load + (A - part.share).leftCols<3>() * u_B);
  return {A, {state.orientation * load_B.head<3>(), state.orientation * load_B.tail<3>()}};
}

}  // namespace hydro
