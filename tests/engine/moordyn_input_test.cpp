#include "engine/rig/moordyn/moordyn_input.h"

#include <gtest/gtest.h>

namespace {

using engine::has_section;
using engine::option_of;
using engine::with_options;

const std::string kText =
    "--- POINTS ---\n"
    "1 Fixed 0 0 0\n"
    "---------- OPTIONS ----------\n"
    "2 writelog a log\n"
    "9.81 Gravity\r\n"
    "0.001 dtM\n"
    "1 WaveKin\n"
    "2 WaveKin\n"
    "--- OUTPUTS ---\n"
    "2 g\n";

TEST(MoorDynInput, OptionsTakeThePlaceOfThoseOfTheirNames) {
  EXPECT_EQ(with_options(kText, {{"writeLog", {}, "1"}, {"g", {"gravity"}, "9.5"}}),
            "--- POINTS ---\n"
            "1 Fixed 0 0 0\n"
            "---------- OPTIONS ----------\n"
            "0.001 dtM\n"
            "1 WaveKin\n"
            "2 WaveKin\n"
            "1 writeLog\n"
            "9.5 g\n"
            "--- OUTPUTS ---\n"
            "2 g\n"
            "--- need this line ---\n");
}

TEST(MoorDynInput, OptionsAreAddedWhereTheTextHasNone) {
  EXPECT_EQ(with_options("--- POINTS ---\n1 Fixed 0 0 0", {{"g", {}, "1"}}),
            "--- POINTS ---\n1 Fixed 0 0 0\n--- OPTIONS ---\n1 g\n--- need this line ---\n");
  EXPECT_EQ(with_options("--- Options ---\n2 g", {{"g", {}, "1"}}),
            "--- Options ---\n1 g\n--- need this line ---\n");
}

TEST(MoorDynInput, OfAnOptionThatIsGivenTwiceTheLastCounts) {
  EXPECT_EQ(option_of(kText, "wavekin"), "2");
  EXPECT_EQ(option_of(kText, "DTM"), "0.001");
  EXPECT_EQ(option_of(kText, "g"), std::nullopt);  // an output
}

TEST(MoorDynInput, ASectionIsFoundByItsHead) {
  EXPECT_TRUE(has_section(kText, "OPTIONS"));
  EXPECT_FALSE(has_section(kText, "FIXED"));
}

}  // namespace
