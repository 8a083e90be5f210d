#pragma once

#include <string>
#include <vector>

#include "app/hydrostatics/hydrostatics.h"

/// @file
/// Curves of form: the hydrostatic quantities of a body over the draught, upright or at a fixed
/// trim.
///
/// The waterline is the plane at the height T over the keel amidships, in the middle of the mesh's
/// length, that the trim turns about the y axis there. The keel is the lowest point of the upright
/// mesh, or --keel. Heights are over the keel and along the upright mesh's z axis, lengths along
/// its x axis from the origin of its frame.

namespace app {

/// The quantities at a draught; first `draught`.
using FormRow = std::vector<Quantity>;

/// Righting arms about the keel, KN = GZ + KG sin φ, at one displacement and free to trim.
struct CrossCurve {
  double draught = 0;       ///< Upright [m].
  double displacement = 0;  ///< [kg]
  std::vector<hydro::RightingArm> arms;
};

struct CurvesOfForm {
  std::string body;
  double trim = 0;             ///< [rad], +x end down positive.
  double density = 1000;       ///< Density of the water [kg/m^3].
  double least = 0, most = 0;  ///< Draughts between which the waterline cuts the upright body [m].
  std::vector<FormRow> rows;   ///< Rows of the draughts between these, ascending.
  std::vector<CrossCurve> cross_curves;  ///< One a row, if heels are given.
};

/// @param body       In upright axes.
/// @param draughts   Ascending [m]; those at which the waterline misses the body are left out.
/// @param heels      Heels of the cross curves [rad].
CurvesOfForm curves_of_form(const FloatingBody& body, const std::vector<double>& draughts,
                            double trim, const std::vector<double>& heels);

std::string form_table(const std::vector<CurvesOfForm>& bodies);

/// Returns `{"bodies": {NAME: {"trim_deg": …, "density": …, "curves_of_form": [{…}], "kn":
/// [{…}]}}}`.
std::string form_json(const std::vector<CurvesOfForm>& bodies);

/// Returns CSV with the header `body,draught,quantity,heel_deg,value,unit` and a row per number.
/// Only `kn` has a `heel_deg`.
std::string form_csv(const std::vector<CurvesOfForm>& bodies);

/// Draws the curves of one body as SVG.
std::string form_svg(const CurvesOfForm& curves);

/// Draws the righting arms of bodies over the heel as SVG.
std::string righting_arms_svg(const std::vector<FloatingReport>& reports);

}  // namespace app
