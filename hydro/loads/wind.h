#pragma once

#include <vector>

#include "hydro/loads/loads.h"

/// @file
/// The load of the air on the dry part of a hull.
///
/// It is pressure drag as in the water, with the density of the air, the coefficients C_p of the
/// body and the velocity v = v_0 + ω × r − U(z) relative to the wind,
///
///     F = −½ρ ∫_dry C_p v_n |v_n| n dS,                                                      (1)
///
/// in closed form (panel_loads.h): triangles are cut at the waterline as in the water, and each
/// piece again at v_n = 0. Friction is left out: that of a smooth plate in air, about 0.003, is
/// less than 1 % of C_p. So are lift, the weight of the displaced air and its added mass, each
/// about 1/800 of the water's.
///
/// The height z of the wind's profile is that above the water at the instant, right below or above
/// the point: it is linear over the dry pieces and zero on their waterline.

namespace hydro {

/// The power law of a wind as a piecewise linear function of the height, so that (1) has a closed
/// form where triangles are cut at its nodes.
///
/// Nodes are a factor √2 apart. Between them a concave function (z/h)^α lies above its chord by
/// α (1 − α) (ln √2)² / 8 of itself at most, to leading order: 0.15 % for α = 0.11, 0.4 % for any
/// exponent. Below the first node the profile falls linearly to 0.
class WindProfile {
 public:
  /// @param lowest    The first node is at most this high above the water [m], > 0.
  /// @param highest   The profile is defined up to this height [m].
  WindProfile(const Wind& wind, double lowest, double highest);

  /// Speed at a height above the water over that at the wind's own height [-].
  double factor(double height) const;

  /// Speed at a height of the given layer, as above.
  double factor_in(std::size_t layer, double height) const {
    return value_[layer] + slope_[layer] * (height - node_[layer]);
  }

  /// Index of the layer whose bottom is the highest node at or below `height` >= 0.
  std::size_t layer_at(double height) const;

  /// Height of the upper end of a layer [m]; the last one has none.
  double top(std::size_t layer) const { return node_[layer + 1]; }

 private:
  std::vector<double> node_;   ///< Heights of the lower ends of the layers, and an infinite one.
  std::vector<double> value_;  ///< Factor at the lower end of each layer.
  std::vector<double> slope_;  ///< Change of the factor with the height in each layer [1/m].
};

/// Height of the profile's first node over the hull's radius, at most [-]. A body as high as its
/// radius gets 0.01 % too little of a wind's force there, one of a tenth of it 0.15 %.
inline constexpr double kLowestWindNode = 1e-3;

/// The load of the air of `sea` on the dry part of a hull, (1): the moment is about the centre of
/// mass, in W. Without air it is zero.
///
/// In uniform wind over flat water it is exact to round-off. Under waves the surface is that of a
/// grid around the body, which departs from it as far as panels do that are not split (refine.h).
/// A calibration of the drag scales it as for a body that moves in the direction of the wind.
Wrench wind_load(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                 const Coefficients& coefficients);

/// ∂F/∂u of (1) with respect to the velocity of the hull, as load_jacobian.h (1).
Matrix6d wind_jacobian(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                       const Coefficients& coefficients);

}  // namespace hydro
