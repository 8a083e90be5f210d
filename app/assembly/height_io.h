#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <optional>

namespace assembly {

/// Reads a grid of heights [m]. Rows run along y and columns along x: the first line of a table and
/// the top row of a picture lie at the field's origin, and y grows downward in both.
///
/// A PNG file, recognised by its first bytes, must be a grey picture of up to 16 bits a pixel; its
/// pixels are mapped linearly to heights, black to `range[0]` and white to `range[1]`. Any other
/// file is a table with one row per line and numbers separated by commas, semicolons or white
/// space; empty lines and text after a # are skipped.
/// @throws InputError if the file cannot be read; if a table has no number, rows of different
///     lengths, or an entry that is not a finite number (with line and column); if a picture has no
///     `range` or is not grey; or if a table has a `range`.
Eigen::MatrixXd read_heights(const std::filesystem::path& file,
                             const std::optional<std::array<double, 2>>& range = std::nullopt);

}  // namespace assembly
