#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>

#include "app/databases/database.h"
#include "app/scene/diagnostics.h"
#include "app/scene/table_line.h"

/// @file
/// WAMIT's numeric files, which HAMS and Capytaine write, too. Source: WAMIT User Manual, chapter
/// "Output files": for e^{+iωt} and the length L,
///
///     .1   PER I J A B          A/(ρ L^k), B/(ρ ω L^k); k = 3, 4 or 5 for force, mixed, moment
///     .3   PER BETA I MOD PHASE RE IM     X/(ρ g L^m); m = 2 for forces, 3 for moments
///     .hst I J C                C/(ρ g L^k)
///
/// PER is a period; 0 stands for an infinite frequency, a negative one for 0. Entries that symmetry
/// makes 0 may be left out.

namespace databases {
namespace {

using Eigen::Index;
using std::numbers::pi;

/// Motions of most bodies that a file may have.
constexpr double kMostMotions = 600;

/// A row of numbers and its line.
struct Row {
  int line = 0;
  std::vector<double> numbers;
};

[[noreturn]] void refuse(const std::filesystem::path& file, int line, const std::string& message) {
  throw scene::InputError({scene::Fault{{file, line, 1}, "", message}});
}

/// The rows of a file. A first line that does not begin with a number is a head.
std::vector<Row> rows_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file))
    throw scene::InputError(file, "the file cannot be opened");
  std::vector<Row> rows;
  std::string text;
  for (int number = 1; std::getline(in, text); ++number) {
    const std::size_t start = text.find_first_not_of(" \t");
    if (number == 1 && start != std::string::npos &&
        std::string_view("+-.0123456789").find(text[start]) == std::string_view::npos)
      continue;
    scene::TableLine line(file, number, text, "a finite number");
    Row row{number, line.values()};
    if (!row.numbers.empty()) rows.push_back(std::move(row));
  }
  if (rows.empty()) throw scene::InputError(file, "the file has no rows of numbers");
  return rows;
}

/// Index of a motion, from 0.
Index motion(const std::filesystem::path& file, const Row& row, std::size_t column) {
  const double found = row.numbers[column];
  if (!(found >= 1 && found <= kMostMotions && found == std::floor(found)))
    refuse(
        file, row.line,
        fmt::format("found {:g} in column {}, expected the number of a motion", found, column + 1));
  return static_cast<Index>(found) - 1;
}

/// ω of a PER.
double frequency(double period) {
  if (period < 0) return 0;
  return period == 0 ? std::numeric_limits<double>::infinity() : 2 * pi / period;
}

/// A file .1 of all bodies.
struct RadiationRows {
  std::vector<Row> rows;
  Index motions = 0;
};

RadiationRows read_radiation(const std::filesystem::path& file) {
  RadiationRows found{rows_of(file)};
  for (const Row& row : found.rows) {
    const bool limit = row.numbers[0] <= 0;
    if (row.numbers.size() != (limit ? 4 : 5) && !(limit && row.numbers.size() == 5))
      refuse(file, row.line,
             fmt::format("the row has {} numbers, expected PER, I, J, A{}", row.numbers.size(),
                         limit ? "" : " and B"));
    found.motions = std::max({found.motions, motion(file, row, 1) + 1, motion(file, row, 2) + 1});
  }
  return found;
}

/// Power of L in the entry of a matrix less 3.
int moments(Index i, Index j) { return (i % 6 >= 3 ? 1 : 0) + (j % 6 >= 3 ? 1 : 0); }

void take_radiation(const scene::RadiationFile& source, const RadiationRows& found, Index first,
                    Database& d) {
  std::map<double, std::size_t> places;
  for (const Row& row : found.rows) {
    const double omega = frequency(row.numbers[0]);
    const auto [place, is_new] = places.emplace(omega, d.frequencies.size());
    if (is_new) {
      d.frequencies.push_back(omega);
      d.added_mass.emplace_back(hydro::Matrix6d::Zero());
      d.damping.emplace_back(hydro::Matrix6d::Zero());
      if (found.motions > 6) d.neighbours.emplace_back(Eigen::Matrix<double, 6, 3>::Zero());
    }
    const Index i = motion(source.file, row, 1) - first, j = motion(source.file, row, 2) - first;
    if (i < 0 || i >= 6) continue;
    const double scale = std::pow(source.length, 3 + moments(i, j + first));
    if (j < 0 || j >= 6) {
      const Index motion_of_other = (j + first) % 6;
      if (motion_of_other < 3)
        d.neighbours[place->second](i, motion_of_other) += scale * row.numbers[3];
      continue;
    }
    d.added_mass[place->second](i, j) = scale * row.numbers[3];
    if (std::isfinite(omega) && omega > 0)
      d.damping[place->second](i, j) = scale * omega * row.numbers[4];
  }
}

