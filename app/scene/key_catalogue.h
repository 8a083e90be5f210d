#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

/// @file
/// Descriptions that the readers of the blocks give of their keys, for error messages, documents,
/// editors and shells.

namespace scene {

/// The type and limits of a value.
struct ValueShape {
  enum class Kind {
    number,
    whole,
    word,  ///< One of `words`.
    truth,
    off,   ///< Only `false`.
    text,  ///< Any text that is not empty.
    file,
    map,
    list
  };
  Kind kind = Kind::map;
  double lo = -std::numeric_limits<double>::infinity();  ///< Lower bound, in the scene's unit.
  double hi = std::numeric_limits<double>::infinity();
  bool above_lo = false;  ///< `lo` itself is refused.
  std::vector<std::string> words = {};
  std::vector<ValueShape> item = {};  ///< Shape of every entry of a list.
  std::size_t count = 0;              ///< Length of a list; 0: any length.
  std::size_t least = 0;              ///< Least length of a list of any length.
  bool distinct = false;              ///< No entry of a list may repeat.
};
ValueShape words_shape(const std::vector<std::string>& words);
ValueShape list_shape(const ValueShape& item, std::size_t count);

/// Placeholder in a path for the entries of a block whose keys the user names:
/// `render.cameras.NAME`.
inline constexpr const char* kAnyName = "NAME";

/// One key that a scene may have, as its reader describes it.
struct KeyDescription {
  std::string path;                ///< `bodies[].mass`
  std::string expected;            ///< Type, range and unit: `a positive number [kg]`.
  std::string fallback;            ///< Default value; `required` if the key must be given.
  std::vector<ValueShape> shapes;  ///< The value may have any of these shapes.
};

/// A group of keys of a block; exactly one of them must be present.
struct KeyChoice {
  std::string block;  ///< Path; empty for the whole scene.
  std::vector<std::string> keys;
};

/// A key of a block that needs or refuses others.
struct KeyCondition {
  std::string block;
  std::string key;
  std::string word;  ///< The condition holds for this value of the key; empty: for any value.
  std::vector<std::string> needed = {};
  std::vector<std::string> refused = {};
};

/// Every key, blocks before their contents, and the constraints between the keys of a block.
struct KeyCatalogue {
  std::vector<KeyDescription> keys;
  std::vector<KeyChoice> choices;
  std::vector<KeyCondition> conditions;
};
KeyCatalogue key_catalogue();

/// Returns the meaning of a key as Markdown. @param path   Path in the catalogue.
/// @throws std::out_of_range for a key that is not described
std::string key_meaning(const std::string& path);
/// Returns the path that describes a block which occurs in several places: `hydro.lift` for
/// `bodies[].hydro.lift`.
std::string described_path(const std::string& path);
/// Returns every path that has a meaning.
std::vector<std::string> described_paths();

}  // namespace scene
