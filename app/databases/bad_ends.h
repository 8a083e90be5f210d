#pragma once

#include <cstddef>
#include <vector>

namespace databases {

/// Marks the low and the high end of a list that are bad: at most a third of the list each, from
/// its first or last entry to a bad one, with bad ones for half of it or more. Panel methods fail
/// so at frequencies for which the panels are too large, or the numbers too small.
std::vector<bool> bad_ends(const std::vector<bool>& bad);

/// A list without its bad entries.
struct KeptEntries {
  std::vector<bool> kept;
  std::size_t dropped = 0;
  bool at_ends = false;  ///< All that is bad lies in the bad ends, which are left out whole.
};
KeptEntries without_bad(const std::vector<bool>& bad);

}  // namespace databases
