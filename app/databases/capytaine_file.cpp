#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/databases/database.h"
#include "app/databases/open_arrays.h"

/// @file
/// Capytaine's dataset as xarray writes it to NetCDF. Source: Capytaine's user manual, "Exporting
/// outputs" and "Conventions": SI units, e^{−iωt}, angles in radians, loads of waves of
/// amplitude 1.

namespace databases {
namespace {

using Eigen::Index;
using std::numbers::pi;

/// An array that is indexed by the names of its dimensions; those of one entry need no index.
class Indexed {
 public:
  Indexed(const ArrayFile& file, const std::string& name) : array_(file.require(name)) {
    if (array_.numbers.empty()) file.refuse(fmt::format("{}: expected numbers", name));
    if (array_.dimensions.size() != array_.shape.size())
      file.refuse(
          fmt::format("{} has no names of its dimensions, as Capytaine's datasets have", name));
  }

  std::size_t length(const std::string& dimension) const {
    const auto at = std::find(array_.dimensions.begin(), array_.dimensions.end(), dimension);
    return at == array_.dimensions.end()
               ? 0
               : array_.shape[static_cast<std::size_t>(at - array_.dimensions.begin())];
  }
  /// Refuses the array unless it has exactly these dimensions, and others of one entry.
  void expect(const ArrayFile& file, const std::string& name,
              const std::vector<std::pair<std::string, std::size_t>>& dimensions) const {
    for (const auto& [dimension, entries] : dimensions)
      if (length(dimension) != entries)
        file.refuse(fmt::format("{} has {} entries along {}, expected {}", name, length(dimension),
                                dimension, entries));
    for (std::size_t i = 0; i < array_.shape.size(); ++i) {
      const bool known = std::any_of(dimensions.begin(), dimensions.end(), [&](const auto& each) {
        return each.first == array_.dimensions[i];
      });
      if (!known && array_.shape[i] != 1)
        file.refuse(fmt::format("{} has {} entries along {}, expected one", name, array_.shape[i],
                                array_.dimensions[i]));
    }
  }
  double at(const std::vector<std::pair<const char*, std::size_t>>& index) const {
    std::size_t place = 0;
    for (std::size_t i = 0; i < array_.shape.size(); ++i) {
      place *= array_.shape[i];
      for (const auto& [dimension, value] : index)
        if (array_.dimensions[i] == dimension) place += value;
    }
    return array_.numbers[place];
  }

