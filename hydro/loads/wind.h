#pragma once

#include <array>

#include "hydro/loads/loads.h"

/// @file
/// The load of the air on the dry part of a hull.
///
/// It is pressure drag as in the water, with the density of the air, the coefficients C_p of the
/// body, K = 1 for all bodies (bluntness.h: what stands above the water is mostly blunt) and the
/// velocity v = v_0 + ω × r − U(z) relative to the wind,
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

/// The power law of a wind, up to a height H, as a piecewise linear function of the height: (1) has
/// a closed form where triangles are cut at its nodes.
///
/// Between heights a factor q apart the concave (z/h)^α lies above its chord by 2/3 of the gap
/// α (1 − α) (ln q)² / 8 of itself in the mean, and by the gap at most, to leading order. So the
/// values at the nodes are raised by 2/3 of the gap: the chords are right in the mean. Nodes are a
/// factor √2 apart from H down to H/8, with a gap of 0.15 % for α = 0.11 and 0.4 % for any α, then
/// a factor 4 down to H/512, and the last one is 0 at the surface. What is below H/8 has a part
/// 8^(−1 − 2α) of the force on a wall of the height H, and a gap 16 times as large.
class WindProfile {
 public:
  /// @param highest   H [m], > 0.
  WindProfile(const Wind& wind, double highest);

  /// Speed at a height 0 … H over that at the wind's own height [-].
  double factor(double height) const { return factor_in(layer_at(height), height); }

  /// The same in a given layer.
  double factor_in(int layer, double height) const {
    return value_[layer] + slope_[layer] * (height - node_[layer]);
  }

  /// Index of the layer whose lower end is the highest node at or below `height`.
  int layer_at(double height) const {
    int layer = layers_ - 1;
    while (layer > 0 && height < node_[layer]) --layer;
    return layer;
  }

  /// Height of the upper end of a layer; the last one has none [m].
  double top(int layer) const { return node_[layer + 1]; }

 private:
  static constexpr int kMostLayers = 10;

  int layers_ = 1;
  std::array<double, kMostLayers + 1> node_ = {};  ///< Lower ends of the layers [m], and infinity.
  std::array<double, kMostLayers> value_ = {};     ///< Factor at the lower end of each layer.
  std::array<double, kMostLayers> slope_ = {};     ///< Change of the factor with the height [1/m].
};

/// Ratio of the heights of a piece's corners up to which it is not cut at the nodes: the velocity
/// is linear between them, with an error as between nodes [-].
inline constexpr double kUncutRatio = 1.4142135623730951;

/// The load of the air of `sea` on the dry part of a hull, (1): the moment is about the centre of
/// mass, in W. Without air it is zero.
///
/// In uniform wind over flat water it is exact to round-off; by the power law of the exponent 0.11
/// it is within 0.3 % on a wall. The surface of waves is that of a grid around the body, which
/// departs from them as far as panels do that are not split (refine.h).
/// A calibration of the drag scales it as for a body that moves in the direction of the wind.
Wrench wind_load(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                 const Coefficients& coefficients);

/// ∂F/∂u of (1) with respect to the velocity of the hull, as load_jacobian.h (1).
Matrix6d wind_jacobian(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                       const Coefficients& coefficients);

}  // namespace hydro
