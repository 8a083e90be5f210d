#include "app/scene/formula.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace {

using scene::Formula;
using testing::HasSubstr;

/// What a text that is no formula is refused with.
std::string fault_of(const std::string& text) {
  try {
    const Formula formula(text);
  } catch (const scene::FormulaError& error) {
    return error.what();
  }
  return "";
}

TEST(Formula, HasTheValuesOfItsFunctions) {
  const double t = 1.7;
  for (const auto& [text, value] : std::initializer_list<std::pair<const char*, double>>{
           {"t", t},
           {"1e-3", 1e-3},
           {"35*sin(2*pi*t/4)", 35 * std::sin(2 * M_PI * t / 4)},
           {"-t^2", -t * t},
           {"2^-1", 0.5},
           {"e^t", std::exp(t)},
           {"ln(exp(t)) + log10(100)", t + 2},
           {"atan2(-1, -t) + atan(t)", std::atan2(-1, -t) + std::atan(t)},
           {"sqrt(abs(-t*t))", t},
           {"mod(-1, 3)", 2},
           {"clamp(t, 0, 1) + min(3, t, 2) + max(t, -t)", 1 + t + t},
           {"step(t - 1.7) + step(-1)", 1},
           {"smooth(0.5) + smooth(-1) + smooth(2)", 1.5},
           {"floor(t) + 10*ceil(t) + 100*round(t) + sign(-t)", 1 + 20 + 200 - 1},
           {"t < 1 ? 5 : t < 2 && t >= 1 ? 6 : 7", 6}})
    EXPECT_NEAR(Formula(text).at(t), value, 1e-12 * (1 + std::abs(value))) << text;
}

TEST(Formula, KeepsNothingFromOneTimeToTheNext) {
  const Formula formula("3*t + 1");
  EXPECT_EQ(formula.at(2), 7);
  EXPECT_EQ(formula.at(-1), -2);
  EXPECT_EQ(formula.at(2), 7);
}

TEST(Formula, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(fault_of("3*sinn(t)"), "found the unknown name sinn at character 3; did you mean sin?");
  EXPECT_EQ(fault_of("t = 3"),
            "found = at character 3, expected == to compare; a formula assigns nothing");
  EXPECT_EQ(fault_of("3 + \"a\""), "found \" at character 5, expected a formula");
  EXPECT_THAT(fault_of("3*(t + 1"), HasSubstr("bracket without its partner"));
  EXPECT_THAT(fault_of("t + 1)"), HasSubstr("bracket without its partner at character 6"));
  EXPECT_EQ(fault_of("3*"), "ends too early, expected another term");
  EXPECT_EQ(fault_of(" "), "ends too early, expected another term");
  EXPECT_THAT(fault_of("sin(t, 2)"), HasSubstr("too many arguments"));
  EXPECT_THAT(fault_of("atan2(t)"), HasSubstr("too few arguments"));
  EXPECT_NE(fault_of("1, 2"), "");
  EXPECT_THAT(fault_of(std::string(2000, '1')), HasSubstr("found 2000 characters"));
}

TEST(Formula, RefusesWhateverIsNoFormula) {
  for (const std::string text :
       {"t t",  "1..2", "t ? 1", "max()",  "sin t",     "t := 3", "a = 1", "rnd()",
        "sin",  "()",   "1 2",   "t |",    "!t",        "_pi",    "x",     "\xff",
        "t; t", "&",    ":",     "2 ** 3", "sum(1, 2)", "(1, 2)"})
    EXPECT_NE(fault_of(text), "") << text;
  EXPECT_NE(fault_of(std::string(500, '(')), "");
  EXPECT_EQ(Formula(std::string(400, '(') + "t" + std::string(400, ')')).at(3), 3);
}

TEST(Formula, JumpsWhereItComparesOrRounds) {
  for (const char* text :
       {"step(t)", "t > 3", "t == 1 ? 2 : 3", "floor(t)", "mod(t, 3)", "sign(t)"})
    EXPECT_TRUE(Formula(text).jumps()) << text;
  for (const char* text : {"sin(t)", "clamp(t, 0, 1)", "smooth(t)", "abs(t)"})
    EXPECT_FALSE(Formula(text).jumps()) << text;
}

TEST(Formula, IsNotFiniteWhereItsTermsAreNot) {
  EXPECT_TRUE(std::isinf(Formula("1/t").at(0)));
  EXPECT_TRUE(std::isnan(Formula("sqrt(t)").at(-1)));
}

}  // namespace
