#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// @file
/// What a sweep varies, and the runs that come of it: all combinations, or a sample of them.

namespace app {

/// `Place::file` of a value that comes from `--vary`.
inline const char* const kVaryPlace = "--vary";

/// Most runs of a sweep: each has a folder and a row of the table.
inline constexpr std::size_t kMostRuns = 1'000'000;

/// One key of a scene and what it is to be.
struct SweepParameter {
  std::string key_path;             ///< As of an Override.
  std::vector<std::string> values;  ///< YAML, in their order; none if any number of a range is one.
  double first = 0;                 ///< The range then.
  double last = 0;
};

/// The values of one run, one a parameter.
using SweepPoint = std::vector<std::string>;

/// Splits `KEY.PATH=FIRST:LAST:STEP` (LAST is one of the values if whole steps lead there but for
/// rounding), `KEY.PATH=FIRST:LAST`, or `KEY.PATH=VALUE,VALUE,…` with values in YAML, whose own
/// commas stand in brackets, braces or quotes.
/// @throws InputError if it is none of them
SweepParameter parse_sweep_parameter(const std::string& argument);

/// All combinations; the last parameter changes from one run to the next.
/// @throws InputError for a range without steps, or more than kMostRuns combinations
std::vector<SweepPoint> grid(const std::vector<SweepParameter>& parameters);

/// A Latin hypercube: of each parameter, one sample in each of `samples` equal parts of its range;
/// of one with given values, each as often as any other to within one.
///
/// The same on every machine: the C++ standard says which numbers std::mt19937_64 gives, but not
/// what its distributions and std::shuffle make of them, so these are not used.
std::vector<SweepPoint> latin_hypercube(const std::vector<SweepParameter>& parameters,
                                        std::size_t samples, std::uint64_t seed);

}  // namespace app
