#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace app {

/// Content of a file of Hdf5Writer (hdf5_file.h), even if its program was killed. A damaged file
/// can crash the library, so it reads in a process of its own
/// (app/scene/isolated_reader.h), which takes some milliseconds and returns all datasets at once.
///
/// All functions throw InputError if the file is not as expected.
class Hdf5Reader {
 public:
  /// Reads those of the datasets that the file has.
  Hdf5Reader(const std::filesystem::path& file, const std::vector<std::string>& names);

  /// True if the file has a dataset of that name, which is one of those that were read.
  bool has(const std::string& name) const { return datasets_.contains(name); }
  std::vector<std::string> texts(const std::string& name) const;
  /// Returns all numbers of a series, row by row. @param shape   Expected shape of a row.
  std::vector<double> numbers(const std::string& name, const std::vector<std::size_t>& shape) const;

 private:
  struct Dataset {
    std::vector<std::size_t> shape;
    std::vector<double> numbers;     ///< Empty for texts.
    std::vector<std::string> texts;  ///< Empty for numbers.
    bool of_texts = false;
  };
  [[noreturn]] void refuse(const std::string& what) const;
  const Dataset& dataset(const std::string& name) const;

  std::filesystem::path path_;
  std::map<std::string, Dataset> datasets_;
};

}  // namespace app
