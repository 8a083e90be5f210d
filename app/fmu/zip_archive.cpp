#include <zip.h>

#include <limits>
#include <stdexcept>

#include "app/fmu/archive.h"

namespace fmu {
namespace {

/// The first time that an archive can tell.
constexpr zip_fileinfo kStamp = {
    .tmz_date =
        {.tm_sec = 0, .tm_min = 0, .tm_hour = 0, .tm_mday = 1, .tm_mon = 0, .tm_year = 1980},
    .dosDate = 0,
    .internal_fa = 0,
    .external_fa = 0};

/// The flag of names in UTF-8, in the format's field of flags.
constexpr unsigned long kUtf8 = 1UL << 11;

bool add(zipFile zip, const ArchiveEntry& entry) {
  if (zipOpenNewFileInZip4_64(zip, entry.name.c_str(), &kStamp, nullptr, 0, nullptr, 0, nullptr,
                              Z_DEFLATED, Z_DEFAULT_COMPRESSION, 0, -MAX_WBITS, DEF_MEM_LEVEL,
                              Z_DEFAULT_STRATEGY, nullptr, 0, 0, kUtf8, 0) != ZIP_OK)
    return false;
  const bool written = zipWriteInFileInZip(zip, entry.bytes.data(),
                                           static_cast<unsigned>(entry.bytes.size())) == ZIP_OK;
  return zipCloseFileInZip(zip) == ZIP_OK && written;
}

}  // namespace

std::string why_no_archives() { return ""; }

void write_archive(const std::filesystem::path& file, const std::vector<ArchiveEntry>& entries) {
  const auto fail = [&](const std::string& reason) {
    throw std::runtime_error(file.string() + ": " + reason);
  };
  for (const ArchiveEntry& entry : entries)
    if (entry.bytes.size() > std::numeric_limits<unsigned>::max())
      fail(entry.name + " is larger than 4 GiB, which an archive cannot hold");
  zipFile zip = zipOpen64(file.c_str(), APPEND_STATUS_CREATE);
  if (zip == nullptr) fail("the archive cannot be written");
  bool good = true;
  for (const ArchiveEntry& entry : entries) good = good && add(zip, entry);
  good = zipClose(zip, nullptr) == ZIP_OK && good;
  if (!good) fail("the archive cannot be written; the disk may be full");
}

}  // namespace fmu
