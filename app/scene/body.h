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
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
  bool operator==(const Inertia&) const = default;
};

struct AppliedLoad {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();
  bool in_body_frame = false;         ///< `frame: body`
  std::optional<Eigen::Vector3d> at;  ///< In the mesh frame; none: at the centre of mass.
  double start = 0;
  double end = std::numeric_limits<double>::infinity();
  struct Sine {
    double frequency = 0;  ///< [Hz]
    double phase = 0;      ///< [rad]
  };
  std::optional<Sine> sine;
  std::optional<double> factor;        ///< Set point that multiplies the load.
  std::optional<std::string> formula;  ///< In the time; multiplies the load.
  std::optional<CommandFile> file;     ///< Table that multiplies the load.
};

/// Origin of a body's added mass.
struct AddedMass {
  enum class Model {
    automatic,  ///< `deep` for a body that the water acts on.
    none,
    deep,     ///< The wetted panels' share of the added mass in unbounded fluid.
    surface,  ///< High-frequency limit: ψ = 0 on the water surface.
    matrix    ///< The matrix that the scene gives.
  };
  Model model = Model::automatic;
  double tolerance = 1e-3;  ///< Bound of the estimated relative error of `deep` [-].
  /// Added mass of `matrix` about the centre of mass, body axes [kg, kg m, kg m^2].
  hydro::Matrix6d matrix = hydro::Matrix6d::Zero();
};

/// A database of the waves that a body makes and scatters, by another program. Points are in the
/// file's frame, whose z points up from the still water.
struct RadiationFile {
  std::filesystem::path file;
  std::string body;  ///< Its name in the file, or its number from 1; empty: the only one.
  std::optional<Eigen::Vector3d> reference_point;  ///< Point of the file's motions and moments [m].
  std::optional<Eigen::Vector3d> center_of_mass;   ///< [m]
  double heading =
      0;              ///< Direction of the file's x axis in the body's frame without heading [rad].
  double length = 1;  ///< Length of WAMIT's numbers without dimension [m].
  /// Least and greatest frequency that are taken from the file [rad/s].
  std::optional<std::array<double, 2>> frequencies;

  bool operator==(const RadiationFile&) const = default;
};

/// The waves that a body makes and scatters.
struct Radiation {
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
  Source source = Source::by_default;
  std::optional<Pose> pose;  ///< None: `equilibrium`, if that is near the start.
  RadiationFile database;
};

/// The resistance of a hull along its motion beside the drag of its panels.
struct Resistance {
  enum class Source {
    none,
    file,    ///< A table of the force over the speed.
    michell  ///< By its waves, as thin-ship theory has them.
  };
  Source source = Source::none;
  std::filesystem::path file;
};

/// The block `hydro`.
struct Hydro : hydro::Coefficients {
  AddedMass added_mass;
  Radiation radiation;
  Resistance resistance;
  double wave_tolerance = hydro::LoadAccuracy().wave_tolerance;
};

enum class Collision { automatic, mesh, box, sphere, none };

/// Pose of a body at time 0.
enum class Start {
  given,       ///< The pose given by `position` and `orientation`.
  equilibrium  ///< The equilibrium afloat that this pose leads to.
};

/// Turn of a body from its equilibrium, R = Ry(pitch)·Rx(roll) in axes of its heading [rad].
struct Heel {
  double roll = 0;
  double pitch = 0;
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
  std::optional<double> volume;
  std::optional<double> level;  ///< Height over the origin of the mesh frame at time 0.
};

/// A hole in a wall.
struct Opening {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< In the mesh frame.
  double area = 0;
  double discharge = 0.6;  ///< Coefficient of discharge [-].
};

struct Body {
  std::string name;
  Shape shape;
  std::optional<double> density;
  std::optional<double> mass;
  std::optional<Eigen::Vector3d> center_of_mass;       ///< In the mesh frame; with `mass` only.
  std::optional<Inertia> inertia;                      ///< With `mass` only.
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< Mesh frame's origin, in W.
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Start start = Start::given;
  Heel heel;  ///< With `start: equilibrium` only.
  Eigen::Vector3d linear_velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();
  Interior interior = Interior::flooding;
  std::vector<InteriorWater> interior_water;
  std::vector<Opening> openings;
  Hydro hydro;  ///< The scene's defaults, overridden by the body's own keys.
  std::optional<Eigen::Vector3d> calibrated_drag;  ///< C_d along the body's axes [-], > 0.
  Collision collision = Collision::automatic;
  double friction = 0.5;  ///< Coulomb's µ [-].
  double restitution = 0;
  std::array<bool, 6> locked = {};
  std::vector<AppliedLoad> forces;
  Eigen::Vector3d color = {0.72, 0.73, 0.75};  ///< RGB, 0 … 1.
};

}  // namespace scene
