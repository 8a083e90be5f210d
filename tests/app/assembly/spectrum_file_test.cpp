#include "app/assembly/spectrum_file.h"

#include <cmath>

#include "tests/app/assembly/file_reader_test.h"

namespace {

using SpectrumFile = support::FileReaderTest<assembly::read_spectrum>;

TEST_F(SpectrumFile, HertzAndRadiansAreTheSameSpectrum) {
  const auto hertz = read("# a buoy\nfrequency_hz;density\n\n0.1;0\n0.2;+3\n0.4;1e-1\n");
  const auto radians = read(
      "\xEF\xBB\xBF"
      "density frequency_rad_s\r\n0 0.6283185307179586\r\n"
      "0.477464829275686 1.2566370614359172\r\n0.015915494309189534 2.5132741228718345\r\n");
  ASSERT_EQ(hertz.frequencies.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(hertz.frequencies[i], radians.frequencies[i]);
    EXPECT_DOUBLE_EQ(hertz.densities[i], radians.densities[i]);
  }
  // ½ 0.1 · 3 + ½ 0.2 · 3.1 m²
  EXPECT_DOUBLE_EQ(hydro::spectral_energy(hertz), 0.46);
  EXPECT_TRUE(hertz.headings.empty());
}

TEST_F(SpectrumFile, HeadingsAreInRadians) {
  const auto spectrum = read("heading_deg,frequency_hz,density\n90,0.1,1\n180,0.2,1\n");
  EXPECT_DOUBLE_EQ(spectrum.headings.at(0), M_PI / 2);
  EXPECT_DOUBLE_EQ(spectrum.headings.at(1), M_PI);
}

TEST_F(SpectrumFile, AFaultHasItsPlace) {
  const std::string usage =
      "expected the columns frequency_hz and density [m^2/Hz], or frequency_rad_s and density [m^2 "
      "s/rad], and if directions are known heading_deg";
  EXPECT_EQ(fault(""), ": the file is empty, " + usage);
  EXPECT_EQ(fault("frequency_hz,S\n"), ":1:15: found 'S' in the header, " + usage);
  EXPECT_EQ(fault("density,density\n"), ":1:16: the column density is given twice, " + usage);
  EXPECT_EQ(fault("0.1,2\n"), ":1:6: found '0.1' in the header, " + usage);
  EXPECT_EQ(fault("frequency_hz\n"), ": " + usage);
  const std::string head = "frequency_hz,density\n";
  EXPECT_EQ(fault(head + "0.1,2\n"), ": found 1 rows, expected at least 2 frequencies");
  EXPECT_EQ(fault(head + "0.1,2\n0.2,-1\n"), ":3:1: found the density -1, expected one >= 0");
  EXPECT_EQ(fault(head + "-0.1,2\n0.2,1\n"), ":2:1: found the frequency -0.1, expected one >= 0");
  EXPECT_EQ(fault(head + "0.2,2\n\n0.2,1\n"),
            ":4:1: found the frequency 0.2 after 0.2, expected ascending ones");
  EXPECT_EQ(fault(head + "0.1,nan\n"), ":2:5: found 'nan', expected a finite number");
  EXPECT_EQ(fault(head + "0.1,1,2\n"),
            ":2:8: the row has 3 numbers, expected 2 as the header has names");
  EXPECT_EQ(fault(head + "0.1,0\n0.2,0\n"), ": all its densities are 0, expected a sea with waves");
}

}  // namespace
