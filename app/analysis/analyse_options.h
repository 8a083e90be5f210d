#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace app {

struct AnalyseOptions {
  std::filesystem::path run;      ///< Folder of a run, or a trajectory, CSV or HDF5.
  std::optional<double> from;     ///< Rows before it are left out [s].
  std::optional<double> to;       ///< Rows after it are left out [s].
  std::optional<double> segment;  ///< Length of the segments of spectra [s]; none: eight of them.
  std::string wave;  ///< Probe at which the wave is measured; empty: the scene's own irregular sea.
  bool json = false;
};

}  // namespace app
