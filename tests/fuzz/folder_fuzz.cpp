#include <fstream>
#include <nlohmann/json.hpp>

#include "app/logs/run_files.h"
#include "app/logs/run_source.h"
#include "app/sweep/sweep_folder.h"
#include "app/sweep/sweep_outcome.h"
#include "tests/fuzz/fuzz_input.h"

/// @file
/// The files in JSON that the folder of a run or a sweep holds: the source in a summary, the
/// outcome of a run, the definition of a sweep. Each input is given to every reader.

namespace fs = std::filesystem;

namespace {

const fs::path& sweep_folder() {
  static const fs::path folder = [] {
    const fs::path path = "/dev/shm/plimsoll_fuzz_sweep_" + std::to_string(::getpid());
    fs::create_directories(path / "runs");
    return path;
  }();
  return folder;
}

void read_sweep(std::string_view text) {
  const fs::path& path = sweep_folder();
  std::ofstream(path / "sweep.json", std::ios::binary) << text;
  fuzz::expect_content_or_faults(path.string(), [&] {
    const app::SweepFolder folder(path, app::OutputFolder::Use::alone);
    folder.holds({.scene = "scene.yaml", .sets = {"a=1"}, .varied = {"b=1:2:1"}});
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("outcome.json");
  const std::string_view text = fuzz::text_of(data, size);
  const fs::path& path = file.holding(text);
  app::read_outcome(path);
  fuzz::expect_content_or_faults(path.string(),
                                 [&] { app::source_in(app::read_summary(path), path); });
  read_sweep(text);
  return 0;
}
