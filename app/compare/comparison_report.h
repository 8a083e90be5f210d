#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/compare/comparison.h"
#include "app/compare/provenance.h"

/// @file
/// Formats of a comparison of two runs.

namespace app {

/// The names of the two runs that the user gave.
struct ComparedFiles {
  std::string a;
  std::string b;
};

/// Describes where the logs of a body do not overlap; empty if they cover the same times.
std::string coverage(const BodyComparison& body, const ComparedFiles& files);

/// Returns `only in FILE`; empty if both have it.
std::string only_in(In in, const ComparedFiles& files);

/// Returns `ok`, `not judged`, `exceeds it from 0.4 s`, or `rms exceeds it`.
std::string verdict(const Difference& difference);

/// Returns the limits of a difference: `0.1`, `rms 0.01`, `0.1, rms 0.01`, or `-`.
std::string limits_text(const Difference& difference);

/// Returns a number as JSON; null for one that is infinite, which JSON does not have.
nlohmann::ordered_json finite_or_null(double number);

/// Names of quantities, or of tables for all of theirs, of all bodies together.
struct JudgedQuantities {
  std::vector<std::string> judged;
  std::vector<std::string> not_judged;  ///< They have no tolerance.
};
JudgedQuantities judged_quantities(const Comparison& comparison);

/// Returns `the same within tolerance` or `different`.
std::string verdict_text(bool same);
/// Does so and tells what was judged if that is not everything.
std::string verdict_text(const Comparison& comparison);

/// Returns which run is A and which B.
std::string names_text(const ComparedFiles& files);

/// Returns a line per body and quantity of the motion, and of each table the quantities that are
/// beyond their tolerance and a line about the others. Control characters in names stand as
/// escapes. @param color Use a terminal's colours.
std::string table_of(const Comparison& comparison, const ComparedFiles& files, bool color);

/// Returns `{"a": …, "b": …, "same": …, "judged": […], "not_judged": […], "differs": …, "bodies":
/// {NAME: {"same": …, QUANTITY: {"largest": …, …}}}, "tables": {TABLE: {"same": …, "names": {NAME:
/// {…}}}}}`.
/// @param provenance   Provenance of two run folders; none: not known.
nlohmann::ordered_json json_of(const Comparison& comparison, const ComparedFiles& files,
                               const std::optional<Provenance>& provenance);

/// Returns a JUnit test suite, which CI servers read, with a case per body or name and judged
/// quantity. It names A and B in its name and its properties.
std::string junit_suite_of(const Comparison& comparison, const ComparedFiles& files);

/// Returns a suite with one case, which failed: a run that was not compared.
std::string junit_suite_of_fault(const std::string& run, const std::string& fault,
                                 const ComparedFiles& files);

/// Returns suites as a file of JUnit.
std::string junit_file_of(const std::vector<std::string>& suites);

}  // namespace app
