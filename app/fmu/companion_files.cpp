#include "app/fmu/companion_files.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

namespace fmu {
namespace {

namespace fs = std::filesystem;

void add(const fs::path& source, const std::string& name, std::vector<Companion>& companions) {
  std::error_code error;
  if (fs::is_regular_file(source, error)) companions.push_back({source, name});
}

/// True for a path that stays below its folder.
bool stays_below(const fs::path& path) {
  return path.is_relative() && std::ranges::find(path, "..") == path.end();
}

void add_buffers(const fs::path& file, std::vector<Companion>& companions) {
  std::ifstream in(file, std::ios::binary);
  const nlohmann::json json = nlohmann::json::parse(in, nullptr, false);
  if (!json.is_object() || !json.contains("buffers") || !json["buffers"].is_array()) return;
  for (const nlohmann::json& buffer : json["buffers"]) {
    if (!buffer.is_object() || !buffer.contains("uri") || !buffer["uri"].is_string()) continue;
    const auto uri = buffer["uri"].get<std::string>();
    if (!uri.starts_with("data:") && stays_below(uri))
      add(file.parent_path() / uri, uri, companions);
  }
}

void add_wamit(const fs::path& file, std::vector<Companion>& companions) {
  for (const char* extension : {".3", ".hst"}) {
    fs::path other = file;
    other.replace_extension(extension);
    add(other, other.filename().string(), companions);
  }
}

void add_nemoh(const fs::path& file, std::vector<Companion>& companions) {
  const fs::path folder = fs::absolute(file).parent_path();
  std::vector<fs::path> tables;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".tec" && entry.path().filename() != file.filename())
      tables.push_back(entry.path());
  std::ranges::sort(tables);
  for (const fs::path& table : tables) add(table, table.filename().string(), companions);
  for (const fs::path& place : {folder, folder.parent_path()}) {
    const std::size_t before = companions.size();
    add(place / "Nemoh.cal", "Nemoh.cal", companions);
    if (companions.size() > before) return;
  }
}

}  // namespace

std::vector<Companion> companions_of(const fs::path& file) {
  std::vector<Companion> companions;
  const std::string extension = file.extension().string();
  if (extension == ".gltf") add_buffers(file, companions);
  if (extension == ".1") add_wamit(file, companions);
  if (extension == ".tec") add_nemoh(file, companions);
  return companions;
}

}  // namespace fmu
