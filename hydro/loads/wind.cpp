#include "hydro/loads/wind.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "hydro/loads/clip.h"
#include "hydro/loads/panel_loads.h"
#include "hydro/loads/refine.h"

namespace hydro {
namespace {

using Eigen::Vector3d;

/// Distance of points between which a chord departs from waves by kSagTolerance of their standard
/// deviation, in the mean over the phases [m]: (k d)²/8 is the sag of a wave over its amplitude.
double spacing_for_waves(const WaveSurface& waves, double& deviation) {
  double variance = 0, bend = 0;
  for (const WaveComponent& w : waves.components) {
    const double energy = w.amplitude * w.amplitude / 2;
    variance += energy;
    bend += energy * std::pow(w.kx * w.kx + w.ky * w.ky, 2);
  }
  deviation = std::sqrt(variance);
  return bend > 0 ? std::sqrt(8 * kSagTolerance * deviation / std::sqrt(bend)) : HUGE_VAL;
}

/// Heights of waves on a square grid, rows along y: cos(a + b) = cos a cos b − sin a sin b makes
/// them a product of matrices.
Eigen::MatrixXd wave_heights(const WaveSurface& waves, Eigen::Index points, double cell,
                             const Eigen::Vector2d& origin, double time) {
  const auto count = static_cast<Eigen::Index>(waves.components.size());
  Eigen::MatrixXd rows(points, 2 * count), columns(2 * count, points);
  for (Eigen::Index c = 0; c < count; ++c) {
    const WaveComponent& w = waves.components[static_cast<std::size_t>(c)];
    const double start = w.kx * origin.x() + w.ky * origin.y() - w.omega * time + w.phase;
    for (Eigen::Index i = 0; i < points; ++i) {
      const double along = cell * static_cast<double>(i);
      rows(i, 2 * c) = w.amplitude * std::cos(w.ky * along);
      rows(i, 2 * c + 1) = -w.amplitude * std::sin(w.ky * along);
      columns(2 * c, i) = std::cos(start + w.kx * along);
      columns(2 * c + 1, i) = std::sin(start + w.kx * along);
    }
  }
  return amplitude_factor(waves, time) * (rows * columns);
}

/// Waves over a hull as a grid of heights, where that takes fewer heights than the hull's corners.
std::optional<Sea> gridded_waves(const Hull& hull, const BodyState& state, const Sea& sea,
                                 double time) {
  const auto* waves = std::get_if<WaveSurface>(&sea.surface);
  if (!waves) return std::nullopt;
  double deviation = 0;
  const double spacing = spacing_for_waves(*waves, deviation);
  const double across = std::ceil(2 * hull.radius / spacing);
  const double corners = 3 * static_cast<double>(hull.mesh_B.vertex_count());
  if (!((across + 1) * (across + 1) <= corners)) return std::nullopt;
  const auto points = static_cast<Eigen::Index>(std::max(2.0, across + 1));
  const double cell = 2 * hull.radius / static_cast<double>(points - 1);
  const Eigen::Vector2d origin = state.position.head<2>().array() - hull.radius;
  HeightField field =
      make_height_field(wave_heights(*waves, points, cell, origin, time), cell, origin);
  field.deviation = deviation;
  Sea local;
  local.level = sea.level;
  local.surface = std::move(field);
  return local;
}

/// Everything that the sum over the dry faces needs, in W axes about the centre of mass.
struct WindInputs {
  const Hull& hull;
  Eigen::Matrix3d R_WB;
  SurfaceSampler surface;
  bool bends;            ///< The surface may bend over an edge of the hull.
  SurfaceBounds bounds;  ///< Of the surface above the still water [m].
  double above;          ///< Height of the centre of mass above the still water [m].
  Twist motion;          ///< Of the hull in W.
  Wind wind;
  WindProfile profile;
};

enum class BranchPlace { wet, dry, mixed };

BranchPlace place_of(const WindInputs& in, const kernel::Node& node) {
  double middle = in.above, half = 0;
  for (int axis = 0; axis < 3; ++axis) {
    middle += in.R_WB(2, axis) * node.centre[axis];
    half += std::abs(in.R_WB(2, axis)) * node.half[axis];
  }
  if (middle + half <= in.bounds.lowest) return BranchPlace::wet;
  return middle - half >= in.bounds.highest ? BranchPlace::dry : BranchPlace::mixed;
}

/// Visits a dry piece over which the wind is linear, of the given factors at the corners.
template <class Visit>
void visit_linear(const WindInputs& in, const Panel& panel, const Vector3d& factor,
                  const Vector3d& normal, Visit& visit) {
  Vector3d normal_speed;
  for (int i = 0; i < 3; ++i)
    normal_speed[i] = (in.motion.at(panel[i]) - factor[i] * in.wind.velocity).dot(normal);
  visit(panel, normal, normal_speed);
}

/// Visits a dry piece, cut at the nodes of the profile unless its corners are nearly as high.
template <class Visit>
void visit_dry(const WindInputs& in, const Panel& panel, const Vector3d& height,
               const Vector3d& normal, Visit& visit) {
  const WindProfile& profile = in.profile;
  const double lowest = height.minCoeff(), highest = height.maxCoeff();
  const int layer = profile.layer_at(lowest);
  const double top = profile.top(layer);
  if (highest > top && highest <= kUncutRatio * lowest) {
    Vector3d factor;
    for (int i = 0; i < 3; ++i)
      factor[i] = profile.factor_in(height[i] < top ? layer : layer + 1, height[i]);
    return visit_linear(in, panel, factor, normal, visit);
  }
  const auto visit_part = [&](const Panel& part, const Vector3d& part_height) {
    const Vector3d factor(profile.factor_in(layer, part_height[0]),
                          profile.factor_in(layer, part_height[1]),
                          profile.factor_in(layer, part_height[2]));
    visit_linear(in, part, factor, normal, visit);
  };
  if (!(highest > top)) return visit_part(panel, height);
  for (const PanelPart& lower : positive_part(panel, top - height.array()))
    visit_part(lower.panel, top - lower.value.array());
  for (const PanelPart& upper : positive_part(panel, height.array() - top))
    visit_dry(in, upper.panel, top + upper.value.array(), normal, visit);
}

template <class Visit>
void visit_face(const WindInputs& in, int face, Visit& visit) {
  const auto corner = in.hull.mesh_B.faces.col(face);
  Panel panel;
  Vector3d elevation;
  for (int i = 0; i < 3; ++i) {
    panel[i] = in.R_WB * in.hull.mesh_B.vertices.col(corner[i]);
    elevation[i] = in.surface.elevation(panel[i]);
  }
  Vector3d normal;
  const auto visit_piece = [&](const Panel& piece, const Vector3d& piece_elevation) {
    Vector3d height;
    for (int i = 0; i < 3; ++i) height[i] = in.above + piece[i].z() - piece_elevation[i];
    if (height.maxCoeff() <= 0) return;
    if (height.minCoeff() >= 0) return visit_dry(in, piece, height, normal, visit);
    for (const PanelPart& dry : positive_part(piece, height))
      visit_dry(in, dry.panel, dry.value, normal, visit);
  };
  normal = area_vector(panel).normalized();
  if (in.bends)
    for_each_linear_piece(panel, elevation, in.surface, visit_piece);
  else
    visit_piece(panel, elevation);
}

/// Visits the dry part of a hull in pieces over which the normal speed is linear:
/// visit(panel, normal, normal speed at the corners).
/// @param takes_whole   takes_whole(branch) is true for a dry branch that it has dealt with.
template <class TakesWhole, class Visit>
void visit_dry_part(const WindInputs& in, TakesWhole&& takes_whole, Visit&& visit) {
  const std::vector<kernel::Node>& nodes = in.hull.tree.nodes;
  const std::vector<int>& faces = in.hull.panels.face;
  std::size_t i = 0;
  while (i < nodes.size()) {
    const kernel::Node& node = nodes[i];
    const BranchPlace place = place_of(in, node);
    const bool done = place == BranchPlace::wet || (place == BranchPlace::dry && takes_whole(node));
    if (!done && node.leaf()) {
      const std::size_t first = static_cast<std::size_t>(node.first) * kernel::kLeafFaces;
      const std::size_t last = std::min(first + kernel::kLeafFaces, faces.size());
      for (std::size_t k = first; k < last; ++k) visit_face(in, faces[k], visit);
    }
    i = done ? static_cast<std::size_t>(node.next) : i + 1;
  }
}

/// Pressure drag of dry branches in uniform wind, from the moments of tree.h (2).
class BranchDrag {
 public:
  /// @param front, back   ½ρC_p [kg/m^3].
  BranchDrag(const WindInputs& in, double front, double back)
      : uniform_(in.wind.uniform()), R_WB_(in.R_WB), front_(front), back_(back) {
    motion_ << R_WB_.transpose() * (in.motion.linear - in.wind.velocity),
        R_WB_.transpose() * in.motion.angular;
    int k = 0;
    for (int b = 0; b < 6; ++b)
      for (int c = b; c < 6; ++c) square_[k++] = (b == c ? 1 : 2) * motion_[b] * motion_[c];
  }

