#pragma once

#include <string>

#include "hydro/radiation/radiation_data.h"

namespace app {

/// Draws a body's added mass and damping, of each motion by itself, and its loads of waves over the
/// frequency, those of the heading with the largest load; below, the loads over frequency and
/// heading. Data without headings has no loads.
/// @param density   Density of the water [kg/m^3].
/// @return an SVG picture
std::string radiation_svg(const std::string& body, const hydro::RadiationData& data,
                          double density);

}  // namespace app
