#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/scene/rig.h"
#include "engine/base/rig_spec.h"

/// @file
/// Functions of time for set points: formulas and tables.

namespace assembly {

/// A formula in the time. @throws FormulaError if the text is no formula
std::shared_ptr<const engine::Signal> formula_signal(const std::string& text);

/// A table over time.
/// @param times           Rising [s], at least one.
/// @param values          One for each time; the first holds before them, and the last after them.
/// @param interpolation   Between the rows; a step is taken at the time of its row.
std::shared_ptr<const engine::Signal> table_signal(std::vector<double> times,
                                                   std::vector<double> values,
                                                   scene::Interpolation interpolation);

/// Reads a table over time (column_file.h): the column `time` [s] and that of the command, by
/// default the first other one.
/// @throws InputError if the table cannot be read, lacks a column or has no row, or if times do not
///     rise (with the line)
std::shared_ptr<const engine::Signal> read_signal(const scene::CommandFile& command);

}  // namespace assembly
