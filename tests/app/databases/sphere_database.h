#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "app/databases/fit_to_body.h"
#include "app/databases/write_database.h"
#include "app/scene/diagnostics.h"
#include "hydro/mesh/primitives.h"
#include "hydro/radiation/froude_krylov.h"
#include "tests/support/radiating_sphere.h"

/// @file
/// Files of a database of a sphere, and what is found in them.

namespace support {

/// A sphere of radius 1 that floats half submerged, its centre of mass in its centre, with the
/// loads of waves that radiate its damping.
inline hydro::RadiationData sphere_data(int headings) {
  hydro::RadiationData data = radiating_sphere(1);
  for (int h = 0; h < headings; ++h) data.headings.push_back(2 * M_PI * h / headings);
  for (std::size_t f = 0; f < data.frequencies.size(); ++f) {
    const double omega = data.frequencies[f], g = data.water.gravity, k = omega * omega / g;
    const double heave = g * std::sqrt(2 * data.damping[f](2, 2) / (k * omega));
    const double surge = g * std::sqrt(4 * data.damping[f](0, 0) / (k * omega));
    hydro::Loads6cd X = hydro::Loads6cd::Zero(6, headings);
    for (int h = 0; h < headings; ++h) {
      const double beta = data.headings[static_cast<std::size_t>(h)];
      X.col(h).head<3>() << std::complex<double>(0, -surge * std::cos(beta)),
          std::complex<double>(0, -surge * std::sin(beta)), heave;
    }
    data.diffraction.push_back(X);
  }
  data.froude_krylov = hydro::froude_krylov(hydro::make_icosphere(1, 4), data.pose, data.water,
                                            data.frequencies, data.headings);
  for (std::size_t f = 0; f < data.frequencies.size(); ++f)
    data.diffraction[f] -= data.froude_krylov[f];
  return data;
}

/// The first headings alone.
inline hydro::RadiationData only_headings(hydro::RadiationData data, int count) {
  data.headings.resize(static_cast<std::size_t>(count));
  for (auto* loads : {&data.froude_krylov, &data.diffraction})
    for (hydro::Loads6cd& load : *loads) load = load.leftCols(count).eval();
  return data;
}

inline double largest_difference(const std::vector<hydro::Loads6cd>& a,
                                 const std::vector<hydro::Loads6cd>& b) {
  double largest = 0;
  for (std::size_t f = 0; f < a.size(); ++f)
    largest = std::max(largest, (a[f] - b[f]).cwiseAbs().maxCoeff());
  return largest;
}

/// A folder for the files of one test, and the sphere to which they are put.
class SphereDatabase : public testing::Test {
 protected:
  SphereDatabase() { std::filesystem::create_directories(folder_); }
  ~SphereDatabase() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path file(const std::string& name) const { return folder_ / name; }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(file(name), std::ios::binary) << text;
  }
  databases::WrittenBody written(const hydro::RadiationData& data) const {
    return {.name = "ball",
            .data = data,
            .density = 1025,
            .statics = hydro::hydrostatics(mesh_, data.pose.height)};
  }
  databases::BodyData read(const scene::RadiationFile& source, bool waves = true) const {
    const databases::Database database = databases::read_database(source, 9.80665);
    return databases::fit_to_body(database, source,
                                  {.mesh_B = mesh_, .pose = {}, .water = {}, .waves = waves});
  }
  std::string fault(const scene::RadiationFile& source, bool waves = true) const {
    try {
      read(source, waves);
    } catch (const scene::InputError& error) {
      const std::string text = error.what();
      return text.substr(text.find(source.file.stem().string()));
    }
    return "none";
  }

  hydro::TriMesh mesh_ = hydro::make_icosphere(1, 4);

 private:
  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      (std::string("database_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

}  // namespace support
