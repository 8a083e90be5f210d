#include "app/base/machine.h"

#include <gtest/gtest.h>
#include <unistd.h>

namespace {

TEST(Machine, HasMemoryAndNoMoreThanIsBuiltIn) {
  const auto available = app::available_memory();
  ASSERT_TRUE(available.has_value());
  const double built_in =
      static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  EXPECT_GT(*available, 1e6);
  EXPECT_LE(*available, built_in);
}

TEST(Machine, TheDiskOfAFolderThatIsNotMadeYetIsThatOfTheOneAbove) {
  const auto above = app::available_disk(testing::TempDir());
  const auto below = app::available_disk(testing::TempDir() + "none/of/these");
  ASSERT_TRUE(above && below);
  // Other programs write meanwhile.
  EXPECT_NEAR(*below / *above, 1, 0.1);
}

}  // namespace
