#pragma once

#include <memory>
#include <vector>

#include "engine/base/spec.h"
#include "hydro/loads/edge_drag.h"
#include "hydro/loads/hull_lift.h"
#include "hydro/loads/loads.h"
#include "hydro/loads/wake.h"

namespace engine {

/// The surface of a body that the water acts on. Pockets that may be flooded are a part of it.
const hydro::TriMesh& water_mesh(const BodySpec& spec);

/// The quantities that the pressure drag of a body in unsteady motion depends on.
struct WakeParts {
  hydro::WakeScale scale;
  hydro::EdgeDrag edges;
};

/// The hulls of bodies; bodies of one mesh share one. The specifications must outlive it.
class Hulls {
 public:
  /// Returns the hull of a body: its own where it has one, else that of an earlier body with the
  /// same water_mesh(), else a new one.
  std::shared_ptr<const hydro::Hull> of(const BodySpec& spec);

  /// Returns the sea as a hull feels it at an accuracy, shared alike. The sea must outlive it.
  std::shared_ptr<const hydro::kernel::FeltSea> felt_sea(
      const std::shared_ptr<const hydro::Hull>& hull, const hydro::Sea& sea,
      const hydro::LoadAccuracy& how);

  /// Returns the sections of a body's outside_B(), shared alike; null for one that cannot be
  /// slender.
  std::shared_ptr<const hydro::HullLift> lift_of(const BodySpec& spec);

  /// Returns the scale of the wake and the edges of a body's outside_B(), shared alike.
  std::shared_ptr<const WakeParts> wake_of(const BodySpec& spec);

 private:
  /// The data that follow from a mesh alone.
  template <class Part>
  struct OfMesh {
    const hydro::TriMesh* mesh_B;  ///< Mesh of the first body that has it.
    std::shared_ptr<const Part> part;
  };
  struct FeltByHull {
    std::shared_ptr<const hydro::Hull> hull;
    double wave_tolerance;
    std::shared_ptr<const hydro::kernel::FeltSea> sea;
  };
  std::vector<std::shared_ptr<const hydro::Hull>> hulls_;
  std::vector<FeltByHull> felt_seas_;
  std::vector<OfMesh<hydro::HullLift>> lifts_;
  std::vector<OfMesh<WakeParts>> wakes_;

  /// The part that an equal mesh has, or else the one that make() returns.
  template <class Part, class Make>
  static std::shared_ptr<const Part> shared(std::vector<OfMesh<Part>>& parts,
                                            const hydro::TriMesh& mesh_B, Make&& make);
};

/// Gives the wet bodies their hulls, so that simulations of copies of the specification share them.
void keep_hulls(SimulationSpec& spec, Hulls& hulls);

}  // namespace engine
