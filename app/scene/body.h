#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/rig.h"
#include "app/scene/shape.h"
#include "hydro/loads/coefficients.h"
#include "hydro/loads/loads.h"
#include "hydro/spatial.h"

/// @file
/// The bodies of a scene and their block `hydro`.

namespace scene {

/// The six entries of an inertia matrix about the centre of mass, body axes [kg m^2].
struct Inertia {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;  ///< Entry of the matrix.
  bool operator==(const Inertia&) const = default;
};

/// A load on a body besides those of water and gravity: an entry of `bodies[].forces`.
struct AppliedLoad {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< [N]
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();  ///< [N m]
  bool in_body_frame = false;                        ///< `frame: body`
  std::optional<Eigen::Vector3d> at;  ///< In the mesh frame; none: at the centre of mass.
  double start = 0;                   ///< Time from which on it acts [s].
  double end = std::numeric_limits<double>::infinity();  ///< Time up to which it acts [s].
  /// The factor sin(2π·frequency·t + phase).
  struct Sine {
    double frequency = 0;  ///< [Hz]
    double phase = 0;      ///< [rad]
  };
  std::optional<Sine> sine;            ///< Multiplies the load.
  std::optional<double> factor;        ///< Set point that multiplies the load.
  std::optional<std::string> formula;  ///< In the time; multiplies the load.
  std::optional<CommandFile> file;     ///< Table that multiplies the load.
};

/// Origin of a body's added mass.
struct AddedMass {
  /// The model, by the word of the key `added_mass`.
  enum class Model {
    automatic,  ///< `deep` for a body that the water acts on.
    none,
    deep,     ///< The wetted panels' share of the added mass in unbounded fluid.
    surface,  ///< High-frequency limit: ψ = 0 on the water surface.
    matrix    ///< The matrix that the scene gives.
  };
  Model model = Model::automatic;  ///< Model of the added mass.
  double tolerance = 1e-3;         ///< Bound of the estimated relative error of `deep` [-].
  /// Added mass of `matrix` about the centre of mass, body axes [kg, kg m, kg m^2].
  hydro::Matrix6d matrix = hydro::Matrix6d::Zero();
};

/// A database of the waves that a body makes and scatters, by another program. Points are in the
/// file's frame, whose z points up from the still water.
struct RadiationFile {
  std::filesystem::path file;  ///< The file, resolved against the scene's folder.
  std::string body;            ///< Its name in the file, or its number from 1; empty: the only one.
  std::optional<Eigen::Vector3d> reference_point;  ///< Point of the file's motions and moments [m].
  std::optional<Eigen::Vector3d> center_of_mass;   ///< [m]
  /// Direction of the file's x axis in the body's frame without heading [rad].
  double heading = 0;
  double length = 1;  ///< Length of WAMIT's numbers without dimension [m].
  /// Least and greatest frequency that are taken from the file [rad/s].
  std::optional<std::array<double, 2>> frequencies;

