#include "app/scene/include.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "app/scene/diagnostics.h"
#include "app/scene/key_catalogue.h"

namespace scene {
namespace {

namespace fs = std::filesystem;

/// Files below this depth are refused before their chain is found to be endless.
constexpr std::size_t kDeepestInclude = 16;

void set_file(YamlNode& node, const std::shared_ptr<const fs::path>& file) {
  node.mark.file = file;
  for (YamlNode& item : node.items) set_file(item, file);
  for (YamlEntry& entry : node.entries) {
    entry.mark.file = file;
    set_file(entry.value, file);
  }
}

bool is_list_of_maps(const YamlNode& node) {
  return node.is(YamlNode::Kind::list) && !node.items.empty() &&
         std::ranges::all_of(node.items,
                             [](const YamlNode& item) { return item.is(YamlNode::Kind::map); });
}

YamlNode* named_like(YamlNode& list, const YamlNode& item) {
  const YamlNode* name = item.find("name");
  if (name == nullptr) return nullptr;
  for (YamlNode& other : list.items)
    if (const YamlNode* its = other.find("name"); its != nullptr && its->text == name->text)
      return &other;
  return nullptr;
}

/// Puts a value over an earlier one.
void put_over(YamlNode over, YamlNode& node) {
  if (over.is(YamlNode::Kind::map) && node.is(YamlNode::Kind::map)) {
    for (YamlEntry& entry : over.entries) {
      const auto known = std::ranges::find(node.entries, entry.key, &YamlEntry::key);
      if (known == node.entries.end())
        node.entries.push_back(std::move(entry));
      else if (entry.value.is(YamlNode::Kind::null))
        node.entries.erase(known);
      else
        put_over(std::move(entry.value), known->value);
    }
  } else if (is_list_of_maps(over) && is_list_of_maps(node)) {
    for (YamlNode& item : over.items) {
      if (YamlNode* known = named_like(node, item))
        put_over(std::move(item), *known);
      else
        node.items.push_back(std::move(item));
    }
  } else {
    node = std::move(over);
  }
}

/// Returns the paths in the catalogue whose values are files: `bodies[].mesh.file`.
std::vector<std::string> paths_of_files() {
  std::vector<std::string> paths;
  for (const KeyDescription& key : key_catalogue().keys)
    for (const ValueShape& shape : key.shapes)
      if (shape.kind == ValueShape::Kind::file && key.path != kInclude) paths.push_back(key.path);
  return paths;
}

/// Writes the paths of files below a value anew. @param path   Path of the value in the catalogue.
void rebase(YamlNode& node, const std::string& path, const std::vector<std::string>& files,
            const fs::path& folder) {
  if (node.is(YamlNode::Kind::scalar) && std::ranges::find(files, path) != files.end() &&
      !node.text.empty() && fs::path(node.text).is_relative())
    node.text = (folder / node.text).generic_string();
  for (YamlNode& item : node.items) rebase(item, path + "[]", files, folder);
  for (YamlEntry& entry : node.entries)
    rebase(entry.value, path.empty() ? entry.key : path + "." + entry.key, files, folder);
}

/// The files of a scene that are being read.
class Inclusion {
 public:
  explicit Inclusion(const fs::path& scene) : scene_(scene) {}

  /// @param folder   Folder of the tree's file, relative to the folder of the scene.
  void resolve(YamlNode& root, const fs::path& folder, std::vector<fs::path> chain) {
    const auto entry = std::ranges::find(root.entries, kInclude, &YamlEntry::key);
    if (entry == root.entries.end()) return;
    const YamlNode names = std::move(entry->value);
    root.entries.erase(entry);
    YamlNode all = root;
    all.entries.clear();
    if (names.is(YamlNode::Kind::list)) {
      for (const YamlNode& name : names.items) put_over(read(name, folder, chain), all);
    } else {
      put_over(read(names, folder, chain), all);
    }
    std::vector<std::string> own;
    for (const YamlEntry& e : root.entries) own.push_back(e.key);
    put_over(std::move(root), all);
    root = std::move(all);
    std::ranges::stable_sort(root.entries, {}, [&](const YamlEntry& e) {
      return std::ranges::find(own, e.key) - own.begin();  // the keys of the tree in its order
    });
  }

 private:
  [[noreturn]] void refuse(const YamlNode& node, const std::string& message) const {
    const fs::path& in = node.mark.file ? *node.mark.file : scene_;
    const Place place =
        node.mark.line > 0 ? Place{in, node.mark.line, node.mark.column} : Place{kOverridePlace};
    throw InputError({Fault{place, kInclude, message}});
  }

  YamlNode read(const YamlNode& name, const fs::path& folder, std::vector<fs::path> chain) const {
    if (!name.is(YamlNode::Kind::scalar) || name.text.empty())
      refuse(name, "expected the path of a file, or a list of such");
    const fs::path from_scene = (folder / name.text).lexically_normal();
    const fs::path file = (scene_.parent_path() / from_scene).lexically_normal();
    std::error_code error;
    // The system takes a path to its first NUL.
    if (name.text.find('\0') != std::string::npos || !fs::is_regular_file(file, error))
      refuse(name, fmt::format("found {}, expected a file; there is none of this name (relative to "
                               "the folder of the file that includes it)",
                               name.text));
    const fs::path real = fs::weakly_canonical(file, error);
    if (std::ranges::find(chain, real) != chain.end() || chain.size() > kDeepestInclude)
      refuse(name, fmt::format("{} includes itself", name.text));
    chain.push_back(real);
    YamlNode root = parse_yaml(read_text(file), file);
    set_file(root, std::make_shared<const fs::path>(file));
    if (!root.is(YamlNode::Kind::map)) refuse(name, name.text + " is no map of keys");
    if (from_scene.has_parent_path()) rebase(root, "", paths_of_files(), from_scene.parent_path());
    Inclusion(*this).resolve(root, from_scene.parent_path(), chain);
    return root;
  }

  const fs::path& scene_;
};

}  // namespace

void include_files(YamlNode& root, const fs::path& file) {
  std::error_code error;
  Inclusion(file).resolve(root, {}, {fs::weakly_canonical(file, error)});
}

}  // namespace scene
