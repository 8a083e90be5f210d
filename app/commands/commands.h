#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/logs/log.h"
#include "app/pictures/video.h"
#include "app/scene/reader.h"
#include "hydro/added_mass/added_mass.h"

/// @file
/// What the program's commands do. Each returns the process's exit code; wrong input is thrown as
/// InputError, a simulation that cannot go on is code 3 of `run`.

namespace app {

/// Exit codes, as scripts rely on them.
enum ExitCode {
  kDone = 0,
  kDiffers = 1,       ///< `compare` found a difference beyond tolerance.
  kWrongInput = 2,    ///< Wrong usage or input.
  kCannotGoOn = 3,    ///< The simulation met a state that is not finite.
  kInterrupted = 130  ///< Ctrl-C; what was done is written.
};

struct RunOptions {
  std::filesystem::path scene;
  std::filesystem::path out;  ///< Empty: out/<scene file's stem>.
  std::vector<Override> overrides;
  LogFormat format = LogFormat::csv;
  bool render = true;
  VideoOptions video;
  int threads = 0;  ///< 0: as many as the machine has.
  bool quiet = false;
};
int run(const RunOptions& options);

/// Writes a scene to start from, with comments. @param name   With or without `.yaml`; a file of
/// that name is left alone.
int new_scene(const std::filesystem::path& name);

/// Prints the scene format for editors, as a JSON Schema. @param markdown   The tables of keys of
/// scenes/README.md instead.
int schema(bool markdown);

int check(const std::vector<std::filesystem::path>& scenes, const std::vector<Override>& overrides);

int probe(const std::filesystem::path& scene, const std::vector<Override>& overrides);

/// Two trajectories, each a file or the folder of a run.
struct CompareOptions {
  std::filesystem::path a;
  std::filesystem::path b;
  /// By quantity (`position`, …); only those named are judged. Empty: those of a file.
  std::map<std::string, double> tolerances;
  /// Of tolerances. Empty: tolerances.yaml in the folder of `a` or of `b`, or else all to 1e-9.
  std::filesystem::path tolerance_file;
  bool json = false;            ///< Print JSON, no table.
  std::filesystem::path junit;  ///< Report for a CI server; empty: none.
  std::filesystem::path html;   ///< Page with plots, for a browser; empty: none.
};
int compare(const CompareOptions& options);

struct RenderOptions {
  std::filesystem::path trajectory;
  std::filesystem::path scene;
  std::filesystem::path out;
  std::vector<Override> overrides;
  VideoOptions video;
  bool quiet = false;
};
int render_trajectory(const RenderOptions& options);

struct ViewOptions {
  std::filesystem::path scene;
  std::vector<Override> overrides;
  int threads = 0;                 ///< 0: as many as the machine has.
  std::filesystem::path snapshot;  ///< Of what the window shows `after` so long; empty: none.
  double after = 0;                ///< Simulated [s].
};
/// Plays a scene in a window, in real time, until that is closed or the snapshot is taken.
int view(const ViewOptions& options);

/// In the folder of the run that it shows.
inline constexpr const char* kReportFile = "report.html";

struct ReportOptions {
  std::filesystem::path folder;  ///< Of a run.
  std::filesystem::path scene;   ///< Where the scene lies now; empty: where it was run.
};
/// Writes FOLDER/report.html: the run in one page that needs no other file.
int report(const ReportOptions& options);

/// The floating position, stability and curve of righting arms of a mesh or of a scene's bodies.
struct HydrostaticsOptions {
  std::filesystem::path file;  ///< A scene if its extension is .yaml or .yml, otherwise a mesh.
  /// Of a mesh. Exactly one of these two; a draught is that with the mesh's z axis up.
  std::optional<double> mass;                     ///< [kg]
  std::optional<double> draught;                  ///< [m]
  std::optional<double> density;                  ///< Of the water [kg/m^3]; none: 1000.
  std::optional<Eigen::Vector3d> center_of_mass;  ///< In the mesh frame [m]; none: the centroid.
  std::vector<Override> overrides;                ///< Of a scene.
  std::vector<double> heels;                      ///< Of the curve [rad].
  bool json = false;
  bool csv = false;
};
int hydrostatics(const HydrostaticsOptions& options);

/// The added mass of a mesh or of a scene's bodies, each wholly submerged and alone.
struct AddedMassCommand {
  std::filesystem::path file;       ///< A scene if its extension is .yaml or .yml, else a mesh.
  std::optional<double> density;    ///< Of the water [kg/m^3]; none: the scene's, or 1000.
  std::vector<Override> overrides;  ///< Of a scene.
  hydro::AddedMassOptions options;
  bool store = true;  ///< Take solutions from the store, and keep them there.
  bool json = false;
};
int addedmass(const AddedMassCommand& command);

}  // namespace app
