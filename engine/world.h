#pragma once

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "engine/broad_phase.h"
#include "engine/contacts.h"
#include "engine/island_solver.h"
#include "engine/joint_reaction.h"
#include "engine/ode_handles.h"
#include "engine/spec.h"

namespace engine {

/// Bodies, joints and ground in ODE. Owns all of ODE's objects; a body is an index.
///
/// Bodies are added first, then joints and ground. The world takes steps of its own: apply loads,
/// collide, advance. After only_constrain() it solves joints and contacts alone: collide the bodies
/// of a group, then ask for the constrained_motion of its islands. Several threads may do so.
/// Every call may throw OdeFault; after one out of `advance` or `constrained_motion` the world
/// can only be destroyed.
class World {
 public:
  explicit World(double gravity);

  /// Ids count from 0. @throws std::invalid_argument if the description is unphysical.
  /// @param collides   False: nothing else can collide, and the body gets no shape.
  BodyId add_body(const BodySpec& spec, bool collides = true);
  /// Jointed bodies pass through each other. @throws std::invalid_argument for one without a pair.
  void add_joint(const JointSpec& spec);
  /// @throws std::invalid_argument if it lies out of bounds.
  void add_ground(const Ground& ground);
  /// From now on bodies move only by set_state: there is no gravity and no motion of their own.
  void only_constrain();

  /// False if no two shapes, of which one moves, exist.
  bool can_collide() const;
  /// Position of the centre of mass, velocities in W.
  hydro::BodyState state(BodyId body) const;
  /// Sets the state of a movable body.
  void set_state(BodyId body, const hydro::BodyState& state);
  /// Adds a load for the next advance: moment about the centre of mass, in W.
  void apply(BodyId body, const hydro::Wrench& load);

  /// Contacts of some bodies.
  struct Contacts {
    std::vector<Contact> points;
    std::vector<Pair> pairs;  ///< That touch, of which one at least can move; ascending.
  };
  /// Finds the contacts that act in the next advance over `step` [s].
  void collide(double step);
  const Contacts& contacts() const { return contacts_; }
  /// Moves the bodies over `step` [s] under loads, gravity, joints and contacts; uses up the loads.
  /// @return true if constraints contradicted each other and were each met in part.
  bool advance(double step);

  /// The inertia of a body that contacts see.
  struct Inertia {
    double mass = 0;  ///< Mass that resists contacts [kg].
    double fall = 1;  ///< Largest acceleration by weight and lift, over gravity [-].
    Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  ///< Without contacts, in W [m/s^2].
    std::optional<hydro::Matrix6d> matrix_B = {};            ///< M + A, for weights halfway (E12).
  };
  void set_contact_inertia(BodyId body, const Inertia& inertia);

  /// A body where contacts are looked for.
  struct Placed {
    BodyId body = 0;
    hydro::BodyState state;
    Inertia inertia;
  };
  /// Finds the contacts of these pairs, which ascend, for a substep of length `step` [s], with
  /// these bodies in these places and all others where they were.
  Contacts collide(const std::vector<Placed>& bodies, const std::vector<Pair>& pairs, double step);
  /// Depth over closing speed [s] of each point where two bodies, in these places, overlap and
  /// close faster than `slow` [m/s].
  std::vector<double> closing_times(const std::vector<std::pair<BodyId, hydro::BodyState>>& places,
                                    const Pair& pair, double slow);
  /// Wall time of the last two functions so far [s].
  double collision_seconds() const { return collision_seconds_; }

  /// What joints and rows do to the bodies of an island.
  struct ConstrainedMotion : IslandSolution {
    std::vector<JointReaction> reactions;  ///< Of the joints of these bodies.
  };
  /// The motion that the bodies of an island have after `step` [s] under their loads, joints,
  /// locks, these contacts and rows. Nothing moves.
  /// @param bodies   Ascending.
  ConstrainedMotion constrained_motion(const std::vector<SolverBody>& bodies,
                                       const std::vector<Contact>& contacts,
                                       const std::vector<ForceRow>& rows, double step);

