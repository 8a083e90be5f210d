#pragma once

#include <string>

#include "app/compare/comparison.h"

/// @file
/// A comparison of two trajectories as its readers want it.

namespace app {

/// What was compared, as the user named it.
struct ComparedFiles {
  std::string a;
  std::string b;
};

/// Where and how the logs of a body do not cover each other; empty if they do.
std::string coverage(const BodyComparison& body, const ComparedFiles& files);

/// `ok`, `not judged`, `exceeds it from 0.4 s`.
std::string verdict(const Difference& difference);

/// A line a body and quantity, and the verdict. @param color   With a terminal's colours.
std::string table_of(const Comparison& comparison, const ComparedFiles& files, bool color);

/// `{"same": …, "bodies": {NAME: {"same": …, QUANTITY: {"largest": …, …}}}}`
std::string json_of(const Comparison& comparison, const ComparedFiles& files);

/// A test suite with a case a body and judged quantity, in the form that CI servers read.
std::string junit_of(const Comparison& comparison, const ComparedFiles& files);

}  // namespace app
