#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

/// @file
/// What the readers of the blocks say of the keys that they read, for advice, documents, editors
/// and shells.

namespace scene {

/// What a value may be.
struct ValueShape {
  enum class Kind {
    number,
    whole,
    word,  ///< One of some.
    truth,
    off,   ///< `false` alone.
    text,  ///< Not empty.
    file,
    map,
    list
  };
  Kind kind = Kind::map;
  double lo = -std::numeric_limits<double>::infinity();  ///< Of a number, in the scene's unit.
  double hi = std::numeric_limits<double>::infinity();
  bool above_lo = false;  ///< `lo` itself is refused.
  std::vector<std::string> words = {};
  std::vector<ValueShape> item = {};  ///< Of a list: the shape of every entry.
  std::size_t count = 0;              ///< Of a list; 0: any number of entries.
  std::size_t least = 0;              ///< Of a list of any number.
  bool distinct = false;              ///< Of a list: no entry twice.
};
ValueShape words_shape(const std::vector<std::string>& words);
ValueShape list_shape(const ValueShape& item, std::size_t count);

/// What stands in a path for the entries of a block whose keys the user names:
/// `render.cameras.NAME`.
inline constexpr const char* kAnyName = "NAME";

/// One key that a scene may have, as its reader describes it.
struct KeyDescription {
  std::string path;                ///< `bodies[].mass`
  std::string expected;            ///< Type, range and unit: `a positive number [kg]`.
  std::string fallback;            ///< What holds without the key; `required` if it must be given.
  std::vector<ValueShape> shapes;  ///< Any of these.
};

/// Exactly one of these keys of a block is there.
struct KeyChoice {
  std::string block;  ///< Path; empty for the whole scene.
  std::vector<std::string> keys;
};

/// A key of a block that needs or refuses others.
struct KeyCondition {
  std::string block;
  std::string key;
  std::string word;  ///< Where the key has this value; empty: where it is there at all.
  std::vector<std::string> needed = {};
  std::vector<std::string> refused = {};
};

/// Every key, blocks before what stands in them, and how the keys of a block go together.
struct KeyCatalogue {
  std::vector<KeyDescription> keys;
  std::vector<KeyChoice> choices;
  std::vector<KeyCondition> conditions;
};
KeyCatalogue key_catalogue();

/// What a key is for, as Markdown. @param path   Of the catalogue.
/// @throws std::out_of_range for a key that is not described
std::string key_meaning(const std::string& path);
/// The block that a block is described with where it stands again elsewhere: `hydro.lift` of
/// `bodies[].hydro.lift`.
std::string described_path(const std::string& path);
/// Every path that has a meaning.
std::vector<std::string> described_paths();

}  // namespace scene
