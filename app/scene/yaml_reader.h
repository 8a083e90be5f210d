#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// @file
/// YAML text as a tree of plain values. What the YAML library makes hard to see is kept: places
/// counted from 1, quotes, repeated keys, and scalars as they are written.

namespace scene {

/// A place in the text, counted from 1; line 0: not from a file.
struct Mark {
  int line = 0;
  int column = 0;
};

struct YamlEntry;

/// A value and everything below it. Aliases are replaced by what they stand for, merge keys (`<<`)
/// by the keys they bring.
struct YamlNode {
  enum class Kind { null, scalar, list, map };
  Kind kind = Kind::null;
  Mark mark;                       ///< Of the first letter; for a null in a map, of its key.
  std::string text;                ///< Of a scalar, as written.
  bool quoted = false;             ///< A text even if it looks like a number.
  std::vector<YamlNode> items;     ///< Of a list.
  std::vector<YamlEntry> entries;  ///< Of a map, in the order of the file; a key may be repeated.

  bool is(Kind which) const { return kind == which; }
  /// The unquoted scalar `word`.
  bool is_word(const char* word) const { return is(Kind::scalar) && !quoted && text == word; }
  /// The value of the first entry with this key; null if there is none.
  const YamlNode* find(const std::string& key) const;
};

struct YamlEntry {
  std::string key;
  Mark mark;  ///< Of the key.
  YamlNode value;
};

/// The whole text of a file.
/// @throws InputError if it is missing, no ordinary file, over 8 MiB, or not UTF-8 text.
std::string read_text(const std::filesystem::path& file);

/// Parses one YAML document; text without content gives a null node.
/// @param file   Named in faults.
/// @throws InputError if it is not valid YAML, has several documents, nests deeper than 60 levels,
///     grows beyond 500 000 values through its aliases, or has keys that are no plain words.
YamlNode parse_yaml(const std::string& text, const std::filesystem::path& file);

}  // namespace scene