 private:
  Array array_;
};

/// The file and what its arrays have in common.
struct Dataset {
  const ArrayFile& file;
  std::string frequency;        ///< Name of the dimension of frequencies.
  std::vector<double> omega;    ///< [rad/s]
  std::vector<double> heading;  ///< [rad]; none without waves.
  double density = 1000;
  // Place of each of the body's motions along the two dimensions; none for a motion that it lacks.
  std::vector<std::optional<std::size_t>> radiating, influenced;
};

void read_frequencies(Dataset& set) {
  const Array A = set.file.require("added_mass");
  for (const char* name : {"omega", "period", "freq", "wavenumber", "wavelength"})
    if (std::find(A.dimensions.begin(), A.dimensions.end(), name) != A.dimensions.end())
      set.frequency = name;
  if (set.frequency.empty()) set.file.refuse("added_mass has no dimension omega, period or freq");
  if (const auto omega = set.file.find("omega")) {
    set.omega = omega->numbers;
  } else if (const auto period = set.file.find("period")) {
    for (const double T : period->numbers) set.omega.push_back(2 * pi / T);
  } else {
    for (const double f : set.file.require("freq").numbers) set.omega.push_back(2 * pi * f);
  }
}

/// Splits `body__Heave`; without the bar the body has no name.
std::pair<std::string, std::string> split(const std::string& dof) {
  const std::size_t bar = dof.rfind("__");
  return bar == std::string::npos ? std::pair{std::string(), dof}
                                  : std::pair{dof.substr(0, bar), dof.substr(bar + 2)};
}

std::vector<std::string> body_names(const ArrayFile& file, const std::vector<std::string>& dofs) {
  std::vector<std::string> names;
  for (const std::string& dof : dofs)
    if (std::find(names.begin(), names.end(), split(dof).first) == names.end())
      names.push_back(split(dof).first);
  if (names.size() == 1 && names.front().empty()) {
    const auto name = file.text("body_name");
    names.front() = name ? *name : file.text("body").value_or("");
  }
  return names;
}

std::vector<std::optional<std::size_t>> places_of(const std::vector<std::string>& dofs,
                                                  const std::string& body) {
  std::vector<std::optional<std::size_t>> places(6);
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    const auto [name, motion] = split(dofs[i]);
    for (std::size_t m = 0; m < 6; ++m)
      if (motion == kMotions[m] && (name.empty() || name == body)) places[m] = i;
  }
  return places;
}

hydro::Matrix6d matrix_of(const Dataset& set, const Indexed& array, std::size_t f) {
  hydro::Matrix6d matrix = hydro::Matrix6d::Zero();
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      if (set.influenced[i] && set.radiating[j])
        matrix(static_cast<Index>(i), static_cast<Index>(j)) =
            array.at({{set.frequency.c_str(), f},
                      {"influenced_dof", *set.influenced[i]},
                      {"radiating_dof", *set.radiating[j]}}) /
            set.density;
  return matrix;
}

std::vector<hydro::Loads6cd> loads_of(const Dataset& set, const std::string& name,
                                      std::size_t dofs) {
  if (!set.file.find(name)) return {};
  const Indexed array(set.file, name);
  array.expect(set.file, name,
               {{"complex", 2},
                {set.frequency, set.omega.size()},
                {"wave_direction", set.heading.size()},
                {"influenced_dof", dofs}});
  std::vector<hydro::Loads6cd> loads;
  for (std::size_t f = 0; f < set.omega.size(); ++f) {
    loads.emplace_back(hydro::Loads6cd::Zero(6, static_cast<Index>(set.heading.size())));
    for (std::size_t h = 0; h < set.heading.size(); ++h)
      for (std::size_t i = 0; i < 6; ++i) {
        if (!set.influenced[i]) continue;
        const auto part = [&](std::size_t complex) {
          return array.at({{"complex", complex},
                           {set.frequency.c_str(), f},
                           {"wave_direction", h},
                           {"influenced_dof", *set.influenced[i]}}) /
                 set.density;
        };
        loads.back()(static_cast<Index>(i), static_cast<Index>(h)) = {part(0), part(1)};
      }
  }
  return loads;
}

/// A point of the body, by three numbers or a row for each body.
std::optional<Eigen::Vector3d> point_of(const ArrayFile& file, const std::string& name,
                                        std::size_t body) {
  const std::optional<Array> array = file.find(name);
  if (!array || array->numbers.size() < 3) return std::nullopt;
  const std::size_t first = array->numbers.size() >= 3 * (body + 1) ? 3 * body : 0;
  const Eigen::Vector3d point(array->numbers[first], array->numbers[first + 1],
                              array->numbers[first + 2]);
  return point.allFinite() ? std::optional(point) : std::nullopt;
}

void read_statics(const Dataset& set, std::size_t body, Database& d) {
  d.gravity = set.file.number("g");
  d.depth = set.file.number("water_depth");
  d.center_of_mass = point_of(set.file, "center_of_mass", body);
  d.reference_point = point_of(set.file, "rotation_center", body);
  if (const auto mass = set.file.find("disp_mass"); mass && body < mass->numbers.size())
    d.volume = mass->numbers[body] / set.density;
  if (set.file.find("hydrostatic_stiffness") && set.influenced[2] && set.radiating[2] &&
      d.gravity) {
    const Indexed stiffness(set.file, "hydrostatic_stiffness");
    const double heave = stiffness.at(
        {{"influenced_dof", *set.influenced[2]}, {"radiating_dof", *set.radiating[2]}});
    d.waterplane_area = heave / (set.density * *d.gravity);
  }
}

void note_motions(const Dataset& set, const std::string& body, std::size_t dofs, Database& d) {
  std::vector<std::string> missing;
  for (std::size_t i = 0; i < 6; ++i)
    if (!set.influenced[i] || !set.radiating[i]) missing.emplace_back(kMotions[i]);
  if (missing.size() == 6)
    set.file.refuse(fmt::format("has no motion Surge … Yaw of the body {}", body));
  if (!missing.empty())
    d.notes.push_back(
        fmt::format("the file has no {}, which is taken as 0", fmt::join(missing, ", ")));
  if (dofs > 6) d.notes.push_back(fmt::format("{} further motions are left out", dofs - 6));
}

}  // namespace

Database read_capytaine(const scene::RadiationFile& source) {
  const std::unique_ptr<ArrayFile> file = open_arrays(source.file);
  const std::vector<std::string> radiating = file->require("radiating_dof").texts;
  const std::vector<std::string> influenced = file->require("influenced_dof").texts;
  const std::vector<std::string> names = body_names(*file, influenced);
  const std::size_t body = index_of_body(source, names);
  Dataset set{.file = *file, .frequency = {}, .omega = {}, .heading = {}};
  read_frequencies(set);
  set.radiating = places_of(radiating, names[body]);
  set.influenced = places_of(influenced, names[body]);
  set.density = file->number("rho").value_or(0);
  if (!(set.density > 0 && std::isfinite(set.density)))
    file->refuse("expected a positive density rho");
  if (const auto headings = file->find("wave_direction")) set.heading = headings->numbers;
  Database d{.format = "Capytaine", .body = names[body], .files = {source.file}};
  note_motions(set, names[body], influenced.size(), d);
  d.frequencies = set.omega;
  d.headings = set.heading;
  const std::vector<std::pair<std::string, std::size_t>> dimensions = {
      {set.frequency, set.omega.size()},
      {"radiating_dof", radiating.size()},
      {"influenced_dof", influenced.size()}};
  for (const bool damping : {false, true}) {
    const char* name = damping ? "radiation_damping" : "added_mass";
    const Indexed array(*file, name);
    array.expect(*file, name, dimensions);
    for (std::size_t f = 0; f < set.omega.size(); ++f)
      (damping ? d.damping : d.added_mass).push_back(matrix_of(set, array, f));
  }
  d.froude_krylov = loads_of(set, "Froude_Krylov_force", influenced.size());
  d.diffraction = loads_of(set, "diffraction_force", influenced.size());
  if (d.diffraction.empty()) d.excitation = loads_of(set, "excitation_force", influenced.size());
  read_statics(set, body, d);
  settle(d);
  return d;
}

}  // namespace databases
