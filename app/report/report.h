#pragma once

#include <filesystem>

#include "app/scene/shape.h"

namespace app {

struct ReportOptions {
  std::filesystem::path folder;  ///< Output folder of a run.
  std::filesystem::path scene;   ///< Present path of the scene; empty: the path in the run.
  /// Formats of meshes that are read; a run that read any has its report do so, too.
  scene::MeshFormats formats = scene::MeshFormats::common;
};

/// Writes FOLDER/report.html: a page about the run that needs no other file. @return the exit code
int report(const ReportOptions& options);

}  // namespace app
