#include "hydro/loads/plain_loads.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "hydro/airy_waves.h"
#include "hydro/loads/clip.h"
#include "hydro/loads/panel_loads.h"
#include "hydro/loads/point_rules.h"
#include "hydro/loads/refine.h"
#include "hydro/loads/viscous_drag.h"
#include "hydro/parallel.h"

namespace hydro {
namespace {

/// Faces summed as one piece of work. Pieces are added in their order, so the sum does not depend
/// on the number of threads.
constexpr Eigen::Index kFacesAPiece = 1024;

/// Everything that the sum over the panels needs, with the vertices in W axes about the centre of
/// mass.
struct PlainInputs {
  const Hull& hull;
  const Sea& sea;
  const Coefficients& coefficients;
  SurfaceSampler surface;
  AiryWaves waves;
  Eigen::Vector3d p_WB;       ///< The centre of mass [m].
  Eigen::Matrix3Xd r;         ///< 3×V [m].
  Eigen::VectorXd elevation;  ///< Elevation of the surface over each vertex, above the level [m].
  Twist motion;               ///< Relative to the current.
  Eigen::Matrix3d shape;      ///< K of bluntness.h, in W.
  double level;               ///< Level of the still water above the centre of mass [m].
  bool moving;                ///< Relative to the water.

