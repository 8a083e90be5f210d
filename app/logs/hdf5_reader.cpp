#include "app/logs/hdf5_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <utility>

#include "app/base/byte_records.h"
#include "app/base/hdf5_library.h"
#include "app/scene/diagnostics.h"
#include "app/scene/isolated_reader.h"

namespace app {
namespace {

using hdf5::Handle;

/// Reads datasets, in the process that may crash.
class OpenHdf5 {
 public:
  explicit OpenHdf5(const std::filesystem::path& path) : path_(path) {
    hdf5::prepare_library();
    file_ = hdf5::open_to_read(path);
    if (file_ < 0) refuse("cannot be read: its HDF5 structure is damaged");
  }

  /// Writes a dataset as records: its name, its shape, whether it has texts, and its numbers or
  /// texts; nothing if there is none.
  void write(const std::string& name, const CallOutput& output) const {
    if (H5Lexists(file_, name.c_str(), H5P_DEFAULT) <= 0) return;
    const Handle dataset(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
    if (dataset < 0) return;
    const Handle space(H5Dget_space(dataset), H5Sclose);
    std::vector<hsize_t> shape(
        static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space))));
    H5Sget_simple_extent_dims(space, shape.data(), nullptr);
    const Handle own(H5Dget_type(dataset), H5Tclose);
    const bool of_texts = shape.size() == 1 && H5Tis_variable_str(own) > 0;
    put_record(output, name);
    put_record(output, std::span(std::as_const(shape)));
    const char mark = of_texts ? 1 : 0;
    put_record(output, std::span(&mark, 1));
    std::size_t count = 1;
    for (const hsize_t length : shape) count *= length;
    if (of_texts)
      write_texts(name, dataset, count, output);
    else
      write_numbers(name, dataset, count, output);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const { throw scene::InputError(path_, what); }

  void read(const std::string& name, hid_t dataset, hid_t type, void* to) const {
    if (H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, to) < 0)
      refuse(fmt::format("{} cannot be read: it is damaged", name));
  }

  void write_texts(const std::string& name, hid_t dataset, const std::size_t count,
                   const CallOutput& output) const {
    std::vector<const char*> texts(count, nullptr);
    read(name, dataset, hdf5::text_type(), texts.data());
    put_record(output, std::span(&count, 1));
    for (const char* text : texts) put_record(output, text ? text : "");
  }

  void write_numbers(const std::string& name, hid_t dataset, std::size_t count,
                     const CallOutput& output) const {
    std::vector<double> numbers(count);
    read(name, dataset, H5T_NATIVE_DOUBLE, numbers.data());
    put_record(output, std::span(std::as_const(numbers)));
  }

  const std::filesystem::path& path_;
  Handle file_;
};

}  // namespace

Hdf5Reader::Hdf5Reader(const std::filesystem::path& file, const std::vector<std::string>& names)
    : path_(file) {
  const std::string bytes = scene::read_hdf5_isolated(file, [&](const CallOutput& output) {
    const OpenHdf5 open(file);
    for (const std::string& name : names) open.write(name, output);
  });
  for (ByteRecords records(bytes); !records.at_end();) {
    Dataset& dataset = datasets_[std::string(records.bytes())];
    dataset.shape = records.values<std::size_t>();
    dataset.of_texts = records.values<char>().at(0) != 0;
    if (!dataset.of_texts) {
      dataset.numbers = records.values<double>();
      continue;
    }
    dataset.texts.resize(records.values<std::size_t>().at(0));
    for (std::string& text : dataset.texts) text = records.bytes();
  }
}

void Hdf5Reader::refuse(const std::string& what) const { throw scene::InputError(path_, what); }

const Hdf5Reader::Dataset& Hdf5Reader::dataset(const std::string& name) const {
  const auto found = datasets_.find(name);
  if (found == datasets_.end())
    refuse(fmt::format("has no dataset {}, which plimsoll run writes", name));
  return found->second;
}

std::vector<std::string> Hdf5Reader::texts(const std::string& name) const {
  const Dataset& found = dataset(name);
  if (!found.of_texts) refuse(fmt::format("{}: expected a list of texts", name));
  return found.texts;
}

std::vector<double> Hdf5Reader::numbers(const std::string& name,
                                        const std::vector<std::size_t>& row) const {
  const Dataset& found = dataset(name);
  std::vector<std::size_t> expected = row;
  expected.insert(expected.begin(), found.shape.empty() ? 0 : found.shape[0]);
  if (found.of_texts || found.shape != expected)
    refuse(fmt::format("{} has the shape {}, expected a row a time and {} in it", name,
                       fmt::join(found.shape, " x "), fmt::join(row, " x ")));
  return found.numbers;
}

}  // namespace app
