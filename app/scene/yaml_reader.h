#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

/// @file
/// YAML text as a tree of plain values. The tree keeps details that the YAML library hides: places
/// counted from 1, quotes, repeated keys, and scalars as they are written.

namespace scene {

/// Bounds what the texts of one scene grow to by aliases, variables and copies [bytes]. A scene of
/// ten thousand bodies has a few MiB.
constexpr std::size_t kMostText = std::size_t{64} << 20;

/// A place in the text, counted from 1; line 0: not from a file.
struct Mark {
  int line = 0;
  int column = 0;
  std::shared_ptr<const std::filesystem::path> file = {};  ///< Null: that of the scene.
};

struct YamlEntry;

/// A value and everything below it. Aliases are replaced by their values, merge keys (`<<`) by the
/// entries they insert.
struct YamlNode {
  enum class Kind { null, scalar, list, map };
  Kind kind = Kind::null;
  Mark mark;            ///< Place of the first letter; for a null in a map, the place of its key.
  std::string text;     ///< A scalar as written.
  bool quoted = false;  ///< The scalar is a text even if it looks like a number.
  std::vector<YamlNode> items;     ///< Entries of a list.
  std::vector<YamlEntry> entries;  ///< In file order; keys may repeat.

  bool is(Kind which) const { return kind == which; }
  /// True for the scalar `word`, in quotes or without.
  bool is_word(const char* word) const { return is(Kind::scalar) && text == word; }
  /// True for the unquoted scalar `true` or `false`.
  bool is_truth(bool truth) const {
    return is(Kind::scalar) && !quoted && text == (truth ? "true" : "false");
  }
  /// Returns the value of the first entry with this key; null if there is none.
  const YamlNode* find(const std::string& key) const;
};

struct YamlEntry {
  std::string key;
  Mark mark;  ///< Place of the key.
  YamlNode value;
};

/// Reads the text of a file.
/// @throws InputError if it is missing, not a regular file, over 8 MiB, or not UTF-8 text.
std::string read_text(const std::filesystem::path& file);

/// Parses one YAML document; text without content gives a null node.
/// @param file   File named in faults.
/// @throws InputError if it is not valid YAML, has several documents, nests deeper than 60 levels,
///     grows beyond 500 000 values or kMostText through its aliases, or has keys that are not plain
///     words.
YamlNode parse_yaml(const std::string& text, const std::filesystem::path& file);

}  // namespace scene
