#include "app/assembly/spectrum_file.h"

#include <fmt/format.h>

#include <cmath>

#include "app/assembly/column_file.h"
#include "app/scene/diagnostics.h"

namespace assembly {
namespace {

const char* const kSpectrumUsage =
    "expected the columns frequency_hz and density [m^2/Hz], or frequency_rad_s and density [m^2 "
    "s/rad], and if directions are known heading_deg";

void check_rows(const std::filesystem::path& file, const ColumnFile& table,
                const std::vector<double>& frequency, const std::vector<double>& density) {
  if (table.rows() < 2)
    throw scene::InputError(
        file, fmt::format("found {} rows, expected at least 2 frequencies", table.rows()));
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (frequency[i] < 0)
      table.refuse(file, i,
                   fmt::format("found the frequency {:g}, expected one >= 0", frequency[i]));
    if (i > 0 && frequency[i] <= frequency[i - 1])
      table.refuse(file, i,
                   fmt::format("found the frequency {:g} after {:g}, expected ascending ones",
                               frequency[i], frequency[i - 1]));
    if (density[i] < 0)
      table.refuse(file, i, fmt::format("found the density {:g}, expected one >= 0", density[i]));
  }
}

}  // namespace

hydro::TabulatedSpectrum read_spectrum(const std::filesystem::path& file) {
  const ColumnFile table = read_columns(
      file, {"frequency_hz", "frequency_rad_s", "density", "heading_deg"}, kSpectrumUsage);
  const std::vector<double>* hertz = table.find("frequency_hz");
  const std::vector<double>* radians = table.find("frequency_rad_s");
  const std::vector<double>* density = table.find("density");
  if ((hertz == nullptr) == (radians == nullptr) || density == nullptr)
    throw scene::InputError(file, kSpectrumUsage);
  check_rows(file, table, hertz ? *hertz : *radians, *density);
  const double scale = hertz ? 2 * M_PI : 1;
  hydro::TabulatedSpectrum spectrum;
  for (const double f : hertz ? *hertz : *radians) spectrum.frequencies.push_back(scale * f);
  for (const double s : *density) spectrum.densities.push_back(s / scale);
  if (const auto* heading = table.find("heading_deg"))
    for (const double h : *heading) spectrum.headings.push_back(h * M_PI / 180);
  if (!(hydro::spectral_energy(spectrum) > 0))
    throw scene::InputError(file, "all its densities are 0, expected a sea with waves");
  return spectrum;
}

}  // namespace assembly
