#include "app/assembly/mesh_mending.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "app/base/quoting.h"
#include "hydro/mesh/mending/diagnosis.h"

namespace assembly {
namespace {

/// Most faces of a mesh for which remedies are tried: each takes a second per 300,000.
constexpr Eigen::Index kMostTried = 300'000;

std::string joined_words(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

}  // namespace

bool asks_for_mending(const scene::Mending& mending) { return mending != scene::Mending(); }

hydro::MendOptions mend_options(const scene::Mending& mending) {
  return {.weld = mending.weld,
          .cap = mending.cap,
          .mirror = mending.mirror,
          .unite = mending.unite,
          .thickness = mending.thickness};
}

MendingRecord mending_record(const hydro::TriMesh& before, const hydro::MendedMesh& after) {
  MendingRecord record{
      .volume_before = std::nullopt, .volume_after = after.report.volume, .changes = after.changes};
  if (const hydro::MeshReport report = check_mesh(before); report.closed())
    record.volume_before = report.volume;
  return record;
}

std::string words_of(const hydro::MendOptions& options, const hydro::TriMesh& mesh,
                     RemedyWords words) {
  const bool keys = words == RemedyWords::keys;
  const bool others = options.cap || options.mirror || options.unite || options.thickness;
  const bool wide = options.weld && *options.weld > 2 * hydro::default_weld(mesh);
  std::vector<std::string> all;
  if (!keys) all.push_back("--repair");
  if (wide || (keys && options.weld && !others))
    all.push_back(fmt::format("{}{:g}", keys ? "weld: " : "--weld ", *options.weld));
  if (options.cap) all.push_back(keys ? "cap: true" : "--cap");
  if (options.mirror)
    all.push_back(fmt::format("{}{}", keys ? "mirror: " : "--mirror ", "xyz"[*options.mirror]));
  if (options.unite) all.push_back(keys ? "unite: true" : "--unite");
  if (options.thickness)
    all.push_back(fmt::format("{}{:g}", keys ? "thickness: " : "--thickness ", *options.thickness));
  return joined_words(all, keys ? ", " : " ");
}

std::string remedy_text(const hydro::TriMesh& mesh, const std::filesystem::path& file,
                        RemedyWords words) {
  const std::string name = app::shell_word(file.string());
  const std::string look = fmt::format("`plimsoll mesh {}` says more of it", name);
  if (mesh.face_count() > kMostTried || !mesh.vertices.allFinite()) return look;
  const std::optional<hydro::Remedy> remedy = hydro::remedy_for(mesh);
  if (!remedy) return look;
  const std::string how = words_of(remedy->options, mesh, words);
  if (words == RemedyWords::keys)
    return fmt::format("with `{}` beside `file` it is a solid of {:.4g} m^3", how, remedy->volume);
  return fmt::format("`plimsoll mesh {} {} -o solid.obj` makes a solid of {:.4g} m^3 of it", name,
                     how, remedy->volume);
}

}  // namespace assembly