  /// Pairs of bodies and kWorld that joints connect, of which one at least can move.
  const std::vector<Pair>& joints() const { return joints_; }
  /// Pairs of indices of bodies, or the number of bodies for the ground, as pairs that may touch:
  /// one can move, and no joint lets them pass through each other. Both are ascending.
  std::vector<Pair> touchable(const std::vector<std::pair<std::size_t, std::size_t>>& pairs) const;
  /// Box around the shape of a body, in B; empty if the body passes through everything.
  const Eigen::AlignedBox3d& shape_box(BodyId body) const;
  /// Box around the ground, in W; empty without ground.
  Eigen::AlignedBox3d ground_box() const;

 private:
  struct Body {
    dxBody* handle = nullptr;     ///< Null if immovable: joints and contacts then see the world.
    dxGeom* geom = nullptr;       ///< Null if it passes through everything.
    Eigen::AlignedBox3d shape_B;  ///< Box around `geom`.
    double mass = 0;
    bool constrained = false;  ///< By joints or locks, which are in `world_`.
    hydro::BodyState initial;
    hydro::Wrench load;  ///< For the next advance.
    Inertia inertia;
  };
  struct Joint {
    std::size_t index;  ///< In the specification.
    BodyId first, second;
    std::unique_ptr<OdeFeedback> feedback;
  };
  struct CollisionMesh {
    hydro::TriMesh mesh;  ///< ODE reads these arrays for as long as it collides them.
    TriMeshDataHandle data;
  };

  JointReaction reaction_of(const Joint& joint) const;
  void soften_joints(const BodySpec& spec);
  dxBody* create_body(const BodySpec& spec);
  void add_shape(Body& body, const BodySpec& spec);
  /// Equal meshes share their data.
  dxGeom* create_trimesh(const hydro::TriMesh& mesh);
  void add_lock_motors(dxBody* body, const BodySpec& spec);
  dxBody* handle_of(BodyId body) const;
  dxGeom* geom_of(BodyId body) const;

  Contacts contacts_of(const std::vector<Pair>& pairs, double step) const;
  std::vector<ContactPoint> touching_points(const Pair& pair, double step) const;
  /// Velocity of the first relative to the second at a point, after a step without contacts.
  Eigen::Vector3d approach(const Pair& pair, const Eigen::Vector3d& point_W, double step) const;
  Eigen::Vector3d velocity_without_contact(BodyId body, const Eigen::Vector3d& point_W,
                                           double step) const;
  /// Weights of one of so many points, whose contact has this mass.
  ContactWeights weights(const Pair& pair, const ContactPoint& point, std::size_t points,
                         double mass, double step) const;

  // Members are destroyed in the opposite order: contacts before the world, shapes before meshes.
  double gravity_;
  double lightest_ = std::numeric_limits<double>::infinity();  ///< Least mass or moment of inertia.
  double heaviest_ = 0;                                        ///< Largest mass or moment.
  double unit_ = 1;  ///< Factor of masses, moments and loads in the solver.
  double collision_seconds_ = 0;
  std::vector<std::unique_ptr<CollisionMesh>> meshes_;
  std::unique_ptr<std::mutex> mutex_ = std::make_unique<std::mutex>();  ///< Of `world_`, `space_`.
  WorldHandle world_;
  SpaceHandle space_;
  JointGroupHandle contact_joints_;  ///< Of the step that is being taken.
  Contacts contacts_;                ///< For the next advance.
  std::unique_ptr<IslandSolver> island_solver_ = std::make_unique<IslandSolver>();
  std::vector<Body> bodies_;
  std::vector<Pair> jointed_;  ///< Pairs of bodies, ascending.
  std::vector<Pair> joints_;
  std::vector<Joint> reacting_;  ///< Joints of which one body at least can move.
  std::size_t joint_count_ = 0;
  dxGeom* ground_ = nullptr;
};

}  // namespace engine
