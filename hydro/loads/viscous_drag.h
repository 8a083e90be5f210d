#pragma once

#include "hydro/loads/panel_loads.h"

namespace hydro {

/// C_v at a tangential speed [m/s].
double viscous_coefficient(const ViscousDrag& law, double speed);

/// Viscous drag on one flat, wet panel: F = −½ρ ∫ C_v(|v_t|) |v_t| v_t dA, v_t = v − (v·n) n.
///
/// The integrand is no polynomial. Where v_t hardly changes over the panel, a seven-point rule of
/// degree 5 [R48] is used, separately on each side of a kink of C_v. Elsewhere (v_t passes through
/// zero) a C_v that is piecewise linear in the speed has a closed form, `rotary_drag`; with the
/// ITTC line the panel is split in four until two levels agree within `kViscousTolerance` of its
/// largest possible load.
///
/// @param motion          Motion of the body relative to the water.
/// @param half_density    ½ρ [kg/m^3].
///
/// [R48] Radon. Zur mechanischen Kubatur. Monatsh. Math. 52 (1948) 286-300.
Wrench viscous_drag_load(const Panel& panel, const Eigen::Vector3d& normal, const Twist& motion,
                         const ViscousDrag& law, double half_density);

/// Error of a panel's viscous load with the ITTC line, over its area times its largest traction
/// [-]. Summed over a body the error stays below 1e-5 of the load's largest component. With the
/// other laws it is below 1e-9.
inline constexpr double kViscousTolerance = 1e-6;

}  // namespace hydro
