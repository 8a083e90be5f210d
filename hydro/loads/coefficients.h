#pragma once

#include <Eigen/Core>
#include <optional>

#include "hydro/loads/drag_calibration.h"

namespace hydro {

/// C_p of panels that move into the water (v·n > 0, the front) and out of it (the back).
///
/// The defaults fit the tabulated drag of eleven bluff shapes best in the mean of |log(C_d ours /
/// C_d tabulated)|: a median error of 15 %, against 31 % for the thesis's single 0.6316 (README.md
/// of this folder, "Coefficients").
struct PressureDrag {
  double front = 0.93;  ///< [-], >= 0.
  double back = 0.12;   ///< [-], >= 0.

  bool none() const { return front == 0 && back == 0; }
  bool operator==(const PressureDrag&) const = default;
};

/// C_v as a function of the local tangential speed.
struct ViscousDrag {
  enum class Law {
    none,      ///< 0 everywhere; nothing is computed.
    constant,  ///< `coefficient` everywhere.
    thesis,    ///< 0.1 below 1 m/s, 0.2 − 0.1·v/(m/s) from 1 to 2 m/s, 0 above.
    ittc57     ///< The ITTC 1957 line: 0.075 / (log10 Re − 2)^2, held below Re = 1e4.
  };
  Law law = Law::thesis;
  double coefficient = 0;         ///< For `constant` [-].
  double length = 0;              ///< For `ittc57`: L [m].
  double reynolds_per_speed = 0;  ///< For `ittc57`: L/ν, so that Re = |v_t| L/ν [s/m].

  bool none() const { return law == Law::none || (law == Law::constant && coefficient == 0); }
  bool operator==(const ViscousDrag&) const = default;
};

/// The coefficients of the loads on a body. Zero switches a load off: it is not computed.
struct Coefficients {
  bool buoyancy = true;
  PressureDrag pressure_drag;
  double lift = 0.01;  ///< C_l [-].
  ViscousDrag viscous_drag;
  /// K of bluntness.h in body axes: symmetric, with eigenvalues from 0 to 1 [-].
  Eigen::Matrix3d drag_shape = Eigen::Matrix3d::Identity();
  std::optional<DragCalibration> calibration;  ///< Scales the pressure drag.
};

/// The coefficients of the 2014 thesis: C_p = 0.6316 on both sides, C_l = 0.01, its C_v.
inline Coefficients thesis_coefficients() { return {.pressure_drag = {0.6316, 0.6316}}; }

/// True if the water exerts no load on a body with these coefficients.
inline bool no_load(const Coefficients& c) {
  return !c.buoyancy && c.pressure_drag.none() && c.lift == 0 && c.viscous_drag.none();
}

}  // namespace hydro
