#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/base/constants.h"
#include "engine/base/rig_spec.h"
#include "hydro/added_mass/added_mass_model.h"
#include "hydro/interior/interior.h"
#include "hydro/loads/loads.h"
#include "hydro/radiation/floating_body.h"
#include "hydro/resistance/resistance.h"
#include "hydro/water/hull_sources.h"

/// @file
/// The constant description of a simulation, complete and already checked. SI units.

namespace engine {

/// The shape by which a body touches other bodies and the ground.
enum class CollisionShape {
  none,    ///< It passes through everything.
  mesh,    ///< Its own triangles.
  box,     ///< The axis-aligned box around its mesh, in B.
  sphere,  ///< The smallest sphere about the centre of the mesh's bounding box that contains it.
};

/// Degrees of freedom of a body in world axes: x, y, z, roll, pitch, yaw.
using DofMask = std::array<bool, 6>;
/// All degrees of freedom.
inline constexpr DofMask kAllDofs = {true, true, true, true, true, true};

/// sin(2π·frequency·t + phase)
struct Sine {
  double frequency = 0;  ///< [Hz]
  double phase = 0;      ///< [rad]
};

/// A load given by the scene: constant or sinusoidal, between two times.
struct AppliedLoad {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();       ///< [N]
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();      ///< [N m]
  bool in_body_frame = false;                            ///< Force and torque turn with the body.
  Eigen::Vector3d at_B = Eigen::Vector3d::Zero();        ///< Where the force acts, in B [m].
  double start = 0;                                      ///< [s], inclusive.
  double end = std::numeric_limits<double>::infinity();  ///< [s], exclusive.
  std::optional<Sine> sine;                              ///< Multiplies the load.
  std::optional<SetPointId> factor;                      ///< Multiplies the load by this set point.
};

/// A hole through which water runs between the two spaces on its sides: the sea or pockets.
struct Opening {
  Eigen::Vector3d at_B = Eigen::Vector3d::Zero();  ///< Its centre, near the wall that it is in [m].
  double area = 0;                                 ///< [m^2]
  double discharge = 0.6;                          ///< Coefficient of discharge [-].
};

/// A pump that brings water from one space to another: a pocket of its body, or the sea
/// (flooding.h).
struct PumpSpec {
  Eigen::Vector3d from_B = Eigen::Vector3d::Zero();  ///< Its suction; in no pocket: in the sea [m].
  std::optional<Eigen::Vector3d> to_B;  ///< Its outlet in a pocket [m]; none: into the sea.
  SetPointId rate = 0;                  ///< Q₀, its flow without a lift [m^3/s].
  double head = std::numeric_limits<double>::infinity();  ///< H₀, the lift without a flow [m].
};

/// Water in a pocket at time 0.
struct WaterAtStart {
  Eigen::Vector3d at_B = Eigen::Vector3d::Zero();  ///< A point above the pocket's surface [m].
  double volume = 0;                               ///< [m^3]
};

/// The behaviour of water in the pockets of a body (hydro/interior).
enum class Interior {
  wet,      ///< All of its surface is in the sea, without pockets.
  dry,      ///< The pockets of its start are closed by lids.
  flooding  ///< They are dry until water comes in.
};

/// A rigid body. B has its origin in the centre of mass and the axes of the mesh file.
struct BodySpec {
  std::string name;       ///< Unique among the bodies.
  hydro::TriMesh mesh_B;  ///< Its surface for water and contacts.
  /// The hull that the water sees, shared by simulations of one body (hulls.h); null: the
  /// simulation makes its own.
  std::shared_ptr<const hydro::Hull> hull;
  double mass = 0;                                          ///< [kg], > 0.
  Eigen::Matrix3d inertia_B = Eigen::Matrix3d::Identity();  ///< About the centre of mass [kg m^2].
  hydro::BodyState initial;                                 ///< Pose and velocity at time 0.
  hydro::Coefficients coefficients;  ///< `hydro::for_mesh` completes them from the mesh.
  hydro::LoadAccuracy summation;     ///< Accuracy of the sums of its loads.
  std::shared_ptr<const hydro::AddedMassModel> added_mass;  ///< Null: the body has none.
  /// The waves that the body makes and scatters; null: none. `added_mass` is then not null, as a
  /// rule the same object.
  std::shared_ptr<const hydro::FloatingBody> radiation;
  /// Its sources in simulated water; null: it has none. `radiation` is then its A∞ and what it
  /// scatters at once, without a memory of its own.
  std::shared_ptr<const hydro::HullSources> sources;
  /// Along its motion, beside the drag of its panels; null: none.
  std::shared_ptr<const hydro::Resistance> resistance;
  bool wet = true;                           ///< False: the water has no effect on it.
  Interior interior = Interior::wet;         ///< Water in its pockets.
  bool air = false;                          ///< Its voids trap their air (trapped_air.h).
  std::vector<Opening> openings;             ///< Holes in its walls.
  std::vector<PumpSpec> pumps;               ///< Pumps of its pockets.
  std::vector<WaterAtStart> interior_water;  ///< Water in its pockets at time 0.
  /// The pockets of the start, shared by bodies and simulations; null: no pockets, or not found
  /// yet.
  std::shared_ptr<const hydro::Interior> pockets;
  /// The mesh with the pockets of the start closed by lids; none without pockets.
  std::optional<hydro::TriMesh> closed_mesh_B;
  CollisionShape collision = CollisionShape::mesh;  ///< Shape in contacts.
  double friction = kFriction;  ///< Coulomb's µ of its surface [-], >= 0 (contact_surfaces.h).
  double restitution = 0;       ///< Coefficient of restitution of its surface [-], 0 … 1.
  DofMask locked = {};          ///< They keep their initial value; all six make the body immovable.
  std::vector<AppliedLoad> loads;  ///< Loads besides those of water, air and gravity.
};

/// The surface of a body as the sea outside sees it at the start.
inline const hydro::TriMesh& outside_B(const BodySpec& body) {
  return body.closed_mesh_B && body.interior != Interior::wet ? *body.closed_mesh_B : body.mesh_B;
}

/// The pockets of a body with this vertical; null without. Those of the start are at hand.
inline std::shared_ptr<const hydro::Interior> pockets_at(const BodySpec& body,
                                                         const Eigen::Vector3d& up_B) {
  const bool at_hand = body.pockets && body.pockets->up_B == up_B;
  return at_hand ? body.pockets : hydro::make_interior(body.mesh_B, up_B);
}

/// A joint between two bodies, or a body and the world. The poses at time 0 fulfil it.
struct JointSpec {
  /// Motions that are free: ball, all turns; hinge, a turn about the axis; slider, a motion along
  /// it; fixed, none; universal, turns about both axes.
  enum class Type { ball, hinge, slider, fixed, universal };
  std::string name;                                    ///< Unique among the joints.
  Type type = Type::ball;                              ///< Kind of the joint.
  BodyId first = kWorld;                               ///< A body, or kWorld.
  BodyId second = kWorld;                              ///< A body, or kWorld.
  Eigen::Vector3d anchor_W = Eigen::Vector3d::Zero();  ///< At time 0 [m]; unused by slider, fixed.
  /// Unit, at time 0; hinge, slider, universal.
  Eigen::Vector3d axis_W = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d axis2_W = Eigen::Vector3d::UnitX();  ///< Unit, normal to axis_W; universal.
  JointDrive drive = {};                               ///< Drive of a hinge or slider.
};

/// The sea floor or shore: a horizontal plane or a mesh in W, whose faces look up.
struct PlaneGround {
  double z = 0;  ///< [m]
};
/// A ground of triangles.
struct MeshGround {
  hydro::TriMesh mesh_W;  ///< Its faces look up.
};
/// The ground; `monostate`: there is none.
using Ground = std::variant<std::monostate, PlaneGround, MeshGround>;

/// The suction by which a soft bed holds what lies on it (contacts/bed_suction.h).
struct BedSuction {
  double pressure = 0;  ///< Largest fall of pressure below a body [Pa], >= 0.
  double time = 1;      ///< T of (E41) [s], > 0.
};

/// Friction and restitution of one pair of bodies, in place of the values that follow from the
/// bodies' own.
struct ContactSpec {
  BodyId first = kWorld;              ///< kWorld is the ground.
  BodyId second = kWorld;             ///< The other body.
  std::optional<double> friction;     ///< Coulomb's µ [-], >= 0.
  std::optional<double> restitution;  ///< [-], 0 … 1.
};

/// The time integration.
struct Integrator {
  /// The scheme of a step.
  enum class Method {
    split,  ///< Inertia, loads and constraints in turn, with added mass; second order.
    ode     ///< ODE's own step without added mass, of first order, for comparison.
  };
  Method method = Method::split;  ///< Scheme of a step.
  /// Largest error of a free body's pose in a second, over its radius and in rad; substeps are
  /// shortened for it. 0: error is not controlled.
  double tolerance = 0;
};

/// The grid of simulated water.
struct WaterGrid {
  hydro::PeriodicSquare square;  ///< Cells, depth and gravity of the grid.
  double edge = 0;               ///< Width of its damped edge [m]; 0: a fifth of its side.
};

/// Everything that a Simulation is made from.
struct SimulationSpec {
  Integrator integrator;               ///< The time integration.
  double step = 1.0 / 60;              ///< [s], > 0.
  double gravity = 9.80665;            ///< Along −z [m/s^2].
  std::optional<hydro::Sea> sea;       ///< None: a dry scene.
  std::optional<WaterGrid> water;      ///< None: bodies do not feel each other's waves.
  Ground ground;                       ///< Sea floor or shore.
  double ground_friction = kFriction;  ///< Coulomb's µ of the ground [-], >= 0.
  double ground_restitution = 0;       ///< Coefficient of restitution of the ground [-], 0 … 1.
  std::optional<BedSuction> suction;   ///< None: the ground holds nothing that is pulled.
  std::vector<BodySpec> bodies;        ///< A BodyId is an index in these.
  std::vector<JointSpec> joints;       ///< Joints between bodies.
  std::vector<LineSpec> lines;         ///< Springs, then ropes, then moorings.
  std::vector<PropellerSpec> propellers;  ///< Propellers and thrusters.
  std::vector<FoilSpec> foils;            ///< Rudders, fins, keels and sails.
  std::vector<SetPointSpec> set_points;   ///< A SetPointId is an index in these.
  std::vector<ControlSpec> controls;      ///< Each set point is in at most one.
  std::vector<ContactSpec> contacts;      ///< Each pair at most once.
  int threads = 1;                        ///< At most this many; results do not depend on it.
  bool record_work = false;               ///< Keep impulses and works, for Simulation::forces.
};

}  // namespace engine
