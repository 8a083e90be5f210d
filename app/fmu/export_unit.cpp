#include "app/fmu/export_unit.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "app/base/atomic_file.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/base/terminal_reporter.h"
#include "app/fmu/archive.h"
#include "app/fmu/file_bytes.h"
#include "app/fmu/model_description.h"
#include "app/fmu/unit.h"
#include "app/fmu/unit_library.h"
#include "app/scene/reader.h"

namespace fmu {
namespace {

namespace fs = std::filesystem;

/// A folder that is removed with this.
class WorkFolder {
 public:
  WorkFolder() : path_((fs::temp_directory_path() / "plimsoll_unit_XXXXXX").string()) {
    if (mkdtemp(path_.data()) == nullptr)
      throw std::runtime_error(path_ + ": a folder cannot be made there");
  }
  ~WorkFolder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  fs::path path() const { return path_; }

 private:
  std::string path_;
};

/// Reads the packed scene as an importer's library will. A fault of it is one of packing.
Unit unit_of(const fs::path& resources, const fs::path& out, app::Reporter& reporter) {
  try {
    return Unit(load_scene(resources, reporter));
  } catch (const scene::InputError& error) {
    throw scene::InputError(out, std::string("the scene cannot be packed: ") + error.what());
  }
}

/// Returns the files below a folder, in the order of their names.
std::vector<ArchiveEntry> entries_below(const fs::path& folder, const std::string& prefix) {
  std::vector<ArchiveEntry> entries;
  for (const fs::directory_entry& file : fs::recursive_directory_iterator(folder))
    if (file.is_regular_file() && file.path().extension() != ".lock")
      entries.push_back({prefix + file.path().lexically_relative(folder).generic_string(),
                         bytes_of(file.path())});
  std::ranges::sort(entries, {}, &ArchiveEntry::name);
  return entries;
}

}  // namespace

int export_unit(const ExportOptions& options) {
  if (!scene::is_scene_file(options.scene.file))
    throw scene::InputError(options.scene.file,
                            "is no scene (.yaml), of which alone a unit is made");
  if (const std::string reason = why_no_archives(); !reason.empty())
    throw scene::InputError(options.out, reason);
  app::TerminalReporter reporter(options.quiet);
  const WorkFolder work;
  const fs::path resources = work.path() / "resources";
  const fs::path library = unit_library();  // It may be missing, and solutions take minutes.
  write_resources(options.scene, resources, reporter);
  const Unit unit = unit_of(resources, options.out, app::quiet());
  scene::Scene scene = unit.scene();
  scene.file = options.scene.file;
  std::vector<ArchiveEntry> entries = {
      {"modelDescription.xml", model_description(scene, unit.interface(), token_of(resources))},
      {fmt::format("binaries/{}/{}.so", kPlatform, model_identifier(scene)), bytes_of(library)}};
  std::ranges::move(entries_below(resources, "resources/"), std::back_inserter(entries));
  write_archive(work.path() / "unit", entries);
  const std::string bytes = bytes_of(work.path() / "unit");
  app::write_whole(options.out, bytes);
  if (!options.quiet)
    app::say(fmt::format("{}: {:.1f} MB, {}, {}, steps of {:.6g} s", options.out.string(),
                         static_cast<double>(bytes.size()) / 1e6,
                         app::counted(unit.interface().inputs().size(), "input", "inputs"),
                         app::counted(unit.interface().outputs().size(), "output", "outputs"),
                         scene.step));
  return app::kDone;
}

}  // namespace fmu
