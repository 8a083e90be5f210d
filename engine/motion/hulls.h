#pragma once

#include <memory>
#include <vector>

#include "engine/base/spec.h"

namespace engine {

/// The surface of a body that the water acts on. Pockets that may be flooded are a part of it.
const hydro::TriMesh& water_mesh(const BodySpec& spec);

/// The hulls of bodies; bodies of one mesh share one.
class Hulls {
 public:
  /// Returns the hull of a body: its own where it has one, else that of an earlier body with the
  /// same water_mesh(), else a new one.
  std::shared_ptr<const hydro::Hull> of(const BodySpec& spec);

 private:
  std::vector<std::shared_ptr<const hydro::Hull>> hulls_;
};

/// Gives the wet bodies their hulls, so that simulations of copies of the specification share them.
void keep_hulls(SimulationSpec& spec, Hulls& hulls);

}  // namespace engine