  bool operator==(const RadiationFile&) const = default;
};

/// The waves that a body makes and scatters.
struct Radiation {
  /// Where the loads of the waves come from.
  enum class Source {
    by_default,  ///< `automatic` for a body that starts afloat (assembly/radiation_choice.h).
    automatic,   ///< Solved on the body's mesh in its mean pose.
    none,
    file  ///< Read from `database`.
  };
  /// The mean pose.
  enum class Pose {
    equilibrium,  ///< At rest with joints, lines, locks and constant loads in place.
    start         ///< As it starts.
  };
  Source source = Source::by_default;  ///< Where the loads come from.
  std::optional<Pose> pose;            ///< None: `equilibrium`, if that is near the start.
  RadiationFile database;              ///< For `file`.
};

/// The resistance of a hull along its motion beside the drag of its panels.
struct Resistance {
  /// Where the force comes from.
  enum class Source {
    none,
    file,    ///< A table of the force over the speed.
    michell  ///< By its waves, as thin-ship theory has them.
  };
  Source source = Source::none;  ///< Where the force comes from.
  std::filesystem::path file;    ///< Table for `file`.
};

/// The block `hydro`.
struct Hydro : hydro::Coefficients {
  AddedMass added_mass;   ///< Added mass of the body.
  Radiation radiation;    ///< Waves that the body makes and scatters.
  Resistance resistance;  ///< Resistance along its motion.
  /// As hydro::LoadAccuracy::wave_tolerance [-].
  double wave_tolerance = hydro::LoadAccuracy().wave_tolerance;
};

/// The shape of a body in contacts; `automatic` follows from its shape.
enum class Collision { automatic, mesh, box, sphere, none };

/// Pose of a body at time 0.
enum class Start {
  given,       ///< The pose given by `position` and `orientation`.
  equilibrium  ///< The equilibrium afloat that this pose leads to.
};

/// Turn of a body from its equilibrium, R = Ry(pitch)·Rx(roll) in axes of its heading [rad].
struct Heel {
  double roll = 0;   ///< About the body's x axis [rad].
  double pitch = 0;  ///< About the y axis of its heading [rad].
};

/// Model of the water in the hollows of a body.
enum class Interior {
  flooding,  ///< They are dry until water comes in.
  dry,       ///< They never fill.
  wet        ///< They are a part of the sea.
};

/// Water in a hollow at time 0.
struct InteriorWater {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< A point of the hollow, in the mesh frame.
  std::optional<double> volume;  ///< [m^3]; exactly one of volume and level is given.
  std::optional<double> level;   ///< Height over the origin of the mesh frame at time 0.
};

/// A hole in a wall.
struct Opening {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< In the mesh frame.
  double area = 0;                               ///< [m^2]
  double discharge = 0.6;                        ///< Coefficient of discharge [-].
};

/// A pump of a hollow.
struct Pump {
  std::string name;                                ///< Unique among the pumps of all bodies.
  Eigen::Vector3d from = Eigen::Vector3d::Zero();  ///< Its suction, in the mesh frame.
  std::optional<Eigen::Vector3d> to;  ///< Its outlet, in the mesh frame; none: into the sea.
  double rate = 0;                    ///< Flow without a lift [m^3/s].
  std::optional<double> head;         ///< Lift without a flow [m]; none: the flow is the same.
};

/// A body: an entry of `bodies`. Exactly one of density and mass is given.
struct Body {
  std::string name;                                    ///< Unique name.
  Shape shape;                                         ///< Shape of its surface.
  std::optional<double> density;                       ///< Mean density [kg/m^3].
  std::optional<double> mass;                          ///< [kg]
  std::optional<Eigen::Vector3d> center_of_mass;       ///< In the mesh frame; with `mass` only.
  std::optional<Inertia> inertia;                      ///< With `mass` only.
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< Mesh frame's origin, in W.
  /// Rotation from body to world.
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Start start = Start::given;  ///< Meaning of the pose.
  Heel heel;                   ///< With `start: equilibrium` only.
  /// At time 0, of the centre of mass, in W [m/s].
  Eigen::Vector3d linear_velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< At time 0, in W [rad/s].
  Interior interior = Interior::flooding;     ///< Model of the water in its hollows.
  bool air = false;                           ///< Its closed hollows trap their air.
  std::vector<InteriorWater> interior_water;  ///< Water in its hollows at time 0.
  std::vector<Opening> openings;              ///< Holes in its walls.
  std::vector<Pump> pumps;                    ///< Pumps of its hollows.
  Hydro hydro;  ///< The scene's defaults, overridden by the body's own keys.
  std::optional<Eigen::Vector3d> calibrated_drag;  ///< C_d along the body's axes [-], > 0.
  Collision collision = Collision::automatic;      ///< Shape in contacts.
  double friction = 0.5;                           ///< Coulomb's µ [-].
  double restitution = 0;                          ///< Coefficient of restitution [-], 0 … 1.
  std::array<bool, 6> locked = {};             ///< Locked degrees of freedom, as engine::DofMask.
  std::vector<AppliedLoad> forces;             ///< Loads besides those of water and gravity.
  Eigen::Vector3d color = {0.72, 0.73, 0.75};  ///< RGB, 0 … 1.
};

}  // namespace scene
