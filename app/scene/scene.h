#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/scene/body.h"
#include "app/scene/diagnostics.h"
#include "app/scene/probe.h"
#include "app/scene/render.h"
#include "app/scene/rig.h"
#include "app/scene/water.h"
#include "hydro/air.h"

/// @file
/// A soft bed: `ground.suction`.
struct BedSuction {
  double pressure = 0;  ///< Largest fall of pressure below a body [Pa], >= 0.
  double time = 0;      ///< Time in which its bond is lost [s], > 0.
};

/// A scene as its file describes it: each block has a struct, each key a field, and each value is
/// checked by itself. Lengths, masses and times are in SI; an angle whose key ends in `_deg` is
/// stored in radians. Meshes are named, not loaded; app/assembly loads them and derives the rest.

namespace scene {

/// Ground that is a horizontal plane.
struct PlaneGround {
  double z = 0;  ///< [m]
};
/// The ground: none, a plane, heights on a grid, or a mesh.
using Ground = std::variant<std::monostate, PlaneGround, HeightField, Mesh>;

/// A joint between two bodies, or a body and the world: an entry of `joints`.
struct Joint {
  /// The motions that the joint leaves free.
  enum class Type { ball, hinge, slider, fixed, universal };
  std::string name;                       ///< Unique; `joint<index>` unless given.
  Type type = Type::ball;                 ///< Kind of the joint.
  std::array<std::string, 2> bodies;      ///< Names; `world` stands for the world.
  std::optional<Eigen::Vector3d> anchor;  ///< In W at time 0; ball, hinge, universal have one.
  std::optional<Eigen::Vector3d> axis;    ///< Unit, in W; hinge, slider and universal have one.
  std::optional<Eigen::Vector3d> axis2;   ///< Unit, normal to `axis`; may be given for universal.
  JointDrive drive;                       ///< Drive of a hinge or slider.
};

/// Friction and restitution of one pair; what is not given follows from the bodies.
struct Contact {
  std::array<std::string, 2> bodies;  ///< Names; `world` stands for the ground.
  std::optional<double> friction;     ///< Coulomb's µ [-].
  std::optional<double> restitution;  ///< Coefficient of restitution [-].
};

/// The time integration: the block `integrator`.
struct Integrator {
  /// The method, as engine::Integrator::Method.
  enum class Method { split, ode };
  Method method = Method::split;    ///< Method of the integration.
  std::optional<double> tolerance;  ///< [1/s]; none: fixed steps.
};

/// A scene as its file describes it. A key that the file lacks has its default value.
struct Scene {
  std::filesystem::path file;         ///< The scene's file.
  std::string title;                  ///< Title of logs and pictures.
  double duration = 0;                ///< [s]; 0: the initial state only.
  double step = 1.0 / 60;             ///< Time step [s], > 0.
  double gravity = 9.80665;           ///< Along −z [m/s^2].
  Integrator integrator;              ///< The time integration.
  std::optional<Water> water;         ///< None: a dry scene.
  std::optional<hydro::Air> air;      ///< None: nothing acts above the water.
  Ground ground;                      ///< Sea floor or shore.
  double ground_friction = 0.5;       ///< Coulomb's µ [-].
  double ground_restitution = 0;      ///< Coefficient of restitution [-].
  std::optional<BedSuction> suction;  ///< None: the ground holds nothing that is pulled.
  std::vector<Body> bodies;           ///< In the order of the file.
  std::vector<Joint> joints;          ///< In the order of the file.
  std::vector<Contact> contacts;      ///< Values of single pairs.
  std::vector<Spring> springs;        ///< In the order of the file.
  std::vector<Rope> ropes;            ///< Ropes and winches.
  std::vector<Mooring> moorings;      ///< Catenaries.
  std::optional<MoorDyn> moordyn;     ///< In place of `moorings`.
  std::vector<Propeller> propellers;  ///< Propellers and thrusters.
  std::vector<Rudder> rudders;        ///< Foils in the water.
  std::vector<Sail> sails;            ///< Foils in the wind.
  std::vector<Control> controls;      ///< Sources of set points.
  std::optional<double> log_every;    ///< Interval [s]; none: every step.
  bool log_forces = false;            ///< True: forces and works are logged.
  std::vector<Probe> probes;          ///< Points that are logged.
  std::optional<Render> render;       ///< None: no pictures.

  /// The formats of its meshes that are read. No key sets this: whoever reads the scene does.
  MeshFormats mesh_formats = MeshFormats::common;

  std::string text;  ///< Text of the file, with all files it includes and without overrides.

  /// The place of each key's value, for faults that are found later (see Faults::add).
  Places places;
};

/// Height of the flat bottom, as far as the scene says it [m].
std::optional<double> bottom_of(const Scene& scene);

}  // namespace scene
