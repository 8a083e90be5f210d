#pragma once

#include <string>
#include <vector>

namespace app {

/// Parses `FIRST:LAST:STEP`, both ends included, or `A,B,…`: numbers that ascend.
/// @param option   Name in faults, `--periods`.
/// @throws InputError for anything else, or for more than a thousand numbers
std::vector<double> parse_series(const std::string& option, const std::string& argument);

}  // namespace app
