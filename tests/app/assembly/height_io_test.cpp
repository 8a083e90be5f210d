#include "app/assembly/height_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "app/scene/diagnostics.h"
#include "tests/support/tolerance.h"

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class HeightIo : public testing::Test {
 protected:
  HeightIo() : file_(fs::path(testing::TempDir()) / (name() + ".csv")) {}
  ~HeightIo() override { fs::remove(file_); }

  const fs::path& write(const std::string& text) const {
    std::ofstream(file_, std::ios::binary) << text;
    return file_;
  }
  Eigen::MatrixXd read(const std::string& text) const {
    return assembly::read_heights(write(text));
  }

 private:
  static std::string name() {
    return testing::UnitTest::GetInstance()->current_test_info()->name();
  }
  fs::path file_;
};

fs::path picture(const std::string& file) {
  return fs::path(PLIMSOLL_SOURCE_DIR) / "tests/data/heights" / file;
}

/// The one fault of reading a file; fails the test if there is none.
scene::Fault height_fault(const fs::path& file,
                          const std::optional<std::array<double, 2>>& range = std::nullopt) {
  try {
    assembly::read_heights(file, range);
  } catch (const scene::InputError& error) {
    EXPECT_EQ(error.faults().size(), 1u);
    EXPECT_EQ(error.faults().front().place.file, file);
    return error.faults().front();
  }
  ADD_FAILURE() << file << " was read";
  return {};
}

TEST_F(HeightIo, RowsOfATableAreRowsOfTheFieldWhateverSeparatesTheNumbers) {
  Eigen::MatrixXd expected(2, 3);
  expected << 1, -2.5, 3e-2, 4, 5, 6;
  for (const char* text :
       {"1,-2.5,3e-2\n4,5,6\n", "1 -2.5\t0.03\n 4  5 6 ", "1; -2.5 ;.03\r\n4;+5;6\r\n",
        "\xEF\xBB\xBF# x to the right\n\n1, -2.5, 3e-2  # y = 0\n   \n4,5,6\n"})
    EXPECT_EQ(read(text), expected) << text;
}

TEST_F(HeightIo, NumbersReadBackToTheSameDouble) {
  EXPECT_EQ(read("0.1 1e-300 123456789.12345678")(0, 0), 0.1);
  EXPECT_EQ(read("0.1 1e-300 123456789.12345678")(0, 1), 1e-300);
  EXPECT_EQ(read("0.1 1e-300 123456789.12345678")(0, 2), 123456789.12345678);
}

TEST_F(HeightIo, AWrongNumberIsRefusedWithLineAndColumn) {
  for (const char* word : {"x", "1.5m", "nan", "inf", "-inf", "1e999", "0x10", "+"}) {
    const scene::Fault f = height_fault(write("# heights\n1, 2\n3, " + std::string(word) + "\n"));
    EXPECT_EQ(f.place.line, 3) << word;
    EXPECT_EQ(f.place.column, 4) << word;
    EXPECT_THAT(f.message, HasSubstr("found '" + std::string(word) + "', expected a finite"));
  }
}

TEST_F(HeightIo, AMissingNumberIsRefused) {
  EXPECT_EQ(height_fault(write("1,,3\n")).place.column, 3);
  EXPECT_EQ(height_fault(write(",1\n")).place.column, 1);
  EXPECT_THAT(height_fault(write("1,2,\n")).message, HasSubstr("ends with a separator"));
}

TEST_F(HeightIo, RowsOfDifferentLengthAreRefusedWithTheLine) {
  const scene::Fault f = height_fault(write("1,2,3\n\n4,5\n"));
  EXPECT_EQ(f.place.line, 3);
  EXPECT_THAT(f.message, HasSubstr("2 numbers, expected 3"));
}

TEST_F(HeightIo, AFileWithoutHeightsIsRefused) {
  EXPECT_THAT(height_fault(write("")).message, HasSubstr("no heights"));
  EXPECT_THAT(height_fault(write("# only this\n")).message, HasSubstr("no heights"));
  EXPECT_THAT(height_fault("/no/such/file.csv").message, HasSubstr("no such file"));
  EXPECT_THAT(height_fault(testing::TempDir()).message, HasSubstr("folder"));
}

TEST_F(HeightIo, GreyIsLinearBetweenBlackAndWhiteWithTheTopRowFirst) {
  Eigen::MatrixXd wide(2, 3), narrow(2, 3), bits(2, 3);
  wide << 0, 65535, 256, 1, 32768, 4660;
  narrow << 0, 255, 51, 1, 128, 18;
  bits << 1, 0, 1, 0, 1, 0;
  const double rounding = support::tolerance(2e-15);  // four roundings of heights up to 3
  const auto expect = [&](const char* file, const Eigen::MatrixXd& share) {
    const Eigen::MatrixXd expected = (-2 + 5 * share.array()).matrix();
    const Eigen::MatrixXd heights = assembly::read_heights(picture(file), {{-2, 3}});
    ASSERT_EQ(heights.rows(), 2) << file;
    ASSERT_EQ(heights.cols(), 3) << file;
    EXPECT_LE((heights - expected).cwiseAbs().maxCoeff(), rounding) << file;
  };
  expect("grey16.png", wide / 65535);
  expect("grey8.png", narrow / 255);
  expect("grey1.png", bits);
}

TEST_F(HeightIo, BlackAndWhiteAreExactlyTheEndsOfTheRange) {
  const Eigen::MatrixXd heights = assembly::read_heights(picture("grey16.png"), {{0.1, 0.7}});
  EXPECT_EQ(heights(0, 0), 0.1);
  EXPECT_EQ(heights(0, 1), 0.7);
}

TEST_F(HeightIo, PicturesThatAreNotSoundAndGreyAreRefused) {
  const std::array<double, 2> range = {0, 1};
  EXPECT_THAT(height_fault(picture("colour.png"), range).message, HasSubstr("expected grey only"));
  EXPECT_THAT(height_fault(picture("truncated.png"), range).message, HasSubstr("not a sound PNG"));
  EXPECT_THAT(height_fault(picture("huge.png"), range).message, HasSubstr("100 million"));
}

TEST_F(HeightIo, ARangeGoesWithAPictureAndWithNothingElse) {
  EXPECT_THAT(height_fault(picture("grey16.png")).message, HasSubstr("range: [lo, hi]"));
  EXPECT_THAT(height_fault(write("1 2\n"), {{0, 1}}).message, HasSubstr("belongs to a PNG"));
}

}  // namespace
