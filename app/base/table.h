#pragma once

#include <string>
#include <vector>

namespace app {

/// The cells of one row of a table.
using Cells = std::vector<std::string>;

/// Lays out a table as text: each column is as wide as its widest cell, columns stand two spaces
/// apart, and lines are indented by two spaces. The first column is flush left, the others flush
/// right. @param rows   At least one; none has more cells than the first.
std::vector<std::string> aligned_lines(const std::vector<Cells>& rows);

}  // namespace app
