#include "app/databases/write_database.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "app/base/atomic_file.h"
#include "app/databases/database.h"
#include "app/databases/netcdf_classic.h"

namespace databases {
namespace {

using Eigen::Index;
using hydro::Matrix6d;
using hydro::RadiationData;
using std::numbers::pi;

Array scalar(double number) {
  return {.shape = {}, .dimensions = {}, .numbers = {number}, .texts = {}};
}

Array list(const std::string& dimension, const std::vector<double>& numbers) {
  return {.shape = {numbers.size()}, .dimensions = {dimension}, .numbers = numbers, .texts = {}};
}

Array words(const std::string& dimension, const std::vector<std::string>& texts) {
  return {.shape = {texts.size()}, .dimensions = {dimension}, .numbers = {}, .texts = texts};
}

/// A(ω), or B, with its limit of high frequency last.
Array matrices(const std::vector<Matrix6d>& all, const Matrix6d& limit, double density) {
  Array array{.shape = {all.size() + 1, 6, 6},
              .dimensions = {"omega", "influenced_dof", "radiating_dof"},
              .numbers = {},
              .texts = {}};
  for (std::size_t f = 0; f <= all.size(); ++f)
    for (Index i = 0; i < 6; ++i)
      for (Index j = 0; j < 6; ++j)
        array.numbers.push_back(density * (f < all.size() ? all[f] : limit)(i, j));
  return array;
}

/// Loads of waves; in the limit of high frequency they are not known.
Array loads(const std::vector<hydro::Loads6cd>& all, std::size_t headings, double density) {
  Array array{.shape = {2, all.size() + 1, headings, 6},
              .dimensions = {"complex", "omega", "wave_direction", "influenced_dof"},
              .numbers = {},
              .texts = {}};
  for (const bool imaginary : {false, true})
    for (std::size_t f = 0; f <= all.size(); ++f)
      for (std::size_t h = 0; h < headings; ++h)
        for (Index i = 0; i < 6; ++i) {
          if (f == all.size()) {
            array.numbers.push_back(std::nan(""));
            continue;
          }
          const std::complex<double> X = density * all[f](i, static_cast<Index>(h));
          array.numbers.push_back(imaginary ? X.imag() : X.real());
        }
  return array;
}

std::vector<hydro::Loads6cd> sum(const std::vector<hydro::Loads6cd>& a,
                                 const std::vector<hydro::Loads6cd>& b) {
  std::vector<hydro::Loads6cd> all;
  for (std::size_t f = 0; f < a.size(); ++f) all.emplace_back(a[f] + b[f]);
  return all;
}

/// The rows of .1 at a period.
void add_radiation(double period, const Matrix6d& A, const Matrix6d* B, std::string& text) {
  for (Index i = 0; i < 6; ++i)
    for (Index j = 0; j < 6; ++j) {
      text += fmt::format(" {:13.6E} {:5d} {:5d} {:14.6E}", period, i + 1, j + 1, A(i, j));
      text += B ? fmt::format(" {:14.6E}\n", (*B)(i, j)) : "\n";
    }
}

/// The rows of .3 at a period.
void add_excitation(double period, const RadiationData& data, std::size_t f, std::string& text) {
  for (std::size_t h = 0; h < data.headings.size(); ++h)
    for (Index i = 0; i < 6; ++i) {
      const auto column = static_cast<Index>(h);
      const std::complex<double> X =
          std::conj(data.froude_krylov[f](i, column) + data.diffraction[f](i, column)) /
          data.water.gravity;
      text += fmt::format(" {:13.6E} {:13.6E} {:5d} {:14.6E} {:14.6E} {:14.6E} {:14.6E}\n", period,
                          data.headings[h] * 180 / pi, i + 1, std::abs(X), std::arg(X) * 180 / pi,
                          X.real(), X.imag());
    }
}

/// Heave, roll and pitch; the others have no stiffness.
std::string stiffness_rows(const hydro::Hydrostatics& statics) {
  const Eigen::Matrix3d C = hydro::restoring_stiffness(statics);
  std::string text;
  for (Index i = 0; i < 6; ++i)
    for (Index j = 0; j < 6; ++j) {
      const bool stiff = i >= 2 && i < 5 && j >= 2 && j < 5;
      text += fmt::format(" {:5d} {:5d} {:14.6E}\n", i + 1, j + 1, stiff ? C(i - 2, j - 2) : 0.0);
    }
  return text;
}

}  // namespace

void write_capytaine(const std::filesystem::path& file, const WrittenBody& body) {
  const RadiationData& data = body.data;
  const std::vector<std::string> motions(kMotions, kMotions + 6);
  std::vector<double> omega = data.frequencies;
  omega.push_back(std::numeric_limits<double>::infinity());
  const Array center{.shape = {1, 3},
                     .dimensions = {"body", "space_coordinate"},
                     .numbers = {0, 0, data.pose.height},
                     .texts = {}};
  std::vector<NamedArray> arrays = {
      {"omega", list("omega", omega), {{"long_name", "Angular frequency"}, {"units", "rad/s"}}},
      {"radiating_dof", words("radiating_dof", motions), {}},
      {"influenced_dof", words("influenced_dof", motions), {}},
      {"body", words("body", {body.name}), {}},
      {"body_name", {.shape = {}, .dimensions = {}, .numbers = {}, .texts = {body.name}}, {}},
      {"space_coordinate", words("space_coordinate", {"x", "y", "z"}), {}},
      {"g", scalar(data.water.gravity), {}},
      {"rho", scalar(body.density), {}},
      {"water_depth", scalar(data.water.depth), {}},
      {"forward_speed", scalar(0), {}},
      {"rotation_center", center, {}},
      {"center_of_mass", center, {}},
      {"disp_mass", list("body", {body.density * data.volume}), {{"units", "kg"}}},
      {"added_mass",
       matrices(data.added_mass, data.infinite_added_mass, body.density),
       {{"long_name", "Added mass"}}},
      {"radiation_damping",
       matrices(data.damping, Matrix6d::Zero(), body.density),
       {{"long_name", "Radiation damping"}}}};
  if (!data.headings.empty()) {
    const std::size_t count = data.headings.size();
    arrays.push_back({"complex", words("complex", {"re", "im"}), {}});
    arrays.push_back({"wave_direction",
                      list("wave_direction", data.headings),
                      {{"long_name", "Wave direction"}, {"units", "rad"}}});
    arrays.push_back({"Froude_Krylov_force",
                      loads(data.froude_krylov, count, body.density),
                      {{"long_name", "Froude Krylov force"}}});
    arrays.push_back({"diffraction_force",
                      loads(data.diffraction, count, body.density),
                      {{"long_name", "Diffraction force"}}});
    arrays.push_back({"excitation_force",
                      loads(sum(data.froude_krylov, data.diffraction), count, body.density),
                      {{"long_name", "Excitation force"}}});
  }
  app::write_whole(file, netcdf_bytes({{"source", "plimsoll"}}, arrays));
}

std::vector<std::filesystem::path> write_wamit(const std::filesystem::path& stem,
                                               const WrittenBody& body) {
  const RadiationData& data = body.data;
  std::string radiation, excitation;
  add_radiation(0, data.infinite_added_mass, nullptr, radiation);
  for (std::size_t f = data.frequencies.size(); f-- > 0;) {  // Periods ascend.
    const double period = 2 * pi / data.frequencies[f];
    const Matrix6d B = data.damping[f] / data.frequencies[f];
    add_radiation(period, data.added_mass[f], &B, radiation);
    add_excitation(period, data, f, excitation);
  }
  std::vector<std::filesystem::path> files = {stem.string() + ".1", stem.string() + ".hst"};
  app::write_whole(files[0], radiation);
  app::write_whole(files[1], stiffness_rows(body.statics));
  if (excitation.empty()) return files;
  files.emplace_back(stem.string() + ".3");
  app::write_whole(files[2], excitation);
  return files;
}

}  // namespace databases
