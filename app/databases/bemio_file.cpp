#include <fmt/format.h>

#include <cmath>

#include "app/databases/database.h"
#include "app/databases/open_arrays.h"

/// @file
/// The HDF5 files of BEMIO, which WEC-Sim and HydroChrono read. Source: WEC-Sim's documentation,
/// "BEMIO": A/ρ, B/(ρω) and X/(ρg) for e^{+iωt}, about the centre of gravity, wave phases over the
/// origin.

namespace databases {
namespace {

using Eigen::Index;

/// A group bodyN, and what the file's bodies have in common.
struct Body {
  const ArrayFile& file;
  std::string group;
  std::size_t index = 0;  ///< From 0.
  std::vector<double> omega;
  std::vector<double> headings;
  bool scaled = false;  ///< The numbers have units, as those of `density` and gravity.
  double density = 1000, gravity = 0;
};

/// The numbers of an array of three dimensions, whose first and last are given.
struct Cube {
  Array array;
  std::size_t at(std::size_t i, std::size_t j, std::size_t k) const {
    return (i * array.shape[1] + j) * array.shape[2] + k;
  }
};

std::optional<Cube> find_cube(const Body& body, const std::string& name, std::size_t least) {
  std::optional<Array> found = body.file.find(body.group + "/hydro_coeffs/" + name);
  if (!found) return std::nullopt;
  if (found->shape.size() != 3 || found->shape[0] != 6 || found->shape[1] < least ||
      found->shape[2] != body.omega.size() || found->numbers.empty())
    body.file.refuse(fmt::format("{}/hydro_coeffs/{} has the shape {}, expected 6 x {} x {}",
                                 body.group, name, fmt::join(found->shape, " x "), least,
                                 body.omega.size()));
  return Cube{*std::move(found)};
}

/// The body's own block of a matrix a frequency.
std::vector<hydro::Matrix6d> matrices(const Body& body, const std::string& name) {
  const auto cube = find_cube(body, name, 6 * (body.index + 1));
  if (!cube) body.file.refuse(fmt::format("has no array {}/hydro_coeffs/{}", body.group, name));
  std::vector<hydro::Matrix6d> all(body.omega.size());
  for (std::size_t f = 0; f < all.size(); ++f)
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j)
        all[f](static_cast<Index>(i), static_cast<Index>(j)) =
            cube->array.numbers[cube->at(i, 6 * body.index + j, f)];
  return all;
}

/// The columns of the other bodies' surge, sway and heave, summed; none without others.
std::vector<Eigen::Matrix<double, 6, 3>> neighbours(const Body& body) {
  const auto cube = find_cube(body, "added_mass/all", 6 * (body.index + 1));
  const std::size_t bodies = cube ? cube->array.shape[1] / 6 : 1;
  if (bodies < 2) return {};
  std::vector<Eigen::Matrix<double, 6, 3>> all(body.omega.size(),
                                               Eigen::Matrix<double, 6, 3>::Zero());
  const double unit = body.scaled ? 1 / body.density : 1;
  for (std::size_t f = 0; f < all.size(); ++f)
    for (std::size_t other = 0; other < bodies; ++other)
      for (std::size_t i = 0; i < 6 && other != body.index; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          all[f](static_cast<Index>(i), static_cast<Index>(j)) +=
              unit * cube->array.numbers[cube->at(i, 6 * other + j, f)];
  return all;
}

/// Loads of waves for ρ = 1 and e^{−iωt}; none if they are missing or, as BEMIO does for programs
/// that do not tell them, not numbers.
std::vector<hydro::Loads6cd> loads(const Body& body, const std::string& name) {
  const auto re = find_cube(body, name + "re", body.headings.size());
  const auto im = find_cube(body, name + "im", body.headings.size());
  if (!re || !im || re->array.shape != im->array.shape) return {};
  const double factor = body.scaled ? 1 / body.density : body.gravity;
  std::vector<hydro::Loads6cd> all;
  bool told = false;
  for (std::size_t f = 0; f < body.omega.size(); ++f) {
    all.emplace_back(6, static_cast<Index>(body.headings.size()));
    for (std::size_t h = 0; h < body.headings.size(); ++h)
      for (std::size_t i = 0; i < 6; ++i) {
        const std::complex<double> X(re->array.numbers[re->at(i, h, f)],
                                     -im->array.numbers[im->at(i, h, f)]);
        all.back()(static_cast<Index>(i), static_cast<Index>(h)) = factor * X;
        told = told || std::abs(X) > 0;
      }
  }
  return told ? all : std::vector<hydro::Loads6cd>();
}

bool all_finite(const std::vector<hydro::Loads6cd>& loads) {
  for (const hydro::Loads6cd& load : loads)
    if (!load.allFinite()) return false;
  return true;
}

std::vector<std::string> body_names(const ArrayFile& file) {
  std::vector<std::string> names;
  while (file.find(fmt::format("body{}/hydro_coeffs/added_mass/all", names.size() + 1)))
    names.push_back(
        file.text(fmt::format("body{}/properties/name", names.size() + 1)).value_or(""));
  if (names.empty()) file.refuse("has no body1/hydro_coeffs/added_mass/all, as BEMIO's files have");
  return names;
}

Body body_of(const ArrayFile& file, std::size_t index) {
  Body body{.file = file,
            .group = fmt::format("body{}", index + 1),
            .index = index,
            .omega = file.require("simulation_parameters/w").numbers,
            .headings = file.require("simulation_parameters/wave_dir").numbers};
  for (double& heading : body.headings) heading *= M_PI / 180;
  body.scaled = file.number("simulation_parameters/scaled").value_or(0) != 0;
  body.density = file.number("simulation_parameters/rho").value_or(0);
  body.gravity = file.number("simulation_parameters/g").value_or(0);
  if (!(body.gravity > 0 && body.density > 0 && std::isfinite(body.density)))
    file.refuse("expected positive simulation_parameters/rho and g");
  return body;
}

void read_properties(const Body& body, Database& d) {
  const ArrayFile& file = body.file;
  d.gravity = body.gravity;
  const auto depth = file.number("simulation_parameters/water_depth");
  d.depth = depth ? *depth : std::numeric_limits<double>::infinity();  // A word: `infinite`.
  if (const auto volume = file.number(body.group + "/properties/disp_vol"); volume && *volume > 0)
    d.volume = *volume;
  const auto cg = file.find(body.group + "/properties/cg");
  if (!cg || cg->numbers.size() != 3)
    file.refuse(fmt::format("{}/properties/cg: expected 3 numbers", body.group));
  d.center_of_mass = d.reference_point = Eigen::Vector3d(cg->numbers.data());
  const auto stiffness = file.find(body.group + "/hydro_coeffs/linear_restoring_stiffness");
  if (stiffness && stiffness->numbers.size() == 36)
    d.waterplane_area = stiffness->numbers[14] / (body.scaled ? body.density * body.gravity : 1);
}

}  // namespace

Database read_bemio(const scene::RadiationFile& source) {
  const std::unique_ptr<ArrayFile> file = open_arrays(source.file);
  const std::vector<std::string> names = body_names(*file);
  const Body body = body_of(*file, index_of_body(source, names));
  Database d{.format = "BEMIO",
             .body = names[body.index].empty() ? std::to_string(body.index + 1) : names[body.index],
             .files = {source.file}};
  if (names.size() > 1) d.notes.emplace_back("its coupling with the other bodies is left out");
  d.frequencies = body.omega;
  d.headings = body.headings;
  d.added_mass = matrices(body, "added_mass/all");
  d.damping = matrices(body, "radiation_damping/all");
  d.neighbours = neighbours(body);
  for (std::size_t f = 0; f < body.omega.size(); ++f) {
    if (body.scaled) d.added_mass[f] /= body.density;
    d.damping[f] *= body.scaled ? 1 / body.density : body.omega[f];
  }
  if (const auto inf = file->find(body.group + "/hydro_coeffs/added_mass/inf_freq");
      inf && inf->shape.size() == 2 && inf->shape[0] == 6 &&
      inf->shape[1] >= 6 * (body.index + 1)) {
    d.infinite_added_mass.emplace();
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j)
        (*d.infinite_added_mass)(static_cast<Index>(i), static_cast<Index>(j)) =
            inf->numbers[i * inf->shape[1] + 6 * body.index + j] / (body.scaled ? body.density : 1);
  }
  d.excitation = loads(body, "excitation/");
  d.diffraction = loads(body, "excitation/scattering/");
  d.froude_krylov = loads(body, "excitation/froude-krylov/");
  if (!all_finite(d.diffraction)) d.diffraction.clear();
  if (!all_finite(d.froude_krylov)) d.froude_krylov.clear();
  read_properties(body, d);
  settle(d);
  return d;
}

}  // namespace databases
