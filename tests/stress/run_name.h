#pragma once

#include <array>
#include <string>
#include <vector>

/// @file
/// A run of the stress test by its parameters. Its name says all of them, as
/// `shape=cube density=0.5 …`, and is what repeats it.

namespace stress {

/// The parameters, in the order of a name. What their values mean stands in README.md.
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

/// A parameter and the values that the matrix gives it, the default first.
struct Dimension {
  Key key;
  std::string name;
  std::vector<std::string> values;
};

/// In the order of `Key`.
const std::vector<Dimension>& dimensions();

/// The values of all parameters.
class RunName {
 public:
  RunName();  ///< Every parameter at its default.

  const std::string& operator[](Key key) const { return values_[static_cast<std::size_t>(key)]; }
  RunName with(Key key, const std::string& value) const;

  /// A parameter's value as a number; a fraction such as 1/60 is one.
  /// @throws std::invalid_argument if it is none.
  double number(Key key) const;

  std::string text() const;
  bool operator==(const RunName&) const = default;

 private:
  std::array<std::string, kKeys> values_;
};

/// The run with the parameters that a text gives, the others at their default.
/// @throws std::invalid_argument for an unknown parameter or what is no `key=value`.
RunName parse_run(const std::string& text);

}  // namespace stress
