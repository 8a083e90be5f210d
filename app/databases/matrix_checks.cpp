#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/databases/bad_ends.h"
#include "app/databases/bounds.h"
#include "app/databases/database_checks.h"
#include "hydro/added_mass/wetted_added_mass.h"
#include "hydro/decompositions.h"

namespace databases {
namespace {

using Eigen::Index;
using hydro::Matrix6d;

// Panel methods stay below what is noted; what is refused is of another body or convention.
constexpr Bounds kAsymmetry = {0.01, 0.1};
constexpr Bounds kNegative = {0.005, 0.05};

/// The matrices of one kind.
struct Kind {
  const char* name;
  std::vector<Matrix6d*> matrices;
  std::vector<double> frequencies;  ///< Infinite for A∞ [rad/s].

  double largest(double lever) const {
    double found = 0;
    for (const Matrix6d* matrix : matrices)
      found = std::max(found, weighted(*matrix, lever).cwiseAbs().maxCoeff());
    return found;
  }
};

/// Findings about one matrix.
struct Finding {
  double value = 0;   ///< Over the largest entry of the kind [-].
  std::string fault;  ///< Empty if the matrix is not refused.
};

Finding asymmetry(const Kind& kind, std::size_t f, double largest, double lever) {
  const Matrix6d& matrix = *kind.matrices[f];
  const Matrix6d scaled = weighted(matrix, lever);
  Index row = 0, column = 0;
  const double error = (scaled - scaled.transpose()).cwiseAbs().maxCoeff(&column, &row);
  Finding found{largest > 0 ? error / largest : 0, {}};
  if (error > kAsymmetry.refused * largest)
    found.fault = fmt::format(
        "{} at {:g} rad/s: found {:g} in row {}, column {} and {:g} in row {}, "
        "column {} (for water of density 1); expected a symmetric matrix",
        kind.name, kind.frequencies[f], matrix(row, column), row + 1, column + 1,
        matrix(column, row), column + 1, row + 1);
  return found;
}

/// Least eigenvalue of a matrix of the kind, made symmetric, over `largest`; 0 if none is negative.
Finding least_eigenvalue(const Kind& kind, std::size_t f, double largest, double lever) {
  if (!(largest > 0)) return {};
  const Matrix6d matrix = 0.5 * (*kind.matrices[f] + kind.matrices[f]->transpose());
  const auto parts = hydro::eigen_decomposition(weighted(matrix, lever));
  Index smallest = 0, row = 0;
  Finding found{std::min(0.0, parts.values.minCoeff(&smallest) / largest), {}};
  parts.vectors.col(smallest).cwiseAbs().maxCoeff(&row);
  if (found.value < -kNegative.refused)
    found.fault = fmt::format(
        "{} at {:g} rad/s: has an eigenvalue of {:.2g} % of its largest entry, most of it in row "
        "{}, column {} ({:g} for water of density 1); expected none below {:g} %",
        kind.name, kind.frequencies[f], 100 * found.value, row + 1, row + 1, matrix(row, row),
        -100 * kNegative.refused);
  return found;
}

using Look = Finding (*)(const Kind&, std::size_t, double, double);

/// Refuses the matrix that is worst, and notes how bad the worst of the others is.
void check(const Database& d, const Kind& kind, Look look, const std::string& name,
           const Bounds& bounds, double lever, BodyData& found) {
  const double largest = kind.largest(lever);
  double worst = 0;
  for (std::size_t f = 0; f < kind.matrices.size(); ++f) {
    const Finding each = look(kind, f, largest, lever);
    if (!each.fault.empty()) refuse(d, each.fault);
    if (std::abs(each.value) > std::abs(worst)) worst = each.value;
  }
  add_check(fmt::format("{} of {}", name, kind.name), worst, bounds, found);
}

void make_symmetric(const Kind& kind) {
  for (Matrix6d* matrix : kind.matrices) *matrix = (0.5 * (*matrix + matrix->transpose())).eval();
}

void make_semi_definite(const Kind& kind, double lever) {
  for (Matrix6d* matrix : kind.matrices) {
    if (hydro::eigenvalues(weighted(*matrix, lever)).minCoeff() >= 0) continue;
    const Matrix6d kept = hydro::semi_definite_part(weighted(*matrix, lever));
    *matrix = weighted(kept, 1 / lever);
  }
}

Kind kind_of(const char* name, std::vector<Matrix6d>& matrices, const Database& d) {
  Kind kind{name, {}, d.frequencies};
  for (Matrix6d& matrix : matrices) kind.matrices.push_back(&matrix);
  return kind;
}

/// The fault of each frequency; empty where there is none.
std::vector<std::string> faults_of(Database& d, double lever) {
  const Kind A = kind_of("added mass", d.added_mass, d), B = kind_of("damping", d.damping, d);
  std::vector<std::string> faults(d.frequencies.size());
  for (const auto& [kind, look] :
       {std::pair(&A, &asymmetry), std::pair(&B, &asymmetry), std::pair(&B, &least_eigenvalue)}) {
    const double largest = kind->largest(lever);
    for (std::size_t f = 0; f < faults.size(); ++f)
      if (faults[f].empty()) faults[f] = look(*kind, f, largest, lever).fault;
  }
  return faults;
}

/// Which frequencies lie outside those that are kept: `below 0.1 and above 4`.
std::string ends_in_words(const Database& d, const std::vector<bool>& kept) {
  std::size_t first = 0, last = kept.size() - 1;
  while (!kept[first]) ++first;
  while (!kept[last]) --last;
  std::vector<std::string> words;
  if (first > 0) words.push_back(fmt::format("below {:.4g}", d.frequencies[first]));
  if (last + 1 < kept.size()) words.push_back(fmt::format("above {:.4g}", d.frequencies[last]));
  return fmt::format("{}", fmt::join(words, " and "));
}

/// Which frequencies are not kept: `2.1, …, 5`.
std::string dropped_in_words(const Database& d, const std::vector<bool>& kept) {
  std::vector<double> dropped;
  for (std::size_t f = 0; f < kept.size(); ++f)
    if (!kept[f]) dropped.push_back(d.frequencies[f]);
  return in_words(dropped);
}

/// Leaves out the bad ends, if all that is bad lies in them, or else what is bad, if it is few. The
/// largest entry, by which all are judged, may be that of a bad matrix: what is left is judged
/// again.
void drop_bad_frequencies(Database& d, double lever, BodyData& found) {
  const double most = kMostDropped * static_cast<double>(d.frequencies.size());
  for (std::size_t dropped = 0;;) {
    const std::vector<std::string> faults = faults_of(d, lever);
    std::vector<bool> bad;
    for (const std::string& fault : faults) bad.push_back(!fault.empty());
    const auto first = std::ranges::find(bad, true);
    if (first == bad.end()) return;
    const auto& [kept, count, at_ends] = without_bad(bad);
    const bool first_ends = at_ends && dropped == 0;
    dropped += count;
    if (!first_ends && static_cast<double>(dropped) > most) return;  // It will be refused.
    found.notes.push_back(
        fmt::format("{} of {} frequencies are left out, {} rad/s; {}", count, kept.size(),
                    at_ends ? "those " + ends_in_words(d, kept) : dropped_in_words(d, kept),
                    faults[static_cast<std::size_t>(first - bad.begin())]));
    keep_frequencies(kept, d);
  }
}

}  // namespace

std::string in_words(const std::vector<double>& frequencies) {
  std::vector<std::string> words;
  for (const double frequency : frequencies) words.push_back(fmt::format("{:.4g}", frequency));
  if (words.size() > 5) words = {words.front(), "…", words.back()};
  return fmt::format("{}", fmt::join(words, ", "));
}

void add_check(const std::string& name, double value, const Bounds& bounds, BodyData& found) {
  found.checks.push_back({name, value});
  if (std::abs(value) > bounds.noted)
    found.notes.push_back(fmt::format("{} {:.2g} %", name, 100 * value));
}

Matrix6d weighted(const Matrix6d& matrix, double lever) {
  hydro::Vector6d weight = hydro::Vector6d::Ones();
  weight.tail<3>() /= lever;
  return weight.asDiagonal() * matrix * weight.asDiagonal();
}

void check_matrices(Database& d, double lever, BodyData& found) {
  drop_bad_frequencies(d, lever, found);
  Kind A = kind_of("added mass", d.added_mass, d);
  const Kind B = kind_of("damping", d.damping, d);
  Kind limit{"infinite added mass", {}, {}};
  if (d.infinite_added_mass)
    for (Kind* kind : {&A, &limit}) {
      kind->matrices.push_back(&*d.infinite_added_mass);
      kind->frequencies.push_back(std::numeric_limits<double>::infinity());
    }
  for (const Kind* kind : {&std::as_const(A), &B}) {
    check(d, *kind, &asymmetry, "asymmetry", kAsymmetry, lever, found);
    make_symmetric(*kind);
  }
  check(d, B, &least_eigenvalue, "least eigenvalue", kNegative, lever, found);
  make_semi_definite(B, lever);
  if (!d.infinite_added_mass) return;
  check(d, limit, &least_eigenvalue, "least eigenvalue", kNegative, lever, found);
  make_semi_definite(limit, lever);
}

}  // namespace databases
