#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "app/databases/database.h"
#include "app/scene/diagnostics.h"
#include "app/scene/table_line.h"

/// @file
/// Nemoh's Tecplot files, versions 2 and 3. Source: NEMOH v3 User Manual, chapter "Output". They
/// have units, and the moduli and angles of e^{−iωt}:
///
///     RadiationCoefficients.tec   a zone a motion, rows ω, A, B, A, B … over the forces
///     ExcitationForce.tec         a zone a heading, rows ω, |F|, angle, … over the forces
///     DiffractionForce.tec, FKForce.tec alike
///     Nemoh.cal                   density, gravity, depth, the point of the waves' phase, bodies

namespace databases {
namespace {

using Eigen::Index;
using std::numbers::pi;

/// Rows of numbers below a line `Zone …`.
struct Zone {
  std::string title;
  std::vector<std::vector<double>> rows;
};

struct TecFile {
  std::filesystem::path path;
  std::string frequency;  ///< Name of the first column: `w (rad/s)`.
  std::vector<Zone> zones;
};

TecFile read_tec(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw scene::InputError(path, "the file cannot be opened");
  TecFile file{.path = path, .frequency = {}, .zones = {}};
  std::string text;
  std::size_t columns = 0;  // Names in quotation marks.
  for (int number = 1; std::getline(in, text); ++number) {
    if (text.starts_with("Zone")) {
      file.zones.push_back({text, {}});
      continue;
    }
    if (file.zones.empty()) {
      const auto marks = static_cast<std::size_t>(std::count(text.begin(), text.end(), '"'));
      if (columns == 0 && marks >= 2)
        file.frequency = text.substr(text.find('"') + 1, text.rfind('"') - text.find('"') - 1);
      columns += marks / 2;
      continue;
    }
    scene::TableLine line(path, number, text, "a finite number");
    std::vector<double> row = line.values();
    if (row.empty()) continue;
    if (row.size() != columns)
      line.fail(fmt::format("the row has {} numbers, expected {} as the head has names", row.size(),
                            columns));
    file.zones.back().rows.push_back(std::move(row));
  }
  if (file.zones.empty() || columns < 13)
    throw scene::InputError(path, "has no zones of six motions, as Nemoh's files have");
  for (const Zone& zone : file.zones)
    if (zone.rows.size() != file.zones.front().rows.size())
      throw scene::InputError(
          path, fmt::format("the zone '{}' has {} rows, expected {}", zone.title, zone.rows.size(),
                            file.zones.front().rows.size()));
  return file;
}

double to_omega(const TecFile& file, double value) {
  if (file.frequency.find("rad") != std::string::npos) return value;
  if (file.frequency.find("Hz") != std::string::npos) return 2 * pi * value;
  if (file.frequency.find("(s)") != std::string::npos) return 2 * pi / value;
  throw scene::InputError(
      file.path, fmt::format("found the first column '{}', expected w (rad/s), f (Hz) or T "
                             "(s)",
                             file.frequency));
}

/// Content of Nemoh.cal.
struct Calculation {
  double density = 0, gravity = 0, depth = 0;
  Eigen::Vector2d phase_origin = Eigen::Vector2d::Zero();
  std::vector<std::string> bodies;                ///< Names of their mesh files.
  std::vector<Eigen::Vector3d> reference_points;  ///< One a body, of its first moment.
};

/// Reads the file line by line; text follows the numbers.
class CalculationReader {
 public:
  explicit CalculationReader(const std::filesystem::path& file) : file_(file), in_(file) {
    if (!in_) throw scene::InputError(file, "the file cannot be opened");
  }

  Calculation read() {
    Calculation c;
    next();
    c.density = numbers(1)[0];
    c.gravity = numbers(1)[0];
    c.depth = numbers(1)[0];
    const std::vector<double> origin = numbers(2);
    c.phase_origin = {origin[0], origin[1]};
    if (!(c.density > 0 && c.gravity > 0 && c.depth >= 0)) fail("expected positive numbers above");
    if (c.depth == 0) c.depth = std::numeric_limits<double>::infinity();
    next();
    const double bodies = numbers(1)[0];
    for (double b = 0; b < bodies; ++b) {
      next();
      c.bodies.push_back(std::filesystem::path(first_word()).stem().string());
      numbers(2);
      c.reference_points.push_back(moment_point());
      moment_point();
      for (double lines = numbers(1)[0]; lines > 0; --lines) next();
    }
    return c;
  }

 private:
  void next() {
    if (!std::getline(in_, text_)) fail("the file ends too early");
    ++line_;
  }
  std::string first_word() {
    next();
    std::string word;
    std::istringstream(text_) >> word;
    std::replace(word.begin(), word.end(), '\\', '/');
    return word;
  }
  /// The first numbers of the next line.
  std::vector<double> numbers(std::size_t count) {
    next();
    std::istringstream words(text_);
    std::vector<double> found(count);
    for (double& number : found)
      if (!(words >> number) || !std::isfinite(number))
        fail(fmt::format("expected {} numbers at the line's start", count));
    return found;
  }
  /// Reads a list of motions or forces. @return the point of the first rotation; zero without one
  Eigen::Vector3d moment_point() {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    bool found = false;
    for (double count = numbers(1)[0]; count > 0; --count) {
      const std::vector<double> row = numbers(7);
      if (row[0] != 2 || found) continue;
      point = {row[4], row[5], row[6]};
      found = true;
    }
    return point;
  }
  [[noreturn]] void fail(const std::string& message) const {
    throw scene::InputError({scene::Fault{{file_, line_, 1}, "", message}});
  }