  /// Adds the drag of a branch whose faces all move into the air, or all out of it.
  bool takes_whole(const kernel::Node& node) {
    if (!uniform_) return false;
    const Eigen::Map<const Vector6d> centre(node.j_centre), half(node.j_half);
    const double speed = centre.dot(motion_);
    if (std::abs(speed) < half.dot(motion_.cwiseAbs())) return false;
    const double factor = speed > 0 ? -front_ : back_;
    for (int k = 0; k < kProducts; ++k)
      for (int a = 0; a < 6; ++a)
        load_B_[a] += factor * square_[k] * node.moment[kernel::kNormal + k][a];
    return true;
  }

  Wrench total() const { return {R_WB_ * load_B_.head<3>(), R_WB_ * load_B_.tail<3>()}; }

 private:
  static constexpr int kProducts = kernel::kMoments - kernel::kNormal;

  bool uniform_;
  Eigen::Matrix3d R_WB_;
  double front_, back_;
  Vector6d motion_;  ///< Relative to the wind, in B.
  double square_[kProducts];
  Vector6d load_B_ = Vector6d::Zero();
};

/// Pressure drag on a piece, cut where the normal speed is zero.
/// @param front, back   ½ρC_p [kg/m^3].
Wrench drag_on(const Panel& panel, const Vector3d& normal, const Vector3d& normal_speed,
               double front, double back) {
  if (normal_speed.minCoeff() >= 0)
    return pressure_drag_load(panel, normal, normal_speed, 1, front);
  if (normal_speed.maxCoeff() <= 0)
    return pressure_drag_load(panel, normal, -normal_speed, -1, back);
  Wrench load;
  for (const PanelPart& part : positive_part(panel, normal_speed))
    load += pressure_drag_load(part.panel, normal, part.value, 1, front);
  for (const PanelPart& part : positive_part(panel, -normal_speed))
    load += pressure_drag_load(part.panel, normal, part.value, -1, back);
  return load;
}

/// Height of the top of the hull's box above the centre of mass [m].
double top_of(const Hull& hull, const BodyState& state) {
  const kernel::Node& root = hull.tree.nodes[0];
  const Vector3d up = state.orientation.conjugate() * Vector3d::UnitZ();
  const Eigen::Map<const Vector3d> centre(root.centre), half(root.half);
  return up.dot(centre) + up.cwiseAbs().dot(half);
}

/// The inputs of the sum over the dry faces; none where there is no load.
/// @param surface   The sea whose surface is taken.
std::optional<WindInputs> wind_inputs(const Hull& hull, const BodyState& state, const Sea& sea,
                                      const Sea& surface, double time) {
  const Wind& wind = sea.air->wind;
  const double above = state.position.z() - sea.level;
  SurfaceBounds bounds = surface_bounds(surface);
  bounds = {bounds.lowest - surface.level, bounds.highest - surface.level};
  const double highest = above + top_of(hull, state) - bounds.lowest;
  if (highest <= 0) return std::nullopt;
  WindInputs in{.hull = hull,
                .R_WB = state.orientation.toRotationMatrix(),
                .surface = SurfaceSampler(surface, state.position, time,
                                          kSmallestPanel * hull.radius, SplitFor::surface),
                .bends = false,
                .bounds = bounds,
                .above = above,
                .motion = {state.linear_velocity, state.angular_velocity},
                .wind = wind,
                .profile = WindProfile(wind, highest)};
  in.bends = in.surface.may_bend(hull.panels.longest_edge);
  return in;
}

/// Calls sum(inputs) where the air may act on a hull.
template <class Sum>
void with_inputs(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                 const Coefficients& coefficients, Sum&& sum) {
  if (!sea.air || coefficients.pressure_drag.none() || hull.tree.nodes.empty()) return;
  if (state.position.z() + hull.radius <= surface_bounds(sea).lowest) return;
  const std::optional<Sea> grid = gridded_waves(hull, state, sea, time);
  if (const auto in = wind_inputs(hull, state, sea, grid ? *grid : sea, time)) sum(*in);
}

}  // namespace

WindProfile::WindProfile(const Wind& wind, double highest) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  if (wind.uniform()) {
    node_[0] = 0, node_[1] = kInfinite, value_[0] = 1, slope_[0] = 0;
    return;
  }
  layers_ = kMostLayers;
  node_[0] = value_[0] = 0;
  const auto gap = [&](double octaves) {
    const double log = octaves * std::log(2);
    return wind.exponent * (1 - wind.exponent) * log * log / 8;
  };
  for (int i = 0; i < kMostLayers; ++i) {
    // H/512, H/128, H/32, H/8, H/(4√2), …, H; the node at H/8 ends layers of both kinds.
    const double octaves = i < 3 ? 9 - 2 * i : 3 - 0.5 * (i - 3);
    const double mean_gap = i < 3 ? gap(2) : i == 3 ? (gap(2) + gap(0.5)) / 2 : gap(0.5);
    const double top = highest * std::exp2(-octaves);
    const double value = wind.factor(top) * (1 + 2 * mean_gap / 3);
    slope_[i] = (value - value_[i]) / (top - node_[i]);
    if (i + 1 < kMostLayers) value_[i + 1] = value;
    node_[i + 1] = i + 1 < kMostLayers ? top : kInfinite;
  }
}

