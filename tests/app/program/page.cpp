#include "tests/app/program/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace support {
namespace {

const std::string kBeforeData = "<p>before</p><script type=\"application/json\">";
const std::string kAfterData = "</script><p>after</p>";

}  // namespace

void lay_out_page(const Workplace& here, const std::string& name) {
  here.write("bin/none", "");
  here.write("share/plimsoll/report/" + name, kBeforeData + "@PLIMSOLL_DATA@" + kAfterData);
  std::filesystem::copy_file(PLIMSOLL_PROGRAM, here / "bin/plimsoll");
}

nlohmann::json data_in_page(const std::string& page) {
  const bool framed = page.starts_with(kBeforeData) && page.ends_with(kAfterData);
  EXPECT_TRUE(framed);
  if (!framed) return nullptr;
  const std::string text =
      page.substr(kBeforeData.size(), page.size() - kBeforeData.size() - kAfterData.size());
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("<")));
  return nlohmann::json::parse(text);
}

}  // namespace support
