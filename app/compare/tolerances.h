#pragma once

#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

/// @file
/// Tolerances of a comparison, from the command line or from a file of YAML.

namespace app {

/// Limits within which a quantity counts as equal. A quantity without any limit is not judged.
struct Tolerance {
  static constexpr double kNone = std::numeric_limits<double>::infinity();

  double peak = kNone;      ///< Largest difference at any time, in the quantity's unit.
  double rms = kNone;       ///< Root mean square of the difference over all times, in that unit.
  double relative = kNone;  ///< Added to `peak`: a share of the largest size of the quantity in A.

  bool judges() const { return peak != kNone || rms != kNone || relative != kNone; }
  /// Returns the largest difference that is allowed where the quantity is of this size: the sum of
  /// `peak` and the share; kNone if neither is given.
  double peak_limit(double size) const;

  bool operator==(const Tolerance&) const = default;
};

/// The tolerances of a comparison.
struct Tolerances {
  static constexpr double kDefault = 1e-9;
  /// Key: a quantity, as `position` or `forces.buoyancy`, or a table, as `forces`, for all of it.
  using Quantities = std::map<std::string, Tolerance>;

  Quantities all;
  std::map<std::string, Quantities> bodies;  ///< By name of a body, line, joint, …

  /// Returns the tolerance of a quantity: the nearest that is given, of the name before that of
  /// all, of the quantity before that of its table. If none is given at all it is kDefault, and for
  /// tables kDefault and a share of kDefault of the size; if only others are given, the quantity is
  /// not judged.
  Tolerance of(const std::string& name, const std::string& quantity) const;
};

/// Reads tolerances of the command line, `position=1e-6`, `forces.buoyancy.rms=10`.
/// @throws InputError that names what is unknown and the nearest quantity
Tolerances parse_tolerances(const std::vector<std::string>& arguments);

/// Reads tolerances from YAML: `QUANTITY: NUMBER` (the peak) or `QUANTITY: {peak: …, rms: …,
/// relative: …}`; `TABLE: {QUANTITY: …}`, where a number or peak, rms and relative hold for all of
/// the table; and `bodies: {NAME: {…}}` with the same for one name.
/// @throws InputError with all faults
Tolerances read_tolerances(const std::filesystem::path& file);

/// Returns tolerances as YAML, which reads back to the same.
std::string yaml_of(const Tolerances& tolerances);

}  // namespace app
