#pragma once

#include <Eigen/Core>

#include "hydro/added_mass/bem/lanes.h"

/// @file
/// Products of eight columns of a matrix with six vectors at a time, in the widest vector registers
/// that the processor has. Every sum is taken in one order, without fused operations, so that the
/// results are the same for all widths.

namespace hydro::bem {

/// Columns of the matrix taken at a time: one after another, each sum would wait for its last
/// addition.
inline constexpr Eigen::Index kColumns = 8;

/// A row of six numbers and two zeros.
struct alignas(kAligned) Row {
  Lanes lanes = {};
};

/// kColumns columns of a matrix by their first `rows` numbers, `stride` numbers apart.
struct EightColumns {
  const double* first;
  Eigen::Index stride;
  Eigen::Index rows;
};

/// sums[c] = Σ_i columns(i, c) x[i].
void dot_columns(const EightColumns& columns, const Row* x, Row* sums);

/// y[i] += Σ_c columns(i, c) factors[c].
void add_columns(const EightColumns& columns, const Row* factors, Row* y);

/// Both at once: each number of the matrix is read once.
void dot_and_add_columns(const EightColumns& columns, const Row* x, Row* y, const Row* factors,
                         Row* sums);

}  // namespace hydro::bem
