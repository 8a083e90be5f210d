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
/// Solutions of added mass, kept for later runs in the user's cache folder: a file a mesh and set
/// of options, none of which depends on the density of water or body.
///
/// A file begins with all that its solution depends on (format, version of the method, options, the
/// whole mesh), which must be that of the question to the last bit; its name is a hash of that.
/// Then come the solution and a checksum. It is written under another name, flushed to the disk
/// and renamed, so that several processes may use a folder and a file is there whole or not at all.
/// A reporter is warned of what cannot be read or written, and the solution is found anew or not
/// kept.

namespace assembly {

/// To be raised whenever `hydro::solve_added_mass` gives other numbers: older files are left alone.
inline constexpr int kAddedMassVersion = 3;
/// The same for `hydro::SurfaceAddedMass`.
inline constexpr int kSurfaceVersion = 1;

struct StoredAddedMass {
  std::shared_ptr<const hydro::AddedMassSolution> solution;
  bool from_store = false;  ///< It was not solved for in this process.
};

class AddedMassStore {
 public:
  /// @param folder   None: solutions are kept as long as this object only.
  explicit AddedMassStore(std::optional<std::filesystem::path> folder);

  /// What is kept of a mesh; none if that is nothing.
  std::optional<StoredAddedMass> find(const hydro::TriMesh& mesh,
                                      const hydro::AddedMassOptions& options,
                                      app::Reporter& reporter = app::quiet());

  /// Keeps a solution that was found now.
  StoredAddedMass keep(const hydro::TriMesh& mesh, const hydro::AddedMassOptions& options,
                       hydro::AddedMassSolution solution, app::Reporter& reporter = app::quiet());

  /// Where the solution of a mesh is kept; empty without a folder.
  std::filesystem::path file_of(const hydro::TriMesh& mesh,
                                const hydro::AddedMassOptions& options) const;

  /// The nodes of `surface` (hydro/added_mass/surface_added_mass.h) that earlier runs have solved
  /// for a mesh about its body's centre of mass.
  std::vector<hydro::SurfaceNode> find_nodes(const hydro::TriMesh& mesh_B,
                                             app::Reporter& reporter = app::quiet()) const;

  /// Keeps nodes beside those that are kept already, by this process or another.
  void keep_nodes(const hydro::TriMesh& mesh_B, const std::vector<hydro::SurfaceNode>& nodes,
                  app::Reporter& reporter = app::quiet()) const;

  /// Where they are kept; empty without a folder.
  std::filesystem::path nodes_file_of(const hydro::TriMesh& mesh_B) const;

 private:
  std::filesystem::path file_named_after(const std::string& identity, const char* kind) const;

  std::optional<std::filesystem::path> folder_;
  std::map<std::string, StoredAddedMass> known_;  ///< By the bytes that a file begins with.
};

/// $PLIMSOLL_CACHE, else `plimsoll` in $XDG_CACHE_HOME or ~/.cache; none without a home folder.
/// Variables that are empty count as not set, as does an XDG_CACHE_HOME that is not absolute.
std::optional<std::filesystem::path> cache_folder();

}  // namespace assembly
