#include "engine/rig/moordyn/moordyn_files.h"

#include <stdlib.h>

#include <algorithm>
#include <fstream>
#include <istream>

#include "engine/rig/moordyn/moordyn_system.h"

namespace engine {

namespace fs = std::filesystem;

namespace {

/// A line of MoorDyn's log without the place in its source, and with the name of the scene's file.
std::string message_in(const std::string& line, const fs::path& copy, const fs::path& file) {
  const std::size_t place = line.find("(): ");
  std::string text = place == std::string::npos ? line.substr(4) : line.substr(place + 4);
  const std::string name = copy.string();
  if (const std::size_t at = text.find(name); at != std::string::npos)
    text.replace(at, name.size(), file.filename().string());
  text.erase(0, std::min(text.find_first_not_of(" \t"), text.size()));
  if (text.starts_with("Warning: ")) text.erase(0, 9);
  while (text.ends_with(' ') || text.ends_with('\r')) text.pop_back();
  return text;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "plimsoll_moordyn_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw MoorDynFault("no folder can be made in " + fs::temp_directory_path().string());
  path_ = name;
}

void TemporaryFolder::remove() {
  std::error_code error;
  if (!path_.empty()) fs::remove_all(path_, error);
  path_.clear();
}

fs::path write_copy(const fs::path& file, const std::string& text, const fs::path& folder) {
  std::error_code error;
  const fs::path beside = fs::absolute(file, error).parent_path();
  for (const auto& entry : fs::directory_iterator(beside, error))
    fs::create_symlink(entry.path(), folder / entry.path().filename(), error);
  const fs::path copy = folder / "plimsoll_moordyn.txt";
  fs::remove(copy, error);
  std::ofstream stream(copy);
  stream << text;
  stream.close();
  if (!stream) throw MoorDynFault(copy.string() + " cannot be written");
  return copy;
}

fs::path log_of(const fs::path& copy) { return fs::path(copy).replace_extension(".log"); }

Messages messages_in(std::istream& log, const fs::path& copy, const fs::path& file) {
  Messages messages;
  std::string* last = nullptr;  // The message that further lines continue.
  for (std::string line; std::getline(log, line);) {
    const bool error = line.starts_with("ERR ");
    if (error || line.starts_with("WRN ")) {
      std::vector<std::string>& list = error ? messages.errors : messages.warnings;
      last = &list.emplace_back(message_in(line, copy, file));
    } else if (last && !line.empty()) {
      *last += (last->empty() ? "" : " ") + line;
    }
  }
  return messages;
}

}  // namespace engine
