#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/base/reporter.h"
#include "hydro/added_mass/added_mass.h"

namespace hydro {
struct SurfaceNode;
}

/// @file
/// Store of added-mass solutions for later runs, in the user's cache folder. Each mesh and set of
/// options has a file; none depends on the density of water or body.
///
/// A file begins with everything that its solution depends on (format, version of the method,
/// options, the whole mesh), which must equal the request bit for bit; a hash of it is the file's
/// name. The solution and a checksum follow. A file is written under another name, flushed to the
/// disk and renamed, so that several processes may use a folder and every file is complete. The
/// reporter receives a warning of a file that cannot be read or written; its solution is then
/// computed again or not stored.

namespace assembly {

/// This version must be raised whenever `hydro::solve_added_mass` gives other numbers; files of
/// older versions are ignored.
inline constexpr int kAddedMassVersion = 3;
/// This version must be raised whenever `hydro::SurfaceAddedMass` gives other numbers.
inline constexpr int kSurfaceVersion = 2;

struct StoredAddedMass {
  std::shared_ptr<const hydro::AddedMassSolution> solution;
  bool from_store = false;  ///< True if another process solved it.
};

class AddedMassStore {
 public:
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

 private:
  std::filesystem::path file_named_after(const std::string& identity, const char* kind) const;

  std::optional<std::filesystem::path> folder_;
  std::map<std::string, StoredAddedMass> known_;  ///< The key is the file's identity.
};

/// Returns $PLIMSOLL_CACHE, else `plimsoll` in $XDG_CACHE_HOME or ~/.cache; none without a home
/// folder. An empty variable counts as unset, and so does an XDG_CACHE_HOME that is not absolute.
std::optional<std::filesystem::path> cache_folder();

}  // namespace assembly
