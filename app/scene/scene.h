#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/render/color_scale.h"
#include "hydro/loads/coefficients.h"
#include "hydro/loads/loads.h"
#include "hydro/spatial.h"

/// @file
/// A scene as its file says it: one struct a block, one field a key, values checked one by one.
/// Lengths, masses and times in SI; an angle whose key ends in `_deg` is in radians here.
/// Meshes are named, not loaded; what follows from them is found by `assemble`.

namespace app {

/// A place in a file, counted from 1.
struct Place {
  std::filesystem::path file;
  int line = 0;
  int column = 0;
};

struct FlatScene {};
struct HeightFieldScene {
  std::filesystem::path file;  ///< CSV or 16-bit grey PNG; resolved against the scene's folder.
  double cell = 1;             ///< [m], > 0.
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  std::optional<std::array<double, 2>> range;  ///< Heights of black and white [m]; PNG only.
};
struct WaveScene {
  double amplitude = 0;   ///< [m], >= 0.
  double wavelength = 0;  ///< [m], > 0.
  double heading = 0;     ///< [rad]
  double phase = 0;       ///< [rad]
};
struct SpectrumScene {
  enum class Type { jonswap };
  Type type = Type::jonswap;
  double significant_height = 0;  ///< [m], > 0.
  double peak_period = 0;         ///< [s], > 0.
  double gamma = 3.3;             ///< [-], 1 … 10.
  double heading = 0;             ///< [rad]
  double spreading = 0;           ///< Exponent s of cos^2s(θ/2); 0: long-crested.
  int seed = 1;
  int components = 64;  ///< Number of waves that stand for the spectrum.
};
using SurfaceScene =
    std::variant<FlatScene, HeightFieldScene, std::vector<WaveScene>, SpectrumScene>;

struct WaterScene {
  double density = 1000;
  double viscosity = 1.0034e-6;  ///< Kinematic [m^2/s], > 0.
  double level = 0;
  Eigen::Vector3d current = Eigen::Vector3d::Zero();
  SurfaceScene surface;
};

struct MeshScene {
  std::filesystem::path file;  ///< Resolved against the scene's folder.
  double scale = 1;            ///< > 0.
};
struct BoxScene {
  Eigen::Vector3d size = Eigen::Vector3d::Ones();  ///< [m]
  int divisions = 1;                               ///< Along each edge.
};
struct SphereScene {
  double radius = 1;
  int slices = 50;
  int stacks = 50;
};
struct IcosphereScene {
  double radius = 1;
  int subdivisions = 4;
};
struct EllipsoidScene {
  Eigen::Vector3d semi_axes = Eigen::Vector3d::Ones();
  int slices = 50;
  int stacks = 50;
};
struct CylinderScene {
  double radius = 1;
  double height = 2;
  int slices = 48;
  int stacks = 8;
};
using ShapeScene =
    std::variant<MeshScene, BoxScene, SphereScene, IcosphereScene, EllipsoidScene, CylinderScene>;

struct PlaneGroundScene {
  double z = 0;
};
using GroundScene = std::variant<std::monostate, PlaneGroundScene, HeightFieldScene, MeshScene>;

/// The six entries of an inertia matrix about the centre of mass, body axes [kg m^2].
struct InertiaScene {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
};

struct AppliedLoadScene {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();
  bool in_body_frame = false;         ///< `frame: body`
  std::optional<Eigen::Vector3d> at;  ///< In the mesh frame; none: the centre of mass.
  double start = 0;
  double end = std::numeric_limits<double>::infinity();
  struct Sine {
    double frequency = 0;  ///< [Hz]
    double phase = 0;      ///< [rad]
  };
  std::optional<Sine> sine;
};

/// Where a body's added mass comes from.
struct AddedMassScene {
  enum class Model {
    automatic,  ///< `deep` for a body that feels the water.
    none,
    deep,     ///< Of the body in unbounded fluid; the wetted panels' share.
    surface,  ///< With ψ = 0 on the water's surface, the limit of high frequency.
    matrix    ///< As given.
  };
  Model model = Model::automatic;
  double tolerance = 1e-3;  ///< Of `deep`: of the estimated relative error [-].
  /// Of `matrix`: about the centre of mass, body axes [kg, kg m, kg m^2].
  hydro::Matrix6d matrix = hydro::Matrix6d::Zero();
};

/// The block `hydro`.
struct HydroScene : hydro::Coefficients {
  AddedMassScene added_mass;
  double wave_tolerance = hydro::Summation().wave_tolerance;
};

enum class Collision { automatic, mesh, box, sphere, none };

/// Where a body is at time 0.
enum class Start {
  given,       ///< At `position` and `orientation`.
  equilibrium  ///< Afloat at rest, as they lead to it.
};

struct BodyScene {
  std::string name;
  ShapeScene shape;
  std::optional<double> density;
  std::optional<double> mass;
  std::optional<Eigen::Vector3d> center_of_mass;       ///< In the mesh frame; with `mass` only.
  std::optional<InertiaScene> inertia;                 ///< With `mass` only.
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< Of the mesh frame's origin, in W.
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Start start = Start::given;
  Eigen::Vector3d linear_velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();
  HydroScene hydro;  ///< The scene's defaults with the body's own keys over them.
  std::optional<Eigen::Vector3d> calibrated_drag;  ///< C_d along the body's axes [-], > 0.
  Collision collision = Collision::automatic;
  std::array<bool, 6> locked = {};
  std::vector<AppliedLoadScene> forces;
  Eigen::Vector3d color = {0.8, 0.6, 0.2};  ///< RGB, 0 … 1.
};

struct JointScene {
  enum class Type { ball, hinge, slider, fixed, universal };
  std::string name;  ///< Unique; `joint<index>` unless given.
  Type type = Type::ball;
  std::array<std::string, 2> bodies;      ///< Names; `world` stands for the world.
  std::optional<Eigen::Vector3d> anchor;  ///< In W at time 0; ball, hinge, universal have one.
  std::optional<Eigen::Vector3d> axis;    ///< Unit, in W; hinge, slider and universal have one.
  std::optional<Eigen::Vector3d> axis2;   ///< Unit, normal to `axis`; may be given for universal.
};

/// Characters of a camera's name.
inline constexpr std::size_t kLongestCameraName = 64;

struct CameraScene {
  std::string name;                              ///< Of one of `cameras`.
  Eigen::Vector3d from = {6, -8, 3};             ///< At time 0.
  Eigen::Vector3d to = Eigen::Vector3d::Zero();  ///< At time 0.
  double field_of_view = 0.6108652381980153;     ///< Vertical [rad], 35 degrees.
  std::string follow;                            ///< A body's name; empty: none.
  double orbit = 0;                              ///< [rad/s]
};

/// What is drawn besides the bodies, the water and the ground.
struct ShowScene {
  bool forces = false;
  bool centres = false;
  bool waterline = false;
  bool wireframe = false;
};

struct RenderScene {
  std::array<int, 2> size = {960, 720};  ///< [px]
  double every = 0.3;                    ///< [s]
  CameraScene camera;
  std::vector<CameraScene> cameras;        ///< In place of `camera`, unless empty.
  std::optional<int> sheet_columns;        ///< None: as fits.
  std::optional<double> pressure_min = 0;  ///< [Pa]; none: `auto`.
  std::optional<double> pressure_max;      ///< [Pa]; none: `auto`.
  render::ColorMap colors = render::ColorMap::turbo;
  render::Pressure shows = render::Pressure::total;
  ShowScene show;
};

struct IntegratorScene {
  enum class Method { split, ode };
  Method method = Method::split;
  std::optional<double> tolerance;  ///< [1/s]; none: fixed steps.
  double sleep = 0;                 ///< [m/s]; 0: nothing falls asleep.
};

struct Scene {
  std::filesystem::path file;
  std::string title;
  double duration = 0;  ///< [s]; 0: the initial state only.
  double step = 1.0 / 60;
  double gravity = 9.80665;
  IntegratorScene integrator;
  std::optional<WaterScene> water;
  GroundScene ground;
  std::vector<BodyScene> bodies;
  std::vector<JointScene> joints;
  std::optional<double> log_every;  ///< [s]; none: every step.
  bool log_forces = false;
  std::optional<RenderScene> render;

  std::string text;  ///< The file as it was read, without what the command line put over it.

  /// Where the value of each key stands, by key path (`bodies[1].mesh.file`); the whole under the
  /// empty path. For faults found later: see `Faults::add`.
  std::map<std::string, Place> places;
};

}  // namespace app
