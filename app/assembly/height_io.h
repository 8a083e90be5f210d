#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <optional>

namespace assembly {

/// Reads a grid of heights [m]; row index = y, column index = x, so the first line of a table and
/// the top row of a picture lie at the field's origin, and y grows downward in both.
///
/// A file that starts as a PNG does must be a grey picture of up to 16 bits a pixel; its pixels are
/// mapped linearly to heights, black to `range[0]` and white to `range[1]`. Any other file is a
/// table of numbers: one row a line, separated by commas, semicolons or white space; empty lines
/// and what follows a # are skipped.
/// @throws InputError if the file cannot be read, a table has no number, rows of different lengths
/// or
///         something else than finite numbers (with line and column), a picture has no `range` or
///         is not grey, or a table has a `range`.
Eigen::MatrixXd read_heights(const std::filesystem::path& file,
                             const std::optional<std::array<double, 2>>& range = std::nullopt);

}  // namespace assembly