/// The headings of a file .3, in its order; 360° is 0.
std::vector<double> headings_of(const std::vector<Row>& rows) {
  std::vector<double> headings;
  for (const Row& row : rows)
    if (std::find(headings.begin(), headings.end(), row.numbers[1]) == headings.end())
      headings.push_back(row.numbers[1]);
  return headings;
}

void take_excitation(const scene::RadiationFile& source, const std::filesystem::path& file,
                     double gravity, Index first, Database& d) {
  const std::vector<Row> rows = rows_of(file);
  for (const Row& row : rows)
    if (row.numbers.size() != 7)
      refuse(file, row.line,
             fmt::format("the row has {} numbers, expected PER, BETA, I, MOD, PHASE, RE and IM",
                         row.numbers.size()));
  const std::vector<double> headings = headings_of(rows);
  d.headings.clear();
  for (const double heading : headings) d.headings.push_back(heading * pi / 180);
  d.excitation.assign(d.frequencies.size(),
                      hydro::Loads6cd::Zero(6, static_cast<Index>(headings.size())));
  std::vector<bool> seen(d.frequencies.size() * headings.size(), false);
  for (const Row& row : rows) {
    if (row.numbers[0] <= 0) continue;  // A limit, in which the loads are not needed.
    const double omega = frequency(row.numbers[0]);
    const auto f = std::find(d.frequencies.begin(), d.frequencies.end(), omega);
    if (f == d.frequencies.end())
      refuse(file, row.line,
             fmt::format("found the period {:g}, which {} does not have", row.numbers[0],
                         source.file.filename().string()));
    const auto place = static_cast<std::size_t>(f - d.frequencies.begin());
    const auto heading = static_cast<std::size_t>(
        std::find(headings.begin(), headings.end(), row.numbers[1]) - headings.begin());
    const Index i = motion(file, row, 2) - first;
    if (i < 0 || i >= 6) continue;
    seen[place * headings.size() + heading] = true;
    const std::complex<double> X(row.numbers[5], -row.numbers[6]);
    d.excitation[place](i, static_cast<Index>(heading)) =
        gravity * std::pow(source.length, i >= 3 ? 3 : 2) * X;
  }
  for (std::size_t f = 0; f < d.frequencies.size(); ++f)
    for (std::size_t h = 0; h < headings.size(); ++h)
      if (std::isfinite(d.frequencies[f]) && d.frequencies[f] > 0 && !seen[f * headings.size() + h])
        throw scene::InputError(file,
                                fmt::format("has no loads at the period {:g} and the heading {:g}",
                                            2 * pi / d.frequencies[f], headings[h]));
}

void take_stiffness(const scene::RadiationFile& source, const std::filesystem::path& file,
                    Index first, Database& d) {
  for (const Row& row : rows_of(file)) {
    if (row.numbers.size() != 3)
      refuse(file, row.line,
             fmt::format("the row has {} numbers, expected I, J and C", row.numbers.size()));
    if (motion(file, row, 0) == first + 2 && motion(file, row, 1) == first + 2)
      d.waterplane_area = row.numbers[2] * source.length * source.length;
  }
}

}  // namespace

Database read_wamit(const scene::RadiationFile& source, double gravity) {
  const RadiationRows radiation = read_radiation(source.file);
  const std::vector<std::string> names(static_cast<std::size_t>((radiation.motions + 5) / 6));
  const std::size_t body = index_of_body(source, names);
  const Index first = 6 * static_cast<Index>(body);
  Database d{.format = "WAMIT", .body = std::to_string(body + 1), .files = {source.file}};
  if (names.size() > 1) d.notes.emplace_back("its coupling with the other bodies is left out");
  take_radiation(source, radiation, first, d);
  const auto beside = [&](const char* extension) {
    std::filesystem::path file = source.file;
    return file.replace_extension(extension);
  };
  if (std::filesystem::exists(beside(".3"))) {
    d.files.push_back(beside(".3"));
    take_excitation(source, d.files.back(), gravity, first, d);
  }
  if (std::filesystem::exists(beside(".hst"))) {
    d.files.push_back(beside(".hst"));
    take_stiffness(source, d.files.back(), first, d);
  }
  settle(d);
  return d;
}

}  // namespace databases