  bool airy() const { return waves.moves(); }
};

PlainInputs immerse(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                    const Coefficients& coefficients, const LoadAccuracy& how,
                    SplitFor what = SplitFor::current) {
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  PlainInputs in{.hull = hull,
                 .sea = sea,
                 .coefficients = coefficients,
                 .surface = SurfaceSampler(sea, state.position, time, kSmallestPanel * hull.radius,
                                           what, head_error(hull, how)),
                 .waves = AiryWaves(sea, time),
                 .p_WB = state.position,
                 .r = R_WB * hull.mesh_B.vertices,
                 .elevation = Eigen::VectorXd::Zero(hull.mesh_B.vertex_count()),
                 .motion = {state.linear_velocity - sea.current, state.angular_velocity},
                 .shape = R_WB * coefficients.drag_shape * R_WB.transpose(),
                 .level = sea.level - state.position.z(),
                 .moving = false};
  in.moving = in.airy() || !in.motion.linear.isZero(0) || !in.motion.angular.isZero(0);
  if (in.surface.flat()) return in;
  parallel_for(static_cast<std::size_t>(in.r.cols()),
               [&](std::size_t i) { in.elevation[i] = in.surface.elevation(in.r.col(i)); });
  return in;
}

/// The water at the corners of a wet panel.
struct CornerWater {
  Eigen::Vector3d head;                                ///< p/(ρg) but for a constant [m].
  Eigen::Matrix3d velocity = Eigen::Matrix3d::Zero();  ///< Relative to the current [m/s].
};

/// The water at the corners of a panel at given depths. `constant` is what depths under `below`
/// miss of the true ones.
CornerWater water_at_corners(const PlainInputs& in, const Panel& panel,
                             const Eigen::Vector3d& depth, double constant) {
  CornerWater water{.head = depth};
  if (!in.airy()) return water;
  for (int i = 0; i < 3; ++i) {
    const double s = depth[i] + constant;
    const WaterMotion at = in.waves.at(in.p_WB + panel[i], s);
    water.head[i] += at.head - s;
    water.velocity.col(i) = at.velocity - in.sea.current;
  }
  return water;
}

/// Pressure drag on a panel, cut where v·n is zero.
Wrench pressure_drag_on(const Panel& panel, const Eigen::Vector3d& normal,
                        const Eigen::Vector3d& normal_speed, const PressureDrag& drag,
                        double half_density) {
  Wrench load;
  for (const PanelPart& front : positive_part(panel, normal_speed))
    load += pressure_drag_load(front.panel, normal, front.value, 1, half_density * drag.front);
  for (const PanelPart& back : positive_part(panel, -normal_speed))
    load += pressure_drag_load(back.panel, normal, back.value, -1, half_density * drag.back);
  return load;
}

/// Drag and lift on a wet panel of the given unit normal. Viscous drag takes the mean of the
/// water's velocity over the panel.
void add_motion_loads(const PlainInputs& in, const Panel& panel, const Eigen::Vector3d& normal,
                      const Eigen::Matrix3d& water, Loads& loads) {
  const double half_density = 0.5 * in.sea.density;
  const PressureDrag& drag = in.coefficients.pressure_drag;
  Eigen::Matrix3d velocity;
  for (int i = 0; i < 3; ++i) velocity.col(i) = in.motion.at(panel[i]) - water.col(i);
  if (!drag.none()) {
    Eigen::Vector3d normal_speed;
    for (int i = 0; i < 3; ++i)
      normal_speed[i] = normal.dot(in.shape * (in.motion.linear - water.col(i)) +
                                   in.motion.angular.cross(panel[i]));
    loads.pressure_drag += pressure_drag_on(panel, normal, normal_speed, drag, half_density);
  }
  if (in.coefficients.lift != 0)
    loads.lift += lift_load(panel, normal, velocity, half_density * in.coefficients.lift);
  if (!in.coefficients.viscous_drag.none()) {
    const Twist motion{in.motion.linear - water.rowwise().mean(), in.motion.angular};
    loads.viscous_drag +=
        viscous_drag_load(panel, normal, motion, in.coefficients.viscous_drag, half_density);
  }
}

/// All loads on a wet panel with the given depths at its vertices.
void add_wet_panel(const PlainInputs& in, const Panel& panel, const Eigen::Vector3d& depth,
                   double constant, const Eigen::Vector3d& normal, Loads& loads) {
  const CornerWater water = water_at_corners(in, panel, depth, constant);
  loads.buoyancy += pressure_load(panel, water.head);
  loads.displaced_volume += pressure_load(panel, depth).force.z();
  loads.wetted_area += area_vector(panel).norm();
  if (in.moving) add_motion_loads(in, panel, normal, water.velocity, loads);
}

/// Adds the load of a traction at a point of a panel, along its normal.
void add_traction(const Eigen::Vector3d& r, const Eigen::Vector3d& load, Wrench& sum) {
  sum += {load, r.cross(load)};
}

/// All loads on a wet panel over which the water is not linear, by a rule of points.
template <class Rule>
void add_curved_panel(const PlainInputs& in, const Panel& panel, double below,
                      const Eigen::Vector3d& normal, const Rule& rule, Loads& loads) {
  const double area = area_vector(panel).norm(), half_density = 0.5 * in.sea.density;
  const Coefficients& law = in.coefficients;
  Eigen::Vector3d mean_water = Eigen::Vector3d::Zero();
  loads.wetted_area += area;
  for (const TrianglePoint& point : rule) {
    const Eigen::Vector3d r = point_of(panel, point);
    const double part = point.weight * area, rise = in.surface.elevation(r) - r.z();
    const WaterMotion at = in.waves.at(in.p_WB + r, in.level + rise);
    const Eigen::Vector3d water = at.velocity - in.sea.current;
    const Eigen::Vector3d velocity = in.motion.at(r) - water;
    const double head = at.head - (in.level - below);
    add_traction(r, -part * head * normal, loads.buoyancy);
    loads.displaced_volume -= part * (below + rise) * normal.z();
    const double v_n =
        normal.dot(in.shape * (in.motion.linear - water) + in.motion.angular.cross(r));
    const double C_p = v_n > 0 ? law.pressure_drag.front : law.pressure_drag.back;
    add_traction(r, -part * half_density * C_p * v_n * std::abs(v_n) * normal, loads.pressure_drag);
    const double v_t2 = velocity.squaredNorm() - std::pow(velocity.dot(normal), 2);
    add_traction(r, -part * half_density * law.lift * v_t2 * normal, loads.lift);
    mean_water += point.weight * water;
  }
  if (!law.viscous_drag.none())
    loads.viscous_drag +=
        viscous_drag_load(panel, normal, {in.motion.linear - mean_water, in.motion.angular},
                          law.viscous_drag, half_density);
}

/// One face, split where the surface bends over it and cut at the waterline. `below` is what the
/// depth of a point at z = 0 over flat water is taken as.
void add_face(const PlainInputs& in, Eigen::Index face, double below, bool all_wet, Loads& loads) {
  const auto vertex = in.hull.mesh_B.faces.col(face);
  const Panel panel = {in.r.col(vertex[0]), in.r.col(vertex[1]), in.r.col(vertex[2])};
  const Eigen::Vector3d elevation(in.elevation[vertex[0]], in.elevation[vertex[1]],
                                  in.elevation[vertex[2]]);
  const Eigen::Vector3d normal = area_vector(panel).normalized();
  const bool curved = in.surface.curves(panel);
  const auto add_piece = [&](const Panel& piece, const Eigen::Vector3d& piece_elevation) {
    Eigen::Vector3d depth;
    for (int i = 0; i < 3; ++i) depth[i] = below + (piece_elevation[i] - piece[i].z());
    const double constant = in.level - below;
    const auto add_wet = [&](const Panel& wet, const Eigen::Vector3d& wet_depth) {
      if (curved)
        return in.surface.with_rule(piece, [&](const auto& rule) {
          add_curved_panel(in, wet, below, normal, rule, loads);
        });
      add_wet_panel(in, wet, wet_depth, constant, normal, loads);
    };
    if (all_wet) return add_wet(piece, depth);
    for (const PanelPart& wet : positive_part(piece, depth)) add_wet(wet.panel, wet.value);
  };
  if (curved)
    for_each_curved_piece(panel, elevation, in.level, all_wet, in.surface, add_piece);
  else
    for_each_linear_piece(panel, elevation, in.surface, add_piece);
}

/// The sum over all faces, piece by piece.
Loads sum_faces(const PlainInputs& in, double below, bool all_wet) {
  const Eigen::Index faces = in.hull.mesh_B.face_count();
  std::vector<Loads> pieces((faces + kFacesAPiece - 1) / kFacesAPiece);
  parallel_for(pieces.size(), [&](std::size_t piece) {
    const Eigen::Index begin = static_cast<Eigen::Index>(piece) * kFacesAPiece;
    const Eigen::Index end = std::min(begin + kFacesAPiece, faces);
    for (Eigen::Index face = begin; face < end; ++face)
      add_face(in, face, below, all_wet, pieces[piece]);
  });
  Loads sum;
  for (const Loads& piece : pieces) sum += piece;
  return sum;
}

/// Height over the body's radius up to which no wind by a power law acts here [-].
constexpr double kStill = 1e-5;

/// The drag of the air on a dry panel with the given heights above the water at its corners. By a
/// power law it is summed at six points of layers, the lower end of each at half of its height.
void add_dry_panel(const PlainInputs& in, const Panel& panel, const Eigen::Vector3d& height,
                   const Eigen::Vector3d& normal, Wrench& sum) {
  const Wind& wind = in.sea.air->wind;
  const double half_density = 0.5 * in.sea.air->density, half = height.maxCoeff() / 2;
  const PressureDrag& drag = in.coefficients.pressure_drag;
  const auto speed = [&](const Eigen::Vector3d& r, double z) {
    return (in.motion.at(r) + in.sea.current - wind.factor(z) * wind.velocity).dot(normal);
  };
  if (wind.uniform()) {
    const Eigen::Vector3d v_n(speed(panel[0], 0), speed(panel[1], 0), speed(panel[2], 0));
    sum += pressure_drag_on(panel, normal, v_n, drag, half_density);
  } else if (height.minCoeff() >= half) {
    for (const TrianglePoint& point : kSixPoints) {
      const Eigen::Vector3d r = point_of(panel, point);
      const double z = Eigen::Map<const Eigen::Vector3d>(point.at).dot(height), v_n = speed(r, z);
      const double part = point.weight * area_vector(panel).norm() * half_density;
      const double C_p = v_n > 0 ? drag.front : drag.back;
      add_traction(r, -part * C_p * v_n * std::abs(v_n) * normal, sum);
    }
  } else if (half > kStill * in.hull.radius) {
    for (const PanelPart& upper : positive_part(panel, height.array() - half))
      add_dry_panel(in, upper.panel, upper.value.array() + half, normal, sum);
    for (const PanelPart& lower : positive_part(panel, half - height.array()))
      add_dry_panel(in, lower.panel, half - lower.value.array(), normal, sum);
  }
}

}  // namespace

Wrench plain_wind(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                  const Coefficients& coefficients) {
  const PlainInputs in = immerse(hull, state, sea, time, coefficients, {}, SplitFor::surface);
  Wrench sum;
  for (Eigen::Index face = 0; face < hull.mesh_B.face_count(); ++face) {
    const auto vertex = hull.mesh_B.faces.col(face);
    const Panel panel = {in.r.col(vertex[0]), in.r.col(vertex[1]), in.r.col(vertex[2])};
    const Eigen::Vector3d elevation(in.elevation[vertex[0]], in.elevation[vertex[1]],
                                    in.elevation[vertex[2]]);
    const Eigen::Vector3d normal = area_vector(panel).normalized();
    for_each_linear_piece(panel, elevation, in.surface,
                          [&](const Panel& piece, const Eigen::Vector3d& at) {
                            Eigen::Vector3d height;
                            for (int i = 0; i < 3; ++i) height[i] = piece[i].z() - in.level - at[i];
                            for (const PanelPart& dry : positive_part(piece, height))
                              add_dry_panel(in, dry.panel, dry.value, normal, sum);
                          });
  }
  return drag_scale(coefficients, state, sea.air->wind.velocity) * sum;
}

Loads plain_loads(const Hull& hull, const BodyState& state, const Sea& sea, double time,
                  const Coefficients& coefficients, const LoadAccuracy& how) {
  const SurfaceBounds bounds = surface_bounds(sea);
  if (state.position.z() - hull.radius >= bounds.highest) return {};
  const std::optional<Sea> felt = without_weak_waves(sea, head_error(hull, how));
  const PlainInputs in = immerse(hull, state, felt ? *felt : sea, time, coefficients, how);
  if (in.r.row(2).minCoeff() + state.position.z() >= bounds.highest) return {};
  // A constant added to the depth changes nothing on a closed surface. Depths of a wholly submerged
  // one are taken from the level of the centre of mass, so that a deep body loses no digits.
  const bool all_wet = in.r.row(2).maxCoeff() + state.position.z() < bounds.lowest;
  const bool shifted = all_wet && hull.boundary == Hull::Boundary::closed;
  Loads loads = sum_faces(in, shifted ? 0 : in.level, all_wet);
  loads.pressure_drag.force = in.shape * loads.pressure_drag.force;
  loads.pressure_drag =
      drag_scale(coefficients, state, current_at(sea, state.position.z())) * loads.pressure_drag;
  loads.buoyancy = (coefficients.buoyancy ? sea.density * sea.gravity : 0) * loads.buoyancy;
  return loads;
}

}  // namespace hydro
