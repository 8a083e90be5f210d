#pragma once

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "engine/broad_phase.h"
#include "engine/contacts.h"
#include "engine/island_solver.h"
#include "engine/ode_handles.h"
#include "engine/spec.h"

namespace engine {

/// Bodies, joints and ground in ODE. Owns all of ODE's objects; a body is an index.
///
/// Bodies come first, then joints and ground. It is used in one of two ways. By itself a step is:
/// apply loads, collide, advance. As the solver of joints and contacts alone (`only_constrain`) it
/// is: collide some bodies, then ask for their `constrained_velocities`; groups of bodies that have
/// nothing to do with each other may be asked for by several threads.
/// Every call may throw OdeFault; after one out of `advance` or `constrained_velocities`, the world
/// is only fit to be destroyed.
class World {
 public:
  explicit World(double gravity);

  /// Ids count from 0. @throws std::invalid_argument if the description is unphysical.
  /// @param meets   False: nothing else is there to collide with, and the body gets no shape.
  BodyId add_body(const BodySpec& spec, bool meets = true);
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
  /// Per body: it is in one of them.
  std::vector<bool> touching() const;
  /// Greatest depth of them [m].
  double deepest_contact() const;
  /// Moves the bodies over `step` [s] under loads, gravity, joints and contacts; uses up the loads.
  void advance(double step);
  /// Steps in which constraints contradicted each other and were each met in part.
  long fallback_steps() const { return fallback_steps_ + apart_.fallback_steps(); }

  /// From now on bodies move only where they are set: no gravity, no motion of their own.
  void only_constrain();
  /// Contacts of some bodies.
  struct Contacts {
    std::vector<Contact> points;
    std::vector<Pair> pairs;  ///< That touch, of which one at least can move; ascending.
  };

  /// What contacts are told of a body.
  struct Inertia {
    double mass = 0;  ///< That resists them [kg].
    double fall = 1;  ///< What part of gravity weight and lift can speed that up with.
    Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  ///< Without contacts, in W [m/s^2].
    hydro::Matrix6d matrix_B = hydro::Matrix6d::Identity();  ///< M + A about the centre of mass.
  };
  /// A body where contacts are looked for.
  struct Placed {
    BodyId body = 0;
    hydro::BodyState state;
    Inertia inertia;
  };
  /// Finds which of these pairs touch, in ascending order, with these bodies so placed and all
  /// others where they were, and how they are to be joined for a step [s].
  Contacts collide(const std::vector<Placed>& bodies, const std::vector<Pair>& pairs, double step);
  /// For how long two bodies, so placed, have run into each other: of each point where they touch
  /// and close faster than `slow` [m/s], its depth over that speed [s].
  std::vector<double> closing_times(const std::vector<std::pair<BodyId, hydro::BodyState>>& places,
                                    const Pair& pair, double slow);
  /// Wall time in the two former [s].
  double collision_seconds() const { return collision_seconds_; }

  /// The velocities in W, linear and angular, that these bodies have after `step` [s] under their
  /// loads, joints, locks and these contacts. Nothing moves.
  /// @param bodies   Ascending.
  std::vector<hydro::Twist> constrained_velocities(const std::vector<SolverBody>& bodies,
                                                   const std::vector<Contact>& contacts,
                                                   double step);

  /// Pairs of bodies and kWorld that joints hold together, of which one at least can move.
  const std::vector<Pair>& joints() const { return joints_; }
  /// False for two that cannot move or that a joint lets pass through each other.
  bool may_touch(const Pair& pair) const;
  /// Box around what a body collides with, in its frame; empty if it passes through everything.
  const Eigen::AlignedBox3d& shape_box(BodyId body) const;
  /// The same of the ground, in W.
  Eigen::AlignedBox3d ground_box() const;
  void set_contact_inertia(BodyId body, const Inertia& inertia);

 private:
  struct Body {
    dxBody* handle = nullptr;     ///< None if immovable: what it meets is then part of the world.
    dxGeom* geom = nullptr;       ///< None if it passes through everything.
    Eigen::AlignedBox3d shape_B;  ///< Around that.
    double mass = 0;              ///< Its own.
    bool held = false;            ///< By joints or locks.
    hydro::BodyState initial;
    hydro::Wrench load;              ///< For the next advance.
    std::optional<Inertia> inertia;  ///< None: what its mass and loads make of it.
  };
  struct Shape {
    dxGeom* geom = nullptr;
    Eigen::Vector3d center_B = Eigen::Vector3d::Zero();  ///< Of a box or sphere.
    Eigen::AlignedBox3d box_B;
  };

  void soften_joints(const BodySpec& spec);
  dxBody* create_body(const BodySpec& spec);
  Shape create_shape(const BodySpec& spec);
  dxGeom* create_trimesh(const hydro::TriMesh& mesh);
  /// One for all that have the same mesh.
  dxTriMeshData* mesh_data(const hydro::TriMesh& mesh);
  void place_geom(Body& body, const Shape& shape);
  void add_lock_motors(dxBody* body, const BodySpec& spec);
  dxBody* handle_of(BodyId body) const;
  dxGeom* geom_of(BodyId body) const;
  void hand_over_loads();
  std::vector<hydro::BodyState> all_states() const;
  void set_all_states(const std::vector<hydro::BodyState>& states);

  /// The same where joints or locks hold some of them; for one thread at a time.
  std::vector<hydro::Twist> held_velocities(const std::vector<SolverBody>& bodies,
                                            const std::vector<Contact>& contacts, double step);
  void join(const Contact& contact);

  std::vector<Pair> near_pairs() const;
  Contacts contacts_of(const std::vector<Pair>& pairs, double step) const;
  std::vector<ContactPoint> touching_points(const Pair& pair, double step) const;
  void add_contacts(Contacts& contacts, const Pair& pair, double step) const;
  /// Velocity of the first relative to the second where they touch, as it would be after a step
  /// without contacts.
  Eigen::Vector3d approach(const Pair& pair, const Eigen::Vector3d& point_W, double step) const;
  /// Greatest mass of the two, of what can move.
  double contact_mass(const Pair& pair) const;
  double contact_fall(const Pair& pair) const;
  /// The weights of a contact of that mass and so many points.
  ContactWeights weights(const Pair& pair, const ContactPoint& point, std::size_t points,
                         double mass, double step) const;
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
  long fallback_steps_ = 0;
  double collision_seconds_ = 0;
  std::vector<std::unique_ptr<CollisionMesh>> meshes_;
  std::unique_ptr<std::mutex> answering_ = std::make_unique<std::mutex>();
  WorldHandle world_;
  SpaceHandle space_;
  JointGroupHandle contact_joints_;  ///< Of the step that is being taken.
  Contacts contacts_;                ///< The same, where the world steps by itself.
  IslandSolver apart_;
  std::vector<Body> bodies_;
  std::vector<Pair> jointed_;  ///< Sorted.
  std::vector<Pair> joints_;
  dxGeom* ground_ = nullptr;
};

}  // namespace engine
