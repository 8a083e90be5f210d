#include "app/assembly/signals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "app/scene/diagnostics.h"

namespace {

using scene::Interpolation;

std::filesystem::path table_file(const std::string& text) {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path file = testing::TempDir() + "signals_" + test.name() + ".csv";
  std::ofstream(file) << text;
  return file;
}

/// What a table is refused with.
std::string fault_of(const std::string& text, const std::string& column = "") {
  try {
    assembly::read_signal({.file = table_file(text), .column = column});
  } catch (const scene::InputError& error) {
    const scene::Fault& fault = error.faults().front();
    return (fault.place.line > 0 ? std::to_string(fault.place.line) + ": " : "") + fault.message;
  }
  return "";
}

TEST(Signals, ATableIsLinearBetweenItsRowsAndHoldsItsEnds) {
  const auto signal = assembly::table_signal({1, 2, 4}, {10, 20, -20}, Interpolation::linear);
  EXPECT_FALSE(signal->jumps());
  EXPECT_EQ(signal->at(-5), 10);
  EXPECT_EQ(signal->at(1), 10);
  EXPECT_EQ(signal->at(1.25), 12.5);
  EXPECT_EQ(signal->at(2), 20);
  EXPECT_EQ(signal->at(3), 0);
  EXPECT_EQ(signal->at(4), -20);
  EXPECT_EQ(signal->at(9), -20);
}

TEST(Signals, AStepIsTakenAtTheTimeOfItsRow) {
  const auto signal = assembly::table_signal({1, 2}, {10, 20}, Interpolation::step);
  EXPECT_TRUE(signal->jumps());
  EXPECT_EQ(signal->at(0), 10);
  EXPECT_EQ(signal->at(1.999), 10);
  EXPECT_EQ(signal->at(2), 20);
  EXPECT_EQ(signal->at(3), 20);
}

TEST(Signals, OneRowIsAConstant) {
  for (const Interpolation way : {Interpolation::linear, Interpolation::step})
    for (const double time : {-1.0, 3.0, 5.0})
      EXPECT_EQ(assembly::table_signal({3}, {7}, way)->at(time), 7);
}

TEST(Signals, AFormulaIsOneOfTime) {
  EXPECT_EQ(assembly::formula_signal("2*t + 1")->at(3), 7);
  EXPECT_TRUE(assembly::formula_signal("step(t)")->jumps());
}

TEST(Signals, AFileGivesTheColumnThatIsAskedFor) {
  const auto file = table_file("rps, time, angle\n3, 0, 30\n5, 2, 40\n");
  EXPECT_EQ(assembly::read_signal({.file = file})->at(1), 4);
  EXPECT_EQ(assembly::read_signal({.file = file, .column = "angle"})->at(1), 35);
  EXPECT_EQ(
      assembly::read_signal({.file = file, .column = "angle", .interpolation = Interpolation::step})
          ->at(1),
      30);
}

TEST(Signals, AWrongFileIsRefusedWithItsPlace) {
  EXPECT_EQ(fault_of("time,v\n0,1\n2,2\n2,3\n"),
            "4: found the time 2 s after 2 s, expected rising ones");
  EXPECT_EQ(fault_of("time,speed,angle\n0,1,2\n", "sped"),
            "has no column sped; did you mean speed?");
  EXPECT_EQ(fault_of("time,speed,angle\n0,1,2\n", "thrust"),
            "has no column thrust, expected speed or angle");
  EXPECT_EQ(fault_of("v,w\n0,1\n"), "expected the column time [s] and another with the values");
  EXPECT_EQ(fault_of("time\n0\n"), "expected the column time [s] and another with the values");
  EXPECT_EQ(fault_of("time,v\n"), "has no row, expected at least one");
  EXPECT_THAT(fault_of("time,v\n0,nan\n"), testing::HasSubstr("2: "));
}

}  // namespace
