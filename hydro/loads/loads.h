#pragma once

#include <memory>

#include "hydro/loads/coefficients.h"
#include "hydro/loads/felt_waves.h"
#include "hydro/loads/kernel/panels.h"
#include "hydro/loads/kernel/tree.h"
#include "hydro/mesh/mesh.h"
#include "hydro/sea.h"
#include "hydro/spatial.h"

/// @file
/// The load of the water on a body: the sum over its wetted triangles.

namespace hydro {
namespace kernel {
class FeltSea;
}

/// The outer surface of a body, as the water sees it. It is constant.
struct Hull {
  /// A part of a surface is open: what it lacks is dry, or a hull of its own.
  enum class Boundary { closed, open };

  TriMesh mesh_B;         ///< Outward; its origin is the centre of mass.
  double radius = 0;      ///< Largest distance of a vertex from the centre of mass [m].
  kernel::Panels panels;  ///< The mesh as the kernel reads it.
  kernel::Tree tree;      ///< The panels by place, for the kernel.
  Boundary boundary = Boundary::closed;  ///< Closed unless it is a part.
};

/// Builds a hull from a mesh in B.
Hull make_hull(TriMesh mesh_B, Hull::Boundary boundary = Hull::Boundary::closed);

/// The loads of the water, and of the air above it, by kind, in W. Moments are about the centre of
/// mass.
struct Loads {
  Wrench buoyancy;       ///< Load of the pressure of the undisturbed water.
  Wrench pressure_drag;  ///< Load of the flow along the normals of panels.
  Wrench viscous_drag;   ///< Load of friction along panels.
  Wrench lift;           ///< Load of the lift of panels.
  Wrench wave_inertia;   ///< AddedMassModel::wave_load; `compute_loads` leaves it at 0.
  Wrench diffraction;    ///< FloatingBody::wave_load; `compute_loads` leaves it at 0.
  Wrench hull_lift;      ///< HullLift::load; `compute_loads` leaves it at 0.
  Wrench wind;           ///< Load of the air on the dry part (wind.h).
  Wrench interior;       ///< Load of water in pockets (interior.h); `compute_loads` leaves it at 0.
  Wrench resistance;     ///< Along the motion (resistance.h); `compute_loads` leaves it at 0.
  double wetted_area = 0;       ///< [m^2]
  double displaced_volume = 0;  ///< Volume of the body below the surface [m^3].

  /// Adds all loads, areas and volumes.
  Loads& operator+=(const Loads& other);
  /// The sum of all loads.
  Wrench total() const {
    return buoyancy + pressure_drag + viscous_drag + lift + wave_inertia + diffraction + hull_lift +
           wind + interior + resistance;
  }
};

/// The factor of a body's pressure drag by its calibration in the given motion [-]. It is 1 without
/// a calibration.
/// @param current   Velocity of the water, or of the wind [m/s].
double drag_scale(const Coefficients& coefficients, const BodyState& state,
                  const Eigen::Vector3d& current);

/// Accuracy of the sum over the panels.
struct LoadAccuracy {
  /// Whole branches of the tree are taken at once. On flat water the result is the same.
  bool branches = true;
  /// In waves a branch is taken whole where the error of the force that follows is below this part
  /// of the wholly submerged body's buoyancy, shared out by area [-], and the error of the head
  /// below ten times this part of the waves' height. With 0 no branch is. The sum over pieces of
  /// panels misses less than the same part of the force, or than kLeastWaveTolerance if that is
  /// larger.
  double wave_tolerance = 1e-4;
};

/// The least tolerance that pieces of panels follow in waves [-]: their edges end at
/// kSmallestPanel.
inline constexpr double kLeastWaveTolerance = 1e-6;

/// The error that the sum over a hull may make in the head of waves.
HeadError head_error(const Hull& hull, const LoadAccuracy& how);

/// The load on a hull in the given state of motion at a time, that of the air on its dry part
/// included.
///
/// In still water buoyancy, pressure drag and lift are exact to round-off, viscous drag to 1e-5 of
/// its largest component. Over a grid the surface is taken as linear over panels that are split
/// until it departs from linear by less than a tolerance. Under Airy waves the head and the
/// velocity of the water are linear over panels on which they bend little, and the loads on the
/// others are summed at points of pieces of them, within `LoadAccuracy::wave_tolerance` (refine.h).
/// Buoyancy is the load of all of the water's pressure, and the motion that makes drag and lift is
/// relative to the water on the spot.
Loads compute_loads(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                    const Coefficients& coefficients, const LoadAccuracy& how = {});

/// The sea as a hull feels it at an accuracy, prepared for many loads. The sea must outlive it, and
/// not change.
std::shared_ptr<const kernel::FeltSea> make_felt_sea(const Hull& hull, const Sea& sea,
                                                     const LoadAccuracy& how);

/// The same loads in a sea that was prepared for this hull and accuracy.
Loads compute_loads(const Hull& hull, const BodyState& state, const kernel::FeltSea& felt,
                    double time, const Coefficients& coefficients, const LoadAccuracy& how);

}  // namespace hydro
