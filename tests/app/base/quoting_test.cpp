#include "app/base/quoting.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

namespace {

using app::csv_field;
using app::shell_word;
using app::shown;
using app::valid_utf8;
using app::xml_text;

/// What may stand in the names of files, and in those of bodies of foreign logs.
const std::string kNames[] = {"<script>alert(1)</script>",
                              "</script><b>",
                              "a\"b'c",
                              "$(touch pwned) `touch pwned`",
                              "two\nlines\r\n#SBATCH --output=x",
                              "]]><x>",
                              std::string("control\x01\x1b[31m\x7f", 14),
                              "not \xff\xfe UTF-8 \xc3",
                              "it's; rm -rf $HOME & \\",
                              "-rf",
                              ""};

TEST(Quoting, OfXmlLeavesNoMarkupAndNoControlCharacter) {
  for (const std::string& name : kNames) {
    const std::string text = xml_text(name);
    EXPECT_EQ(text.find_first_of("<>\""), std::string::npos) << text;
    for (const char c : text) EXPECT_GE(static_cast<unsigned char>(c), 0x20) << text;
    EXPECT_EQ(valid_utf8(text), text);
  }
  EXPECT_EQ(xml_text("a & b < c"), "a &amp; b &lt; c");
  EXPECT_EQ(xml_text("é≤😀"), "é≤😀");
}

TEST(Quoting, OfUtf8ReplacesForeignBytesOneByOne) {
  const std::string mark = "\xEF\xBF\xBD";
  EXPECT_EQ(valid_utf8("a\xff"), "a" + mark);
  EXPECT_EQ(valid_utf8("\xc0\x80"), mark + mark);             // an overlong zero
  EXPECT_EQ(valid_utf8("\xed\xa0\x80"), mark + mark + mark);  // half of a surrogate pair
  EXPECT_EQ(valid_utf8("\xf4\x90\x80\x80"), mark + mark + mark + mark);
  EXPECT_EQ(valid_utf8("é\xc3"), "é" + mark);
}

TEST(Quoting, OfTerminalsLeavesNothingToObey) {
  EXPECT_EQ(shown("\x1b]0;owned\a\x1b[31mred"), "\\x1b]0;owned\\x07\\x1b[31mred");
  EXPECT_EQ(shown("\xc2\x9b"
                  "31m"),
            "\\u009b31m");  // a control sequence in one character
  EXPECT_EQ(shown("\x9b"
                  "31m"),
            "\\x9b31m");  // and in one byte, which is no UTF-8
  EXPECT_EQ(shown("\x7f"), "\\u007f");
  EXPECT_EQ(shown("a\nb\r\tc"), "a\\nb\\r\\tc");
  EXPECT_EQ(shown("a\nb\tc\r", "\n\t"), "a\nb\tc\\r");
  EXPECT_EQ(shown("é≤😀 \xc2\xa0"), "é≤😀 \xc2\xa0");
  for (const std::string& name : kNames) EXPECT_EQ(valid_utf8(shown(name)), shown(name));
}

TEST(Quoting, OfCsvFollowsRfc4180) {
  EXPECT_EQ(csv_field("plain name"), "plain name");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("a\"b"), "\"a\"\"b\"");
  EXPECT_EQ(csv_field("a\nb"), "\"a\nb\"");
}

struct ClosePipe {
  void operator()(std::FILE* pipe) const { ::pclose(pipe); }
};

/// Returns what a command of bash receives as its argument.
std::string through_bash(const std::string& word) {
  const std::string file = testing::TempDir() + "quoting_test.bash";
  std::ofstream(file) << "printf %s. " << word << '\n';
  std::unique_ptr<std::FILE, ClosePipe> pipe(::popen(("bash " + file).c_str(), "r"));
  std::string output;
  for (int c; (c = std::fgetc(pipe.get())) != EOF;) output += static_cast<char>(c);
  pipe.reset();
  std::filesystem::remove(file);
  if (!output.empty()) output.pop_back();  // the full stop
  return output;
}

TEST(Quoting, OfTheShellGivesTheWordBackOnOneLine) {
  for (const std::string& name : kNames) {
    const std::string word = shell_word(name);
    EXPECT_EQ(through_bash(word), name) << word;
    EXPECT_EQ(word.find_first_of("\n\r"), std::string::npos) << word;
  }
  EXPECT_EQ(shell_word("scenes/a-1.yaml"), "scenes/a-1.yaml");
}

}  // namespace
