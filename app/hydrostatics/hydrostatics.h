#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/reader.h"
#include "hydro/statics/equilibrium.h"

/// @file
/// How bodies float at rest in still water, each free and alone: what `plimsoll hydrostatics` finds
/// and how it is written.

namespace app {

struct HydrostaticsOptions {
  std::filesystem::path file;  ///< A scene if its extension is .yaml or .yml, otherwise a mesh.
  /// Of a mesh. Exactly one of these two; a draught is that with the mesh's z axis up.
  std::optional<double> mass;                     ///< [kg]
  std::optional<double> draught;                  ///< [m]
  std::optional<double> density;                  ///< Of the water [kg/m^3]; none: 1000.
  std::optional<Eigen::Vector3d> center_of_mass;  ///< In the mesh frame [m]; none: the centroid.
  std::vector<scene::Override> overrides;         ///< Of a scene.
  std::vector<double> heels;                      ///< Of the curve [rad].
  bool json = false;
  bool csv = false;
};

/// Prints the floating position, stability and curve of righting arms of a mesh or of a scene's
/// bodies. @return the exit code
int hydrostatics(const HydrostaticsOptions& options);

/// A body and the water it is put in.
struct FloatingBody {
  std::string name;
  hydro::TriMesh mesh_B;  ///< Closed; origin at the centre of mass.
  Eigen::Vector3d com_M = Eigen::Vector3d::Zero();
  double mass = 0;                                            ///< [kg]
  double density = 1000;                                      ///< Of the water [kg/m^3].
  double gravity = 9.80665;                                   ///< [m/s^2]
  Eigen::Quaterniond start = Eigen::Quaterniond::Identity();  ///< R_WB from which it settles.
};

/// A body as it floats at one attitude. All turned about the vertical until the horizontal part of
/// the body's x axis points along +x.
struct FloatingState {
  hydro::Flotation flotation;
  hydro::Stability stability = hydro::Stability::stable;
};

struct FloatingReport {
  FloatingBody body;
  double volume = 0;       ///< Of the whole body [m^3].
  std::string not_afloat;  ///< Why it does not float; then nothing below is set.
  FloatingState start;     ///< At the attitude it was given.
  FloatingState rest;      ///< At the equilibrium that this leads to.
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< There, R_WB, heading kept.
  std::vector<hydro::RightingArm> righting_arms;
};

/// The bodies that the options name. @throws InputError
std::vector<FloatingBody> floating_bodies(const HydrostaticsOptions& options);

FloatingReport floating_report(const FloatingBody& body, const std::vector<double>& heels);

/// A number or vector of a report.
struct Quantity {
  std::string key;  ///< In JSON and CSV.
  std::string unit;
  std::vector<double> values;
  double scale = 1;  ///< What the values are small beside where they are round-off.
};

/// What is said of the body, and of it at one attitude. `orientation` is what to give as such.
std::vector<Quantity> body_quantities(const FloatingReport& report);
std::vector<Quantity> state_quantities(const FloatingBody& body, const FloatingState& state,
                                       const Eigen::Quaterniond& orientation);

std::string floating_table(const std::vector<FloatingReport>& reports);

/// `{"bodies": {NAME: {"floats": …, "mass": …, "start": {…}, "rest": {…}, "gz": [{…}]}}}`
std::string floating_json(const std::vector<FloatingReport>& reports);

/// Header `body,state,quantity,heel_deg,value,unit`: a row a number, `heel_deg` empty but for the
/// curve of righting arms, whose state is `gz`.
std::string floating_csv(const std::vector<FloatingReport>& reports);

}  // namespace app
