#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/compare/compared_run.h"

/// @file
/// Origin of two runs: the versions of the program, the keys of the scenes and the meshes, as their
/// summaries tell.

namespace app {

/// A thing that is not alike in both runs. An empty text: it is missing there.
struct Change {
  std::string what;  ///< `plimsoll`, `bodies[barge].mass`, `barge`
  std::string a;
  std::string b;
};

/// The differences between what made two runs.
struct Provenance {
  std::vector<Change> programs;
  std::vector<Change> keys;        ///< Key paths; entries of lists by their names if they have any.
  std::vector<Change> meshes;      ///< By the names of the bodies.
  std::vector<std::string> notes;  ///< Questions left open.

  bool alike() const { return programs.empty() && keys.empty() && meshes.empty(); }
};

/// Compares the summaries of two runs; none unless both have one. The scenes are compared as they
/// were run: with what they include, repeat and compute, and with the overrides of the command
/// line.
std::optional<Provenance> provenance_of(const ComparedRun& a, const ComparedRun& b);

/// Returns lines that tell the differences; one line if there are none.
std::string text_of(const Provenance& provenance);

/// Returns `{"programs": {WHAT: [A, B]}, "keys": …, "meshes": …, "notes": […]}`; null: missing.
nlohmann::ordered_json json_of(const Provenance& provenance);

}  // namespace app
