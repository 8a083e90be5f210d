#pragma once

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "engine/ode_handles.h"
#include "engine/spec.h"

namespace engine {

/// Bodies, joints and ground in ODE. Owns all of ODE's objects; a body is an index.
///
/// Bodies come first, then joints and ground. It is used in one of two ways. By itself a step is:
/// apply loads, collide, advance. As the solver of joints and contacts alone (`only_constrain`) it
/// is: set states, collide, then ask `constrained_velocities`.
/// Every call may throw OdeFault; after one out of `advance` or `constrained_velocities`, the world
/// is only fit to be destroyed.
class World {
 public:
  explicit World(double gravity);

  /// Ids count from 0. @throws std::invalid_argument if the description is unphysical.
  BodyId add_body(const BodySpec& spec);
  /// Jointed bodies pass through each other. @throws std::invalid_argument for one without a pair.
  void add_joint(const JointSpec& spec);
  /// @throws std::invalid_argument if it lies out of bounds.
  void add_ground(const Ground& ground);

  /// False if no two things could ever touch of which one moves.
  bool can_collide() const;
  /// Position of the centre of mass, velocities in W.
  hydro::BodyState state(BodyId body) const;
  /// An immovable body has no state to set and stays.
  void set_state(BodyId body, const hydro::BodyState& state);
  /// Adds a load for the next advance: moment about the centre of mass, in W.
  void apply(BodyId body, const hydro::Wrench& load);
  /// Finds the contacts that hold during the next advance over `step` [s].
  void collide(double step);
  /// Moves the bodies over `step` [s] under loads, gravity, joints and contacts; uses up the loads.
  void advance(double step);
  /// Steps in which constraints contradicted each other and were each met in part.
  long compromises() const { return compromises_; }

  /// From now on bodies move only where they are set: no gravity, no motion of their own.
  void only_constrain();
  /// A body as the constraint solver is to take it, moment and velocities about the centre of mass.
  struct Constrained {
    BodyId body = 0;
    hydro::BodyState state;
    double mass = 0;
    Eigen::Matrix3d inertia_B = Eigen::Matrix3d::Identity();
    hydro::Wrench load;  ///< In W.
  };
  /// The velocities in W, linear and angular, that these bodies have after `step` [s] under their
  /// loads, joints, locks and contacts. Nothing moves. May be called by several threads: one after
  /// the other is answered.
  std::vector<hydro::Twist> constrained_velocities(const std::vector<Constrained>& bodies,
                                                   double step);
  /// Groups of bodies that joints or the last contacts hold to each other, to the ground or to what
  /// cannot move; each ascending, in the order of their first body.
  std::vector<std::vector<BodyId>> islands() const;
  /// Greatest depth of the last contacts [m].
  double deepest_contact() const { return deepest_contact_; }
  /// Per body: it is in one of the last contacts.
  std::vector<bool> touching() const;
  /// What the contacts of a body are told of it: how much it resists them [kg], what part of
  /// gravity its weight and the water's lift can speed that up with, and how it would speed up
  /// without contacts, in W [m/s^2].
  void set_contact_inertia(BodyId body, double mass, double fall,
                           const Eigen::Vector3d& acceleration);

 private:
  struct Body {
    dxBody* handle = nullptr;  ///< None if immovable: what it meets is then part of the world.
    dxGeom* geom = nullptr;    ///< None if it passes through everything.
    double mass = 0;           ///< Its own.
    double contact_mass = 0;   ///< What contacts push against.
    double contact_fall = 1;   ///< What that falls with, as a part of gravity.
    hydro::BodyState initial;
    hydro::Wrench load;                           ///< For the next advance.
    std::optional<Eigen::Vector3d> acceleration;  ///< Without contacts; none: by load and gravity.
  };
  struct Shape {
    dxGeom* geom = nullptr;
    Eigen::Vector3d center_B = Eigen::Vector3d::Zero();
  };
  using Pair = std::pair<BodyId, BodyId>;  ///< Ascending; kWorld is the ground.

  void soften_joints(const BodySpec& spec);
  dxBody* create_body(const BodySpec& spec);
  Shape create_shape(const BodySpec& spec);
  dxGeom* create_trimesh(const hydro::TriMesh& mesh);
  void place_geom(Body& body, const Shape& shape);
  void add_lock_motors(dxBody* body, const BodySpec& spec);
  dxBody* handle_of(BodyId body) const;
  dxGeom* geom_of(BodyId body) const;
  void hand_over_loads();
  std::vector<hydro::BodyState> all_states() const;
  void set_all_states(const std::vector<hydro::BodyState>& states);

  /// Iterations of the solver that takes over when the exact one gives up.
  static constexpr int kFallbackIterations = 200;
  /// A step by the iterative solver.
  void iterate(int count, double step);

  bool may_touch(const Pair& pair) const;
  std::vector<Pair> near_pairs() const;
  void join_contacts(const Pair& pair, double step);
  double contact_mass(const Pair& pair) const;
  double contact_fall(const Pair& pair) const;
  Eigen::Vector3d velocity_without_contact(BodyId body, const Eigen::Vector3d& point_W,
                                           double step) const;

  struct CollisionMesh {
    hydro::TriMesh mesh;  ///< ODE reads these arrays for as long as it collides them.
    TriMeshDataHandle data;
  };

  // Members are destroyed in the opposite order: contacts before the world, shapes before meshes.
  double gravity_;
  double lightest_ = std::numeric_limits<double>::infinity();  ///< Least mass or moment of inertia.
  double heaviest_ = 0;                                        ///< Largest mass or moment.
  double unit_ = 1;  ///< What masses, moments and loads are multiplied with for the solver.
  long compromises_ = 0;
  double deepest_contact_ = 0;
  std::vector<std::unique_ptr<CollisionMesh>> meshes_;
  std::unique_ptr<std::mutex> answering_ = std::make_unique<std::mutex>();
  WorldHandle world_;
  SpaceHandle space_;
  JointGroupHandle contacts_;
  std::vector<Body> bodies_;
  std::vector<Pair> jointed_;   ///< Sorted.
  std::vector<Pair> joints_;    ///< With kWorld, of which one at least can move.
  std::vector<Pair> touching_;  ///< Of which one at least can move.
  dxGeom* ground_ = nullptr;
};

}  // namespace engine
