#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// @file
/// Parameters of a sweep and the runs that they define: all combinations, or a sample of them.

namespace app {

/// `Place::file` of a value that comes from `--vary`.
inline const char* const kVaryPlace = "--vary";

/// Most runs of a sweep: each has a folder and a row of the table.
inline constexpr std::size_t kMostRuns = 1'000'000;

/// A key of a scene and its values.
struct SweepParameter {
  std::string key_path;             ///< Path of the key, as in an Override.
  std::vector<std::string> values;  ///< Values as YAML, in order; none: all numbers in a range.
  double first = 0;                 ///< Bounds of that range.
  double last = 0;
};

/// Values of one run, one per parameter.
using SweepPoint = std::vector<std::string>;

/// Splits `KEY.PATH=FIRST:LAST:STEP` (LAST is one of the values if whole steps lead there but for
/// rounding), `KEY.PATH=FIRST:LAST`, or `KEY.PATH=VALUE,VALUE,…` with values in YAML, whose own
/// commas stand in brackets, braces or quotes.
/// @throws InputError if the argument has none of these forms
SweepParameter parse_sweep_parameter(const std::string& argument);

/// Returns all combinations; the last parameter varies fastest.
/// @throws InputError for a range without steps, or more than kMostRuns combinations
std::vector<SweepPoint> grid(const std::vector<SweepParameter>& parameters);

/// Returns a Latin hypercube: each parameter has one sample in each of `samples` equal parts of its
/// range; listed values occur equally often to within one.
///
/// The result is the same on every machine: the C++ standard defines the numbers of
/// std::mt19937_64, but not the results of distributions and std::shuffle, so these are not used.
std::vector<SweepPoint> latin_hypercube(const std::vector<SweepParameter>& parameters,
                                        std::size_t samples, std::uint64_t seed);

}  // namespace app
