#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/databases/array_file.h"

/// @file
/// NetCDF in its classic format, with offsets of 32 or 64 bits (CDF-1, CDF-2).
/// Source: NetCDF Classic Format Specification, Unidata.

namespace databases {

/// Opens a file. Arrays along an unlimited dimension are not read.
/// @throws InputError if the file is damaged
std::unique_ptr<ArrayFile> open_netcdf_classic(const std::filesystem::path& file);

/// An array that is written, with its attributes. Texts get a dimension of their longest length.
struct NamedArray {
  std::string name;
  Array array;
  std::vector<std::pair<std::string, std::string>> attributes = {};
};

/// The bytes of a CDF-2 file. Dimensions of equal names have equal lengths.
std::string netcdf_bytes(const std::vector<std::pair<std::string, std::string>>& attributes,
                         const std::vector<NamedArray>& arrays);

}  // namespace databases
