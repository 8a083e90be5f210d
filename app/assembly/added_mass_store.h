#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/assembly/solution_files.h"
#include "app/base/reporter.h"
#include "hydro/added_mass/added_mass.h"

namespace hydro {
struct SurfaceNode;
}

/// @file
/// Store of added-mass solutions for later runs, in the user's cache folder. Each mesh and set of
/// options has a file; none depends on the density of water or body.
///
/// solution_files.h tells how files are named, checked and written. The reporter receives a warning
/// of a file that cannot be read or written; its solution is then computed again or not stored.

namespace assembly {

/// This version must be raised whenever `hydro::solve_added_mass` gives other numbers; files of
/// older versions are ignored.
inline constexpr int kAddedMassVersion = 3;
/// This version must be raised whenever `hydro::SurfaceAddedMass` gives other numbers.
inline constexpr int kSurfaceVersion = 3;

/// A solution of added mass and its origin.
struct StoredAddedMass {
  /// For ρ = 1, about the origin of the mesh.
  std::shared_ptr<const hydro::AddedMassSolution> solution;
  bool from_store = false;  ///< True if another process solved it.
};

/// The store of added-mass solutions.
class AddedMassStore {
 public:
  /// Makes the store of a folder.
  /// @param folder   None: solutions live only as long as this object.
  explicit AddedMassStore(std::optional<std::filesystem::path> folder);

  /// Returns the stored solution of a mesh; none if there is none.
  std::optional<StoredAddedMass> find(const hydro::TriMesh& mesh,
                                      const hydro::AddedMassOptions& options,
                                      app::Reporter& reporter = app::quiet());

  /// Stores a new solution.
  StoredAddedMass keep(const hydro::TriMesh& mesh, const hydro::AddedMassOptions& options,
                       hydro::AddedMassSolution solution, app::Reporter& reporter = app::quiet());

  /// Returns the file of a mesh's solution; empty without a folder.
  std::filesystem::path file_of(const hydro::TriMesh& mesh,
                                const hydro::AddedMassOptions& options) const;

  /// Returns the nodes of `surface` (hydro/added_mass/surface_added_mass.h) that earlier runs have
  /// solved for a mesh about its body's centre of mass.
  std::vector<hydro::SurfaceNode> find_nodes(const hydro::TriMesh& mesh_B,
                                             app::Reporter& reporter = app::quiet()) const;

  /// Adds nodes to those that this or another process has stored.
  void keep_nodes(const hydro::TriMesh& mesh_B, const std::vector<hydro::SurfaceNode>& nodes,
                  app::Reporter& reporter = app::quiet()) const;

  /// Returns the file of a mesh's nodes; empty without a folder.
  std::filesystem::path nodes_file_of(const hydro::TriMesh& mesh_B) const;

  /// The folder; none: solutions live only as long as this object.
  const std::optional<std::filesystem::path>& folder() const { return files_.folder(); }

 private:
  SolutionFiles files_;
  std::map<std::string, StoredAddedMass> known_;  ///< The key is the file's identity.
};

}  // namespace assembly
