#include "app/base/words.h"

#include <algorithm>

namespace app {

namespace {

/// Returns the number of slips to allow: half the letters of a word of up to three letters, and a
/// third of the letters of a longer word, but at least two.
int usual_limit(const std::string& word) {
  const int letters = static_cast<int>(word.size());
  if (letters < 4) return letters / 2;
  return std::max(2, letters / 3);
}

}  // namespace

int edit_distance(const std::string& a, const std::string& b) {
  const std::size_t columns = b.size() + 1;
  std::vector<int> table((a.size() + 1) * columns);
  const auto cell = [&](std::size_t i, std::size_t j) -> int& { return table[i * columns + j]; };
  for (std::size_t i = 0; i <= a.size(); ++i) cell(i, 0) = static_cast<int>(i);
  for (std::size_t j = 0; j <= b.size(); ++j) cell(0, j) = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int change = a[i - 1] == b[j - 1] ? 0 : 1;
      cell(i, j) = std::min({cell(i - 1, j) + 1, cell(i, j - 1) + 1, cell(i - 1, j - 1) + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        cell(i, j) = std::min(cell(i, j), cell(i - 2, j - 2) + 1);
    }
  }
  return table.back();
}

std::optional<std::string> nearest(const std::string& word,
                                   const std::vector<std::string>& candidates, int most) {
  std::optional<std::string> best;
  for (const std::string& candidate : candidates) {
    const std::size_t lengths[] = {word.size(), candidate.size()};
    if (std::max(lengths[0], lengths[1]) - std::min(lengths[0], lengths[1]) >
        static_cast<std::size_t>(most))
      continue;
    const int distance = edit_distance(word, candidate);
    if (distance > most) continue;
    best = candidate;
    most = distance - 1;
  }
  return best;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates) {
  const auto candidate = nearest(word, candidates, usual_limit(word));
  return candidate ? "; did you mean " + *candidate + "?" : "";
}

std::string enumerate(const std::vector<std::string>& words, const std::string& conjunction) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " " + conjunction + " " : ", ";
    text += words[i];
  }
  return text;
}

}  // namespace app
