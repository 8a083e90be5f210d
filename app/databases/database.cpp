#include "app/databases/database.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/scene/diagnostics.h"

namespace databases {
namespace {

using Eigen::Index;

template <class T>
std::vector<T> in_order(const std::vector<T>& given, const std::vector<std::size_t>& order) {
  std::vector<T> sorted;
  if (!given.empty())
    for (const std::size_t i : order) sorted.push_back(given[i]);
  return sorted;
}

/// Puts the frequencies in an order, which may lack some.
void take(const std::vector<std::size_t>& order, Database& d) {
  d.frequencies = in_order(d.frequencies, order);
  d.added_mass = in_order(d.added_mass, order);
  d.damping = in_order(d.damping, order);
  d.neighbours = in_order(d.neighbours, order);
  for (auto* loads : {&d.excitation, &d.froude_krylov, &d.diffraction})
    *loads = in_order(*loads, order);
}

template <class Derived>
void check_finite(const Database& d, const char* what, double frequency,
                  const Eigen::MatrixBase<Derived>& matrix) {
  for (Index j = 0; j < matrix.cols(); ++j)
    for (Index i = 0; i < matrix.rows(); ++i)
      if (!std::isfinite(std::abs(matrix(i, j))))
        refuse(d, fmt::format("{} at {:g} rad/s, row {}, column {}: expected a finite number", what,
                              frequency, i + 1, j + 1));
}

void check_finite(const Database& d) {
  const double infinite = std::numeric_limits<double>::infinity();
  if (d.infinite_added_mass) check_finite(d, "added mass", infinite, *d.infinite_added_mass);
  for (std::size_t f = 0; f < d.frequencies.size(); ++f) {
    const double omega = d.frequencies[f];
    check_finite(d, "added mass", omega, d.added_mass[f]);
    check_finite(d, "damping", omega, d.damping[f]);
    const auto check_loads = [&](const char* what, const std::vector<hydro::Loads6cd>& loads) {
      if (!loads.empty()) check_finite(d, what, omega, loads[f]);
    };
    check_loads("excitation", d.excitation);
    check_loads("Froude-Krylov force", d.froude_krylov);
    check_loads("diffraction force", d.diffraction);
  }
}

}  // namespace

void refuse(const Database& database, const std::string& message) {
  throw scene::InputError(database.files.front(), message);
}

Database read_database(const scene::RadiationFile& source, double gravity) {
  const std::string extension = source.file.extension().string();
  if (extension == ".nc") return read_capytaine(source);
  if (extension == ".h5" || extension == ".hdf5") return read_bemio(source);
  if (extension == ".1") return read_wamit(source, gravity);
  if (extension == ".tec") return read_nemoh(source);
  throw scene::InputError(source.file,
                          "expected a file .nc of Capytaine, .h5 of BEMIO, .1 of WAMIT or "
                          "RadiationCoefficients.tec of Nemoh");
}

void settle(Database& d) {
  std::vector<std::size_t> order;
  std::size_t missing = 0;
  for (std::size_t i = 0; i < d.frequencies.size(); ++i) {
    const double omega = d.frequencies[i];
    if (d.added_mass[i].array().isNaN().all()) {  // It could not be solved.
      ++missing;
      continue;
    }
    if (std::isnan(omega) || omega < 0)
      refuse(d, fmt::format("found the frequency {:g} rad/s, expected one >= 0", omega));
    if (std::isinf(omega)) d.infinite_added_mass = d.added_mass[i];
    if (omega > 0 && std::isfinite(omega)) order.push_back(i);
  }
  if (missing > 0)
    d.notes.push_back(fmt::format("{} of {} frequencies have no numbers and are left out", missing,
                                  d.frequencies.size()));
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return d.frequencies[a] < d.frequencies[b]; });
  take(order, d);
  const auto twice = std::adjacent_find(d.frequencies.begin(), d.frequencies.end());
  if (twice != d.frequencies.end())
    refuse(d, fmt::format("has the frequency {:g} rad/s twice", *twice));
  if (d.frequencies.size() < 2)
    refuse(d, fmt::format("has {} frequencies above 0, expected at least 2", d.frequencies.size()));
  check_finite(d);
}

void keep_frequencies(const std::vector<bool>& kept, Database& d) {
  std::vector<std::size_t> order;
  for (std::size_t f = 0; f < kept.size(); ++f)
    if (kept[f]) order.push_back(f);
  take(order, d);
}

std::size_t limit_frequencies(double least, double greatest, Database& d) {
  std::vector<bool> kept;
  for (const double omega : d.frequencies) kept.push_back(omega >= least && omega <= greatest);
  keep_frequencies(kept, d);
  return d.frequencies.size();
}

std::size_t index_of_body(const scene::RadiationFile& source,
                          const std::vector<std::string>& names) {
  if (source.body.empty() && names.size() == 1) return 0;
  std::vector<std::string> choices;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    if (source.body == number || (!names[i].empty() && source.body == names[i])) return i;
    choices.push_back(names[i].empty() ? number : fmt::format("{} ({})", number, names[i]));
  }
  throw scene::InputError(source.file,
                          source.body.empty()
                              ? fmt::format("has {} bodies, expected the key body with one of {}",
                                            names.size(), fmt::join(choices, ", "))
                              : fmt::format("has no body {}, expected one of {}", source.body,
                                            fmt::join(choices, ", ")));
}

}  // namespace databases
