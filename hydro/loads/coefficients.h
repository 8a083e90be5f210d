#pragma once

#include <Eigen/Core>
#include <optional>

#include "hydro/loads/drag_calibration.h"

/// @file
/// Coefficients of drag and lift.

namespace hydro {

/// C_p of panels that move into the water (u > 0, the front) and out of it (the back), with the
/// normal speed u of bluntness.h.
///
/// The defaults, with the ITTC line, are fitted to the tabulated drag of 34 blunt and slender
/// bodies: a median error of 13 %, against 38 % for the thesis's coefficients
/// (hydro/loads/README.md, "Coefficients").
struct PressureDrag {
  double front = 0.71;  ///< [-], >= 0.
  double back = 0.30;   ///< [-], >= 0.
  double blunt = 0.30;  ///< Bluntness from which on the drag counts in full; 0: always [-].

  /// True if there is no pressure drag.
  bool none() const { return front == 0 && back == 0; }
  bool operator==(const PressureDrag&) const = default;
};

/// C_v as a function of the local tangential speed.
struct ViscousDrag {
  /// C_v over the speed.
  enum class Law {
    none,      ///< 0 everywhere; nothing is computed.
    constant,  ///< `coefficient` everywhere.
    thesis,    ///< 0.1 below 1 m/s, 0.2 − 0.1·v/(m/s) from 1 to 2 m/s, 0 above.
    ittc57     ///< The ITTC 1957 line: 0.075 / (log10 Re − 2)^2, held below Re = 1e4.
  };
  Law law = Law::ittc57;   ///< C_v over the speed.
  double coefficient = 0;  ///< For `constant` [-].
  double length = 0;  ///< For `ittc57`: L [m]. `for_mesh` replaces 0 by the mesh's longest side.
  /// For `ittc57`: L/ν, so that Re = |v_t| L/ν [s/m]. The default is that of 1 m in water of 20 °C:
  /// a body ten times as long has a C_v that is a third lower at 1 m/s.
  double reynolds_per_speed = 1e6;

  /// True if there is no viscous drag.
  bool none() const { return law == Law::none || (law == Law::constant && coefficient == 0); }
  bool operator==(const ViscousDrag&) const = default;
};

/// The coefficients of the loads on a body. Zero switches a load off: it is not computed.
struct Coefficients {
  bool buoyancy = true;        ///< False: the water exerts no buoyancy.
  PressureDrag pressure_drag;  ///< C_p of both sides.
  double lift = 0;             ///< C_l [-].
  ViscousDrag viscous_drag;    ///< C_v.
  /// K of bluntness.h in body axes: symmetric, with eigenvalues from 0 to 1 [-].
  Eigen::Matrix3d drag_shape = Eigen::Matrix3d::Identity();
  std::optional<DragCalibration> calibration;  ///< Scales the pressure drag.
};

/// The coefficients of the 2014 thesis: C_p = 0.6316 on both sides of any body, C_l = 0.01, its
/// C_v.
inline Coefficients thesis_coefficients() {
  return {.pressure_drag = {0.6316, 0.6316, 0},
          .lift = 0.01,
          .viscous_drag = {.law = ViscousDrag::Law::thesis}};
}

/// Coefficients with what the shape of a body gives them: the length of the ITTC line, unless it is
/// given, and with it L/ν; and K of bluntness.h. Without this the line is that of 1 m, and every
/// body counts as blunt.
/// @param mesh_B      Closed, in body axes [m].
/// @param viscosity   Kinematic [m^2/s].
Coefficients for_mesh(Coefficients coefficients, const TriMesh& mesh_B, double viscosity);

/// True if the water exerts no load on a body with these coefficients.
inline bool no_load(const Coefficients& c) {
  return !c.buoyancy && c.pressure_drag.none() && c.lift == 0 && c.viscous_drag.none();
}

}  // namespace hydro
