#include "app/pages/page_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/files.h"

namespace {

TEST(PageFile, DataCannotEndTheScriptThatHoldsThem) {
  const std::string names[] = {"</script><script>alert(1)</script>",
                               "<!--<script>",
                               "]]>",
                               "a\"b'c\\",
                               "$(touch pwned)`touch pwned`",
                               "two\nlines",
                               std::string("\x01\x1b\x7f"),
                               "@PLIMSOLL_DATA@"};
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "page_file.html";
  const std::string head = "<script type=\"application/json\">", tail = "</script>";
  for (const std::string& name : names) {
    app::write_page(file, head + "@PLIMSOLL_DATA@" + tail, {{"title", name}, {name, 1}});
    const std::string page = support::bytes_in(file);
    ASSERT_TRUE(page.starts_with(head) && page.ends_with(tail)) << name;
    const std::string data = page.substr(head.size(), page.size() - head.size() - tail.size());
    EXPECT_EQ(data.find('<'), std::string::npos) << name;
    const auto read = nlohmann::ordered_json::parse(data);
    EXPECT_EQ(read.at("title"), name);
    EXPECT_EQ(read.at(name), 1);
  }
  std::filesystem::remove(file);
}

TEST(PageFile, BytesThatAreNoUtf8AreReplaced) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "page_bytes.html";
  app::write_page(file, "@PLIMSOLL_DATA@", {{"title", "a\xff"}});
  EXPECT_EQ(nlohmann::ordered_json::parse(support::bytes_in(file)).at("title"), "a\xEF\xBF\xBD");
  std::filesystem::remove(file);
}

}  // namespace