Wrench wind_load(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                 const Coefficients& coefficients) {
  Wrench load;
  with_inputs(hull, state, sea, time, coefficients, [&](const WindInputs& in) {
    const double front = 0.5 * sea.air->density * coefficients.pressure_drag.front;
    const double back = 0.5 * sea.air->density * coefficients.pressure_drag.back;
    BranchDrag branches(in, front, back);
    visit_dry_part(
        in, [&](const kernel::Node& node) { return branches.takes_whole(node); },
        [&](const Panel& panel, const Vector3d& normal, const Vector3d& normal_speed) {
          load += drag_on(panel, normal, normal_speed, front, back);
        });
    load = drag_scale(coefficients, state, in.wind.velocity) * (load + branches.total());
  });
  return load;
}

Matrix6d wind_jacobian(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                       const Coefficients& coefficients) {
  Matrix6d sum = Matrix6d::Zero();
  with_inputs(hull, state, sea, time, coefficients, [&](const WindInputs& in) {
    const double scale = sea.air->density * drag_scale(coefficients, state, in.wind.velocity);
    visit_dry_part(
        in, [](const kernel::Node&) { return false; },
        [&](const Panel& panel, const Vector3d& normal, const Vector3d& normal_speed) {
          const double third = area_vector(panel).norm() / 3;
          for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3;
            const double v_n = (normal_speed[i] + normal_speed[j]) / 2;
            const PressureDrag& drag = coefficients.pressure_drag;
            const double C_p = v_n > 0 ? drag.front : drag.back;
            Vector6d b;
            b << normal, Vector3d((panel[i] + panel[j]) / 2).cross(normal);
            sum.noalias() -= scale * C_p * std::abs(v_n) * third * b * b.transpose();
          }
        });
  });
  return sum;
}

}  // namespace hydro
