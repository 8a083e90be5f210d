#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <span>
#include <string_view>
#include <utility>

#include "app/base/byte_records.h"
#include "app/base/hdf5_library.h"
#include "app/databases/open_arrays.h"
#include "app/scene/isolated_reader.h"

namespace databases {
namespace {

using app::hdf5::Handle;
using app::hdf5::prepare_library;

/// Most entries of an array: far more than a database has, and few enough for the memory.
constexpr hsize_t kMostEntries = hsize_t{1} << 28;

/// An open file, in the process that reads it.
class OpenArrays final : public ArrayFile {
 public:
  explicit OpenArrays(const std::filesystem::path& file) : ArrayFile(file) {
    prepare_library();
    file_ = app::hdf5::open_to_read(file);
    if (file_ < 0) refuse("cannot be read: its HDF5 structure is damaged");
  }

  std::optional<Array> find(const std::string& name) const override {
    prepare_library();
    if (!exists(name)) return std::nullopt;
    const Handle dataset(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
    if (dataset < 0) return std::nullopt;  // A group.
    const Handle space(H5Dget_space(dataset), H5Sclose);
    std::vector<hsize_t> extents(
        static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space))));
    H5Sget_simple_extent_dims(space, extents.data(), nullptr);
    Array array;
    array.shape.assign(extents.begin(), extents.end());
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    if (count <= 0 || static_cast<hsize_t>(count) > kMostEntries)
      refuse(fmt::format("{} has {} entries", name, count));
    array.dimensions = dimensions_of(dataset, array.shape.size());
    const Handle type(H5Dget_type(dataset), H5Tclose);
    const auto size = static_cast<std::size_t>(count);
    if (H5Tget_class(type) == H5T_STRING) {
      read_texts(name, dataset, type, size, array);
    } else {
      array.numbers.resize(size);
      if (H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.numbers.data()) <
          0)
        refuse(fmt::format("{} cannot be read as numbers", name));
    }
    return array;
  }

 private:
  /// True if each part of a path exists; the library asks for one after the other.
  bool exists(const std::string& name) const {
    for (std::size_t end = name.find('/');; end = name.find('/', end + 1)) {
      if (H5Lexists(file_, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
      if (end == std::string::npos) return true;
    }
  }

  /// Names by the dimension scales, which NetCDF-4 writes; empty if one is missing.
  std::vector<std::string> dimensions_of(hid_t dataset, std::size_t rank) const {
    if (rank == 0) return {};
    if (H5Aexists(dataset, "DIMENSION_LIST") <= 0)
      return rank == 1 ? std::vector{own_name(dataset)} : std::vector<std::string>{};
    const Handle attribute(H5Aopen(dataset, "DIMENSION_LIST", H5P_DEFAULT), H5Aclose);
    const Handle space(H5Aget_space(attribute), H5Sclose);
    const Handle own(H5Aget_type(attribute), H5Tclose);
    const Handle reference(H5Tvlen_create(H5T_STD_REF_OBJ), H5Tclose);
    if (H5Sget_simple_extent_npoints(space) != static_cast<hssize_t>(rank) ||
        H5Tget_class(own) != H5T_VLEN)
      return {};
    std::vector<hvl_t> lists(rank);
    if (H5Aread(attribute, reference, lists.data()) < 0) return {};
    std::vector<std::string> names;
    for (const hvl_t& list : lists) {
      if (list.len == 0) break;
      const Handle scale(H5Rdereference2(attribute, H5P_DEFAULT, H5R_OBJECT, list.p), H5Oclose);
      names.push_back(scale < 0 ? "" : own_name(scale));
    }
    H5Dvlen_reclaim(reference, space, H5P_DEFAULT, lists.data());
    if (names.size() != rank) names.clear();
    return names;
  }

  /// The last part of an object's path.
  static std::string own_name(hid_t object) {
    std::string name(
        static_cast<std::size_t>(std::max<ssize_t>(0, H5Iget_name(object, nullptr, 0))), '\0');
    if (!name.empty()) H5Iget_name(object, name.data(), name.size() + 1);
    return name.substr(name.rfind('/') + 1);
  }

  void read_texts(const std::string& name, hid_t dataset, hid_t own, std::size_t count,
                  Array& array) const {
    const auto fail = [&] { refuse(fmt::format("{} cannot be read as texts", name)); };
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_cset(type, H5Tget_cset(own));
    if (H5Tis_variable_str(own) > 0) {
      H5Tset_size(type, H5T_VARIABLE);
      std::vector<char*> read(count, nullptr);
      if (H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, read.data()) < 0) fail();
      for (char* text : read) {
        array.texts.emplace_back(text ? text : "");
        H5free_memory(text);
      }
      return;
    }
    const std::size_t length = H5Tget_size(own) + 1;
    if (length > kMostEntries / count) fail();
    H5Tset_size(type, length);
    std::string letters(length * count, '\0');
    if (H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, letters.data()) < 0) fail();
    for (std::size_t i = 0; i < count; ++i) array.texts.emplace_back(letters.c_str() + i * length);
  }

  Handle file_;
};

/// Writes an array for `array_in`.
void write(const app::CallOutput& output, const Array& array) {
  const std::size_t dimensions = array.dimensions.size();
  app::put_record(output, std::span(std::as_const(array.shape)));
  app::put_record(output, std::span(std::as_const(array.numbers)));
  app::put_record(output, std::span(&dimensions, 1));
  for (const std::string& name : array.dimensions) app::put_record(output, name);
  for (const std::string& text : array.texts) app::put_record(output, text);
}

Array array_in(std::string_view bytes) {
  app::ByteRecords records(bytes);
  Array array;
  array.shape = records.values<std::size_t>();
  array.numbers = records.values<double>();
  array.dimensions.resize(records.values<std::size_t>().at(0));
  for (std::string& name : array.dimensions) name = records.bytes();
  while (!records.at_end()) array.texts.emplace_back(records.bytes());
  return array;
}

/// The library can be crashed by a damaged file: each array is read in a process of its own, which
/// opens the file anew.
class Hdf5Arrays final : public ArrayFile {
 public:
  explicit Hdf5Arrays(const std::filesystem::path& file) : ArrayFile(file) {
    ask([](const OpenArrays&, const app::CallOutput&) {});
  }

  std::optional<Array> find(const std::string& name) const override {
    const std::string bytes = ask([&](const OpenArrays& file, const app::CallOutput& output) {
      if (const std::optional<Array> array = file.find(name)) write(output, *array);
    });
    if (bytes.empty()) return std::nullopt;
    return array_in(bytes);
  }

 private:
  std::string ask(
      const std::function<void(const OpenArrays&, const app::CallOutput&)>& question) const {
    return scene::read_hdf5_isolated(
        path(), [&](const app::CallOutput& output) { question(OpenArrays(path()), output); });
  }
};

}  // namespace

std::unique_ptr<ArrayFile> open_hdf5(const std::filesystem::path& file) {
  return std::make_unique<Hdf5Arrays>(file);
}

}  // namespace databases
