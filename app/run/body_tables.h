#pragma once

#include <string>
#include <vector>

#include "app/assembly/built_scene.h"
#include "app/base/table.h"
#include "app/scene/scene.h"

namespace app {

/// Tables of the bodies of a scene, as lines of text. Bodies that differ only in their positions
/// share a row, and only the most frequent kinds of bodies have one.
class BodyTables {
 public:
  BodyTables(const scene::Scene& scene, const assembly::BuiltScene& built);
  ~BodyTables();

  // Each is empty if no body has anything of it.
  std::vector<std::string> sizes() const;  ///< Meshes, sizes, masses and draughts.
  std::vector<std::string> hollows() const;
  std::vector<std::string> added_mass() const;
  std::vector<std::string> radiation() const;
  std::vector<std::string> resistance() const;  ///< Along the motion, beside the panels' drag.

 private:
  struct Kind;
  std::vector<std::string> mesh_files() const;
  std::vector<std::string> mended_files() const;
  std::vector<std::string> lines_of(Cells head, Cells Kind::*row) const;
  std::size_t rows() const;
  std::string rest() const;

  bool water_;
  std::vector<Kind> kinds_;  ///< The most frequent first.
};

}  // namespace app
