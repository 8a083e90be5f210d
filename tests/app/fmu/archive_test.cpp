#include "app/fmu/archive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/fmu/unpacked.h"
#include "tests/support/files.h"

namespace {

namespace fs = std::filesystem;

TEST(Archive, ReadsBackAndHasTheSameBytesAgain) {
  if (!fmu::why_no_archives().empty()) GTEST_SKIP() << fmu::why_no_archives();
  const fs::path place = fs::path(testing::TempDir()) / "plimsoll_archive";
  fs::remove_all(place);
  fs::create_directories(place);
  const std::vector<fmu::ArchiveEntry> entries = {
      {"a.txt", "hello"}, {"deep/er/b", std::string(100000, 'x')}, {"\xc3\xa4", ""}};
  fmu::write_archive(place / "one.zip", entries);
  fmu::write_archive(place / "two.zip", entries);
  EXPECT_EQ(support::bytes_in(place / "one.zip"), support::bytes_in(place / "two.zip"));
  EXPECT_LT(fs::file_size(place / "one.zip"), 2000U);
  support::unpack(place / "one.zip", place / "out");
  for (const fmu::ArchiveEntry& entry : entries)
    EXPECT_EQ(support::bytes_in(place / "out" / entry.name), entry.bytes) << entry.name;
  EXPECT_THAT([&] { fmu::write_archive(place / "no/where.zip", entries); },
              testing::ThrowsMessage<std::runtime_error>(
                  testing::HasSubstr("where.zip: the archive cannot be written")));
  fs::remove_all(place);
}

}  // namespace
