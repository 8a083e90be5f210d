#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// @file
/// Archives in the format zip.

namespace fmu {

/// A file of an archive.
struct ArchiveEntry {
  std::string name;  ///< UTF-8, with slashes between folders.
  std::string bytes;
};

/// Returns why this program writes no archives; empty where it does.
std::string why_no_archives();

/// Writes an archive. The same entries give the same bytes: all have the time stamp of 1980-01-01.
/// @throws std::runtime_error that names the file
void write_archive(const std::filesystem::path& file, const std::vector<ArchiveEntry>& entries);

}  // namespace fmu
