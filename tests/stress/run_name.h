#pragma once

#include <array>
#include <string>
#include <vector>

/// @file
/// A run of the stress test, defined by its parameters. Its name lists them as `shape=cube
/// density=0.5 …` and suffices to repeat the run.

namespace stress {

/// Parameters in the order of a name. README.md explains their values.
enum class Key {
  shape,
  density,
  size,
  speed,
  entry,
  spin,
  pose,
  start,
  step,
  water,
  coefs,
  added,
  with,
  steps
};
inline constexpr std::size_t kKeys = 14;

/// A parameter and its values in the matrix, the default first.
struct Dimension {
  Key key;
  std::string name;
  std::vector<std::string> values;
};

/// Returns the parameters in the order of `Key`.
const std::vector<Dimension>& dimensions();

/// Values of all parameters.
class RunName {
 public:
  RunName();  ///< Every parameter at its default.

  const std::string& operator[](Key key) const { return values_[static_cast<std::size_t>(key)]; }
  RunName with(Key key, const std::string& value) const;

  /// Returns a parameter's value as a number, which may be a fraction such as 1/60.
  /// @throws std::invalid_argument if it is no number.
  double number(Key key) const;

  std::string text() const;
  bool operator==(const RunName&) const = default;

 private:
  std::array<std::string, kKeys> values_;
};

/// Returns the run with the parameters in a text and defaults for the others.
/// @throws std::invalid_argument for an unknown parameter or a word that is not `key=value`.
RunName parse_run(const std::string& text);

}  // namespace stress
