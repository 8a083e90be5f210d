#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/hydrostatics/natural_periods.h"
#include "app/scene/reader.h"
#include "hydro/statics/equilibrium.h"
#include "hydro/statics/intact_stability.h"

/// @file
/// Floating of free single bodies at rest in still water: computation and output of `plimsoll
/// hydrostatics`.

namespace app {

struct HydrostaticsOptions {
  std::filesystem::path file;  ///< A scene if its extension is .yaml or .yml, otherwise a mesh.
  /// Exactly one of these two is set for a mesh. The draught holds with the mesh's z axis up.
  std::optional<double> mass;     ///< [kg]
  std::optional<double> draught;  ///< Draught from `keel` [m].
  std::vector<double> draughts;   ///< Draughts of the curves of form [m]; empty: no such curves.
  std::optional<double> trim;     ///< Trim of the curves of form, +x end down [rad]; none: 0.
  std::optional<double> keel;     ///< Its z in the mesh frame [m]; none: lowest point.
  std::optional<double> density;  ///< Density of the water [kg/m^3]; none: 1000.
  std::optional<Eigen::Vector3d> center_of_mass;  ///< In the mesh frame [m]; none: the centroid.
  std::optional<double> water;                    ///< In the pockets of a mesh [m^3]; none: dry.
  std::vector<scene::Override> overrides;         ///< Overrides of a scene.
  std::vector<double> heels;                      ///< Heels of the curve [rad].
  bool heels_given = false;  ///< By the user: the curves of form then have cross curves at them.
  scene::MeshFormats formats = scene::MeshFormats::common;  ///< Formats of meshes that are read.
  scene::MeshFrame frame;                                   ///< Axes and unit of a mesh.
  bool json = false;
  bool csv = false;
  std::filesystem::path plot;  ///< Picture .svg of the curves that is written; empty: none.
};

/// Prints the floating position, stability and curve of righting arms of a mesh or of a scene's
/// bodies, or their curves of form (curves_of_form.h). @return the exit code
int hydrostatics(const HydrostaticsOptions& options);

/// Refuses an option. @throws InputError if it is given, or its value wrong
void refuse_if(bool given, const std::string& option, const std::string& message);

/// A body and its water.
struct FloatingBody {
  std::string name;
  hydro::TriMesh mesh_B;  ///< Closed, mouths of pockets by lids; origin at the centre of mass.
  std::vector<hydro::Tank> tanks;                  ///< The water in its pockets.
  std::vector<Eigen::Vector3d> flooding_points_B;  ///< Sills of its pockets, and openings.
  Eigen::Vector3d com_M = Eigen::Vector3d::Zero();
  std::optional<double> keel_M;  ///< z of the keel line [m], for a draught from there.
  double mass = 0;               ///< [kg]
  double density = 1000;         ///< Density of the water [kg/m^3].
  double gravity = 9.80665;      ///< [m/s^2]
  Eigen::Quaterniond start = Eigen::Quaterniond::Identity();  ///< R_WB before settling.
  /// Its natural periods about a pose of rest; null for a mesh, whose inertia is not known, and for
  /// bodies that are joined.
  std::function<NaturalPeriods(const hydro::MeanPose&)> natural_periods;

  double water_inside() const;  ///< [m^3]
  /// Displacement of its mass and of the water inside [m^3].
  double displaced() const { return mass / density + water_inside(); }
};

/// A body afloat at one attitude. Everything is turned about the vertical so that the horizontal
/// part of the body's x axis points along +x.
struct FloatingState {
  hydro::Flotation flotation;
  hydro::Stability stability = hydro::Stability::stable;
};

struct FloatingReport {
  FloatingBody body;
  FloatingBody upright;    ///< The body in the axes from which its heel counts.
  double volume = 0;       ///< Volume of the whole body [m^3].
  std::string not_afloat;  ///< Reason why it does not float; nothing below is then set.
  std::shared_ptr<const hydro::ImmersedMesh> upright_mesh;  ///< That of `upright`.
  FloatingState start;                                      ///< State at the given attitude.
  FloatingState rest;                                       ///< State at the resulting equilibrium.
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< R_WB at rest, heading kept.
  std::optional<NaturalPeriods> natural_periods;  ///< None without FloatingBody::natural_periods.
  std::vector<hydro::RightingArm> righting_arms;
  hydro::IntactStability intact;

  /// The body as the criteria of stability take it; it must float.
  hydro::IntactBody intact_body() const {
    return {.mesh = *upright_mesh,
            .volume = upright.displaced(),
            .tanks = upright.tanks,
            .flooding_points_B = upright.flooding_points_B};
  }
};

/// Returns the body in axes turned so that its curves start upright: the axis of its mesh frame
/// that is nearest to the vertical at the start is vertical, and its x axis points ahead unless it
/// is that axis.
FloatingBody in_upright_axes(const FloatingBody& body);

/// Returns the bodies that the options name. One of a mesh has no mass if draughts of curves of
/// form are given. @throws InputError
std::vector<FloatingBody> floating_bodies(const HydrostaticsOptions& options);

FloatingReport floating_report(const FloatingBody& body, const std::vector<double>& heels);

/// A number or vector of a report.
struct Quantity {
  std::string key;  ///< Key in JSON and CSV.
  std::string unit;
  std::vector<double> values;
  double scale = 1;  ///< Magnitude against which round-off is judged.
};

/// Both functions return the quantities of the output: those of the body, and those at one
/// attitude. `orientation` is the value for a scene's key of that name.
std::vector<Quantity> body_quantities(const FloatingReport& report);
std::vector<Quantity> state_quantities(const FloatingBody& body, const FloatingState& state,
                                       const Eigen::Quaterniond& orientation);

std::string floating_table(const std::vector<FloatingReport>& reports);

/// Returns `{"bodies": {NAME: {"floats": …, "mass": …, "start": {…}, "rest": {…}, "gz": [{…}]}}}`.
std::string floating_json(const std::vector<FloatingReport>& reports);

/// Returns CSV with the header `body,state,quantity,heel_deg,value,unit` and a row per number. Only
/// the curve of righting arms, whose state is `gz`, has a `heel_deg`.
std::string floating_csv(const std::vector<FloatingReport>& reports);

}  // namespace app
