#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/analysis/analyse.h"
#include "app/commands/addedmass.h"
#include "app/commands/radiation.h"
#include "app/commands/rao.h"
#include "app/hydrostatics/hydrostatics.h"

namespace CLI {
class App;
}

namespace app {

/// Values of the options of the commands that compute something of a mesh, of bodies at rest or of
/// a run.
struct AnalysisArguments {
  HydrostaticsOptions hydrostatics;
  std::vector<double> center_of_mass;
  std::string heels = "0:60:5";
  std::string draughts;        ///< One draught, or those of curves of form, of `hydrostatics` [m].
  std::optional<double> trim;  ///< Trim of the curves of form [deg].
  AddedMassCommand addedmass;
  RadiationCommand radiation;
  RaoCommand rao;
  std::string headings = "0:180:45";  ///< Headings of `rao` [deg].
  std::string periods = "4:20:1";     ///< Periods of `rao` [s].
  AnalyseOptions analyse;
};

/// Adds the commands `hydrostatics`, `addedmass`, `radiation`, `rao` and `analyse`.
/// @param sets   Arguments of --set.
void add_analyses(CLI::App& program, AnalysisArguments& arguments, std::vector<std::string>& sets);

/// Runs the one that was given. @return its exit code; none if another command was given
std::optional<int> run_analysis(const CLI::App& program, AnalysisArguments& arguments,
                                const std::vector<scene::Override>& overrides);

}  // namespace app
