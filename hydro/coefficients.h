#pragma once

namespace hydro {

/// C_v as a function of the local tangential speed.
struct ViscousDrag {
  enum class Law {
    none,      ///< 0 everywhere; nothing is computed.
    constant,  ///< `coefficient` everywhere.
    thesis     ///< 0.1 below 1 m/s, 0.2 − 0.1·v/(m/s) from 1 to 2 m/s, 0 above.
  };
  Law law = Law::thesis;
  double coefficient = 0;  ///< For `constant` [-].
};

/// The coefficients of the loads on a body. Zero switches a load off: it is not computed.
struct Coefficients {
  bool buoyancy = true;
  double pressure_drag = 0.6316;  ///< C_p [-].
  double lift = 0.01;             ///< C_l [-].
  ViscousDrag viscous_drag;       ///< C_v.
};

}  // namespace hydro
