#pragma once

#include <optional>
#include <string>
#include <vector>

namespace app {

/// Counts the single-letter changes, insertions, removals and swaps of neighbours that turn `a`
/// into `b` (optimal string alignment).
int edit_distance(const std::string& a, const std::string& b);

/// Returns the first of the candidates nearest to `word`; none if all are more than `most` changes
/// away.
std::optional<std::string> nearest(const std::string& word,
                                   const std::vector<std::string>& candidates, int most);

/// Returns `; did you mean X?` with the nearest candidate; empty if none is near.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates);

/// Joins words to `a, b or c`.
std::string enumerate(const std::vector<std::string>& words, const std::string& conjunction);

}  // namespace app