  std::filesystem::path file_;
  std::ifstream in_;
  std::string text_;
  int line_ = 0;
};

std::filesystem::path find_calculation(const std::filesystem::path& results) {
  const std::filesystem::path folder = std::filesystem::absolute(results).parent_path();
  for (const auto& at : {folder, folder.parent_path()})
    if (std::filesystem::exists(at / "Nemoh.cal")) return at / "Nemoh.cal";
  throw scene::InputError(
      results, "has no Nemoh.cal in its folder or the one above, which tells the density");
}

void take_radiation(const TecFile& file, std::size_t body, double density, Database& d) {
  const std::size_t first = 6 * body;
  if (file.zones.size() < first + 6 || file.zones.front().rows.front().size() < 2 * (first + 6) + 1)
    throw scene::InputError(file.path,
                            fmt::format("has {} zones, expected one for each of six motions of {} "
                                        "bodies or more",
                                        file.zones.size(), body + 1));
  for (std::size_t f = 0; f < file.zones.front().rows.size(); ++f) {
    d.frequencies.push_back(to_omega(file, file.zones.front().rows[f][0]));
    hydro::Matrix6d A, B;
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j) {
        const std::vector<double>& row = file.zones[first + j].rows[f];
        A(static_cast<Index>(i), static_cast<Index>(j)) = row[2 * (first + i) + 1] / density;
        B(static_cast<Index>(i), static_cast<Index>(j)) = row[2 * (first + i) + 2] / density;
      }
    d.added_mass.push_back(A);
    d.damping.push_back(B);
  }
}

/// The number after `beta =`, in degrees.
double heading_of(const TecFile& file, const Zone& zone) {
  const std::size_t equals = zone.title.find('=', zone.title.find("beta"));
  double heading = 0;
  if (zone.title.find("beta") == std::string::npos ||
      !(std::istringstream(zone.title.substr(equals + 1)) >> heading))
    throw scene::InputError(file.path,
                            fmt::format("found the zone '{}', expected one with beta", zone.title));
  return heading * pi / 180;
}

std::vector<hydro::Loads6cd> read_loads(const std::filesystem::path& path, std::size_t body,
                                        double density, Database& d) {
  if (!std::filesystem::exists(path)) return {};
  const TecFile file = read_tec(path);
  d.files.push_back(path);
  std::vector<double> headings;
  for (const Zone& zone : file.zones) headings.push_back(heading_of(file, zone));
  if (!d.headings.empty() && headings != d.headings)
    throw scene::InputError(path, "has other headings than the files beside it");
  d.headings = headings;
  if (file.zones.front().rows.size() != d.frequencies.size() ||
      file.zones.front().rows.front().size() < 12 * (body + 1) + 1)
    throw scene::InputError(
        path, fmt::format("has {} frequencies, expected {}", file.zones.front().rows.size(),
                          d.frequencies.size()));
  std::vector<hydro::Loads6cd> loads;
  for (std::size_t f = 0; f < d.frequencies.size(); ++f) {
    loads.emplace_back(6, static_cast<Index>(headings.size()));
    for (std::size_t h = 0; h < headings.size(); ++h)
      for (std::size_t i = 0; i < 6; ++i) {
        const std::vector<double>& row = file.zones[h].rows[f];
        const std::size_t column = 2 * (6 * body + i) + 1;
        loads.back()(static_cast<Index>(i), static_cast<Index>(h)) =
            row[column] / density * std::exp(std::complex<double>(0, row[column + 1]));
      }
  }
  return loads;
}

}  // namespace

Database read_nemoh(const scene::RadiationFile& source) {
  if (source.file.filename() != "RadiationCoefficients.tec")
    throw scene::InputError(source.file, "expected Nemoh's file RadiationCoefficients.tec");
  const std::filesystem::path calculation = find_calculation(source.file);
  const Calculation c = CalculationReader(calculation).read();
  const TecFile radiation = read_tec(source.file);
  const std::size_t body = index_of_body(source, c.bodies);
  Database d{.format = "Nemoh", .body = c.bodies[body], .files = {source.file, calculation}};
  if (c.bodies.size() > 1) d.notes.emplace_back("its coupling with the other bodies is left out");
  take_radiation(radiation, body, c.density, d);
  const std::filesystem::path folder = source.file.parent_path();
  d.excitation = read_loads(folder / "ExcitationForce.tec", body, c.density, d);
  d.diffraction = read_loads(folder / "DiffractionForce.tec", body, c.density, d);
  d.froude_krylov = read_loads(folder / "FKForce.tec", body, c.density, d);
  d.gravity = c.gravity;
  d.depth = c.depth;
  d.phase_origin = c.phase_origin;
  d.reference_point = c.reference_points[body];
  settle(d);
  return d;
}

}  // namespace databases
