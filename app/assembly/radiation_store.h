#pragma once

#include <map>
#include <memory>

#include "app/assembly/solution_files.h"
#include "hydro/radiation/radiation_memory.h"
#include "hydro/radiation/radiation_solve.h"

/// @file
/// Store of the solutions of radiation and diffraction for later runs, in the user's cache folder
/// (solution_files.h). Each mesh, mean pose, water and set of options has a file; none depends on
/// the density of water or body.

namespace assembly {

/// This version must be raised whenever `hydro::solve_radiation` or `hydro::fit_memory` gives other
/// numbers; files of older versions are ignored.
inline constexpr int kRadiationVersion = 6;

/// Everything on which a solution depends.
struct RadiationProblem {
  const hydro::TriMesh& mesh_B;          ///< Its origin is the centre of mass.
  hydro::MeanPose pose;                  ///< Mean pose.
  hydro::LinearWater water;              ///< Depth and gravity.
  hydro::RadiationOptions options = {};  ///< Options of the solution.
};

/// A solution of radiation and its origin.
struct StoredRadiation {
  std::shared_ptr<const hydro::RadiationSolution> solution;  ///< For ρ = 1, in the frame H.
  /// Fitted to the solution; none where the problem gives its frequencies.
  std::shared_ptr<const hydro::RadiationMemory> memory;
  double seconds = 0;       ///< Wall time of the solve [s].
  bool from_store = false;  ///< True if another process solved it.
};

/// The store of solutions of radiation.
class RadiationStore {
 public:
  /// Makes the store of a folder.
  /// @param folder   None: solutions live only as long as this object.
  explicit RadiationStore(std::optional<std::filesystem::path> folder);

  /// Returns the stored solution; none if there is none.
  std::optional<StoredRadiation> find(const RadiationProblem& problem,
                                      app::Reporter& reporter = app::quiet());

  /// Stores a new solution.
  StoredRadiation keep(const RadiationProblem& problem, hydro::RadiationSolution solution,
                       double seconds, app::Reporter& reporter = app::quiet());

  /// Returns the file of a solution; empty without a folder.
  std::filesystem::path file_of(const RadiationProblem& problem) const;

 private:
  SolutionFiles files_;
  std::map<std::string, StoredRadiation> known_;  ///< The key is the file's identity.
};

/// Relative step of the numbers of a pose: far above the round-off of an equilibrium, some 1e-14,
/// and far below what changes a solution.
inline constexpr double kPoseStep = 1e-7;

/// Returns the pose with its numbers rounded to this part of the body's radius and of a radian, so
/// that bodies whose equilibrium differs by round-off share a solution.
hydro::MeanPose rounded(const hydro::MeanPose& pose, double radius, double step = kPoseStep);

/// Returns the solution of a problem, which is computed and stored if the store lacks it. If
/// several processes need it at once, one computes it and the others wait.
/// @param name   Name of the body in messages.
/// @throws std::invalid_argument as hydro::solve_radiation does
StoredRadiation solved_radiation(const std::string& name, const RadiationProblem& problem,
                                 RadiationStore& store, app::Reporter& reporter);

}  // namespace assembly
