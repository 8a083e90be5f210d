#pragma once

#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "engine/base/spec.h"
#include "engine/contacts/broad_phase.h"
#include "engine/contacts/contact_surfaces.h"
#include "engine/contacts/contacts.h"
#include "engine/contacts/ode_handles.h"
#include "engine/motion/joint_frames.h"

namespace engine {

/// A box in W.
struct OrientedBox {
  Eigen::Vector3d center_W = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes_W = Eigen::Matrix3d::Identity();  ///< A rotation; its columns are the axes.
  Eigen::Vector3d sizes = Eigen::Vector3d::Zero();       ///< Lengths along the axes [m].
};

/// Bodies, joints and ground in ODE. Owns all of ODE's objects; a body is an index.
///
/// Bodies are added first, then joints and ground. The world takes steps of its own: apply loads,
/// collide, advance. Or it only finds the contacts of bodies that others place, and tells their
/// joints. Several threads may ask for that.
/// Every call may throw OdeFault; after one out of `advance` the world can only be destroyed.
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
  /// Friction and restitution of the contacts; by default those of default surfaces.
  void set_surfaces(ContactSurfaces surfaces) { surfaces_ = std::move(surfaces); }

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
    std::vector<Pair> pairs;  ///< Touching pairs, of which one body at least can move; ascending.
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
  };
  void set_contact_inertia(BodyId body, const Inertia& inertia);

  /// A body where contacts are looked for.
  struct Placed {
    BodyId body = 0;
    hydro::BodyState state;  ///< Halfway through the substep.
    hydro::BodyState start;  ///< At its start.
    Inertia inertia;
  };
  /// Finds the contacts of these pairs, which ascend, for a substep of length `step` [s], with
  /// these bodies in these places and all others where they were.
  Contacts collide(const std::vector<Placed>& bodies, const std::vector<Pair>& pairs, double step);
  /// Depth over closing speed [s] of each point where two bodies, in these places, overlap and
  /// close faster than `slow` [m/s].
  std::vector<double> closing_times(const std::vector<std::pair<BodyId, hydro::BodyState>>& places,
                                    const Pair& pair, double slow);
  /// True if the surface of a body in a place, or that of the ground, meets a box.
  bool meets(BodyId body, const hydro::BodyState& place, const OrientedBox& box);
  /// Wall time of the last three functions so far [s].
  double collision_seconds() const { return collision_seconds_; }

  /// The joints of these bodies, which ascend, in the order of the specification.
  std::vector<JointFrames> joints_of(const std::vector<BodyId>& bodies) const;

  /// All joints of which one body at least can move.
  const std::vector<JointFrames>& frames_of_joints() const { return frames_; }

  /// Pairs of bodies and kWorld that joints connect, of which one at least can move.
  const std::vector<Pair>& joints() const { return joints_; }
  /// Pairs of indices of bodies, or the number of bodies for the ground, as pairs that may touch:
  /// one can move, and no joint lets them pass through each other. Both are ascending.
  std::vector<Pair> touchable(const std::vector<std::pair<std::size_t, std::size_t>>& pairs) const;
  /// Box around the shape of a body, in B; empty if the body passes through everything.
  const Eigen::AlignedBox3d& shape_box(BodyId body) const;
  /// Box around the ground, in W; empty without ground.
  Eigen::AlignedBox3d ground_box() const;
  /// True if the shape is a sphere; false for kWorld.
  bool is_ball(BodyId body) const;
  /// Thickness of the thinner of two bodies [m]: that of the box around its shape.
  double thickness(const Pair& pair) const;
  /// Half the thickness of the thinner of two bodies [m]: that of the box around its shape, and of
  /// a ground mesh none, as it is a sheet. Infinite above plane ground, which nothing can pass.
  double reach(const Pair& pair) const;

 private:
  struct Body {
    dxBody* handle = nullptr;     ///< Null if immovable: joints and contacts then see the world.
    dxGeom* geom = nullptr;       ///< Null if it passes through everything.
    Eigen::AlignedBox3d shape_B;  ///< Box around `geom`.
    double mass = 0;
    hydro::BodyState initial;
    hydro::Wrench load;  ///< For the next advance.
    Inertia inertia;
  };
  struct CollisionMesh {
    hydro::TriMesh mesh;  ///< ODE reads these arrays for as long as it collides them.
    TriMeshDataHandle data;
  };

  void soften_joints(const BodySpec& spec);
  dxBody* create_body(const BodySpec& spec);
  void add_shape(Body& body, const BodySpec& spec);
  /// Equal meshes share their data.
  dxGeom* create_trimesh(const hydro::TriMesh& mesh);
  void add_lock_motors(dxBody* body, const BodySpec& spec);
  dxBody* handle_of(BodyId body) const;
  dxGeom* geom_of(BodyId body) const;

  Contacts contacts_of(const std::vector<Pair>& pairs, double step) const;
  Contact contact_at(const Pair& pair, const ContactPoint& point, const Surface& surface,
                     const ContactLaw& law, double step) const;
  ContactLaw law_of(const Pair& pair, std::size_t points) const;
  /// Adds the contacts of bodies that follow one which a contact stops (contacts.h).
  void add_followers(const std::vector<Placed>& bodies, const std::vector<Pair>& pairs, double step,
                     Contacts& contacts);
  /// The same of a pair whose other body is placed where it is stopped. @return true if it follows
  bool add_follower(const Pair& pair, const Placed& follower, double step, Contacts& contacts);
  std::vector<ContactPoint> touching_points(const Pair& pair, double step) const;
  /// Velocity of the first relative to the second at a point, after a step without contacts.
  Eigen::Vector3d approach(const Pair& pair, const Eigen::Vector3d& point_W, double step) const;
  Eigen::Vector3d velocity_without_contact(BodyId body, const Eigen::Vector3d& point_W,
                                           double step) const;

  // Members are destroyed in the opposite order: contacts before the world, shapes before meshes.
  double gravity_;
  double lightest_ = std::numeric_limits<double>::infinity();  ///< Least mass or moment of inertia.
  double heaviest_ = 0;                                        ///< Largest mass or moment.
  double collision_seconds_ = 0;
  std::vector<std::unique_ptr<CollisionMesh>> meshes_;
  std::unique_ptr<std::mutex> mutex_ =
      std::make_unique<std::mutex>();  ///< Guards `world_` and `space_`.
  WorldHandle world_;
  SpaceHandle space_;
  JointGroupHandle contact_joints_;  ///< Contacts of the step that is being taken.
  Contacts contacts_;                ///< For the next advance.
  std::vector<Body> bodies_;
  std::vector<Pair> jointed_;  ///< Pairs of bodies, ascending.
  std::vector<Pair> joints_;
  std::vector<JointFrames> frames_;
  std::size_t joint_count_ = 0;
  dxGeom* ground_ = nullptr;
  ContactSurfaces surfaces_;
};

}  // namespace engine
