#pragma once

#include <array>

#include "hydro/mesh/mesh.h"
#include "hydro/spatial.h"

/// @file
/// Pressure drag scaled so that it agrees with tabulated drag coefficients.
///
/// The panel method gives a body some drag along each of its axes. Where the drag is known, F_i = ½
/// ρ C_d,i S_i v² with the frontal area S_i (the projected area along axis i), the factor κ_i
/// corrects it. In a general motion ν the factors are weighted by the share of the surface's motion
/// along each axis,
///
///     κ(ν) = Σ_i κ_i q_i(ν) / Σ_i q_i(ν),    q_i(ν) = (1/S) ∫ (e_i · (v + ω × r))² dS, (1)
///
/// so that κ = κ_i for a translation along axis i whatever the mesh, κ depends smoothly on the
/// motion, and drag still dissipates energy in every motion. q_i is a quadratic form in ν, whose
/// matrix is exact on flat triangles.

namespace hydro {

struct PressureDrag;

/// Scale of the pressure drag of one body. It is constant.
struct DragCalibration {
  Eigen::Vector3d factor = Eigen::Vector3d::Ones();  ///< κ_i [-], body axes.
  /// Matrices of q_i in body axes about the centre of mass, translation first.
  std::array<Matrix6d, 3> motion = {Matrix6d::Zero(), Matrix6d::Zero(), Matrix6d::Zero()};
};

/// The calibration of a closed mesh in B for drag coefficients along its axes [-], each the mean of
/// both directions. @throws std::invalid_argument if the panels have no drag along an axis.
DragCalibration calibrate_drag(const TriMesh& mesh_B, const PressureDrag& drag,
                               const Eigen::Vector3d& tabulated);

/// κ(ν) of equation (1); 1 without motion.
/// @param motion_B   Motion relative to the water, body axes.
double drag_factor(const DragCalibration& calibration, const Twist& motion_B);

/// Area of the projection of a mesh along an axis (0, 1 or 2) [m^2]: the union of its triangles'
/// projections, by 4,096 scan lines. An edge of the outline parallel to the lines may be one line
/// off, 2.5e-4 of the height; elsewhere the error is of second order in that.
double frontal_area(const TriMesh& mesh, int axis);

}  // namespace hydro
