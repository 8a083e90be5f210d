#include "app/base/running_hash.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace {

std::uint64_t hash_in_parts(const std::string& text, std::size_t length) {
  app::RunningHash hash;
  for (std::size_t i = 0; i < text.size(); i += length) hash.add(text.substr(i, length));
  return hash.value();
}

const std::string kText = "0.05,b\xc3\xb6j,1.5,-2,0,1,0,0,0,0,0,0,0,0,0\n";

TEST(RunningHash, DependsOnTheBytesAndNotOnTheirParts) {
  const std::uint64_t whole = hash_in_parts(kText, kText.size());
  for (std::size_t length = 1; length < kText.size(); ++length)
    EXPECT_EQ(hash_in_parts(kText, length), whole) << length;
}

TEST(RunningHash, IsAnotherAfterEveryChangeOfAByteAndForEveryLength) {
  std::set<std::uint64_t> seen = {hash_in_parts(kText, 8), app::RunningHash().value()};
  for (std::size_t i = 0; i < kText.size(); ++i) {
    std::string changed = kText;
    changed[i] ^= 1;
    EXPECT_TRUE(seen.insert(hash_in_parts(changed, 8)).second) << i;
    EXPECT_TRUE(seen.insert(hash_in_parts(std::string(i + 1, '\0'), 8)).second) << i;
  }
}

}  // namespace
