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
/// A scene as its file describes it: each block has a struct, each key a field, and each value is
/// checked by itself. Lengths, masses and times are in SI; an angle whose key ends in `_deg` is
/// stored in radians. Meshes are named, not loaded; app/assembly loads them and derives the rest.

namespace scene {

struct PlaneGround {
  double z = 0;
};
using Ground = std::variant<std::monostate, PlaneGround, HeightField, Mesh>;

struct Joint {
  enum class Type { ball, hinge, slider, fixed, universal };
  std::string name;  ///< Unique; `joint<index>` unless given.
  Type type = Type::ball;
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
  std::optional<double> restitution;
};

struct Integrator {
  enum class Method { split, ode };
  Method method = Method::split;
  std::optional<double> tolerance;  ///< [1/s]; none: fixed steps.
};

struct Scene {
  std::filesystem::path file;
  std::string title;
  double duration = 0;  ///< [s]; 0: the initial state only.
  double step = 1.0 / 60;
  double gravity = 9.80665;
  Integrator integrator;
  std::optional<Water> water;
  std::optional<hydro::Air> air;
  Ground ground;
  double ground_friction = 0.5;  ///< Coulomb's µ [-].
  double ground_restitution = 0;
  std::vector<Body> bodies;
  std::vector<Joint> joints;
  std::vector<Contact> contacts;
  std::vector<Spring> springs;
  std::vector<Rope> ropes;
  std::vector<Mooring> moorings;
  std::optional<MoorDyn> moordyn;  ///< In place of them.
  std::vector<Propeller> propellers;
  std::vector<Rudder> rudders;
  std::vector<Sail> sails;
  std::vector<Control> controls;
  std::optional<double> log_every;  ///< [s]; none: every step.
  bool log_forces = false;
  std::vector<Probe> probes;
  std::optional<Render> render;

  /// The formats of its meshes that are read. No key sets this: whoever reads the scene does.
  MeshFormats mesh_formats = MeshFormats::common;

  std::string text;  ///< Text of the file, with all files it includes and without overrides.

  /// The place of each key's value, for faults that are found later (see Faults::add).
  Places places;
};

}  // namespace scene
