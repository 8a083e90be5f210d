#include "app/assembly/build_radiation.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace {

/// Keeps the warnings that it is told.
class KeptWarnings : public app::Reporter {
 public:
  void note(const std::string&) override {}
  void warning(const std::string& text) override { warnings.push_back(text); }
  std::vector<std::string> warnings;
};

TEST(SolutionOfRadiation, IsWarnedOfAboveATenthAndRefusedAboveThreeTenths) {
  KeptWarnings kept;
  assembly::check_mismatch("hull", 0.099, kept);
  EXPECT_TRUE(kept.warnings.empty());
  assembly::check_mismatch("hull", 0.12, kept);
  ASSERT_EQ(kept.warnings.size(), 1);
  EXPECT_NE(kept.warnings[0].find("radiation of hull: "), std::string::npos);
  EXPECT_NE(kept.warnings[0].find("12 %"), std::string::npos);
  EXPECT_THROW(assembly::check_mismatch("hull", 0.31, kept), std::invalid_argument);
}

}  // namespace
