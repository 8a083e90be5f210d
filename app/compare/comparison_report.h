#pragma once

#include <string>

#include "app/compare/comparison.h"

/// @file
/// Formats of a comparison of two trajectories.

namespace app {

/// The names of the two logs that the user gave.
struct ComparedFiles {
  std::string a;
  std::string b;
};

/// Describes where the logs of a body do not overlap; empty if they cover the same times.
std::string coverage(const BodyComparison& body, const ComparedFiles& files);

/// Returns `ok`, `not judged`, or `exceeds it from 0.4 s`.
std::string verdict(const Difference& difference);

/// Returns a line per body and quantity, and the verdict. @param color   Use a terminal's colours.
std::string table_of(const Comparison& comparison, const ComparedFiles& files, bool color);

/// Returns `{"same": …, "bodies": {NAME: {"same": …, QUANTITY: {"largest": …, …}}}}`.
std::string json_of(const Comparison& comparison, const ComparedFiles& files);

/// Returns a JUnit test suite, which CI servers read, with a case per body and judged quantity.
std::string junit_of(const Comparison& comparison, const ComparedFiles& files);

}  // namespace app
