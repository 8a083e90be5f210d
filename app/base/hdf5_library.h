#pragma once

// Later versions of the library give these names to other functions.
#define H5_USE_110_API
#include <hdf5.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

/// @file
/// Common part of the users of the HDF5 library: hdf5_file.cpp and hdf5_reader.cpp of logs/ and
/// hdf5_arrays.cpp of databases/. Only they may include it.

namespace app::hdf5 {

/// An object of the library.
class Handle {
 public:
  using Closer = herr_t (*)(hid_t);
  Handle() = default;
  Handle(hid_t id, Closer closer) : id_(id), closer_(closer) {}
  ~Handle() { close(); }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), closer_(other.closer_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(closer_, other.closer_);
    return *this;
  }

  operator hid_t() const { return id_; }
  /// Closes the object once. @return false if that failed
  bool close() {
    const hid_t id = std::exchange(id_, -1);
    return id < 0 || closer_(id) >= 0;
  }
  /// Gives up the object without closing it.
  void release() { id_ = -1; }

 private:
  hid_t id_ = -1;
  Closer closer_ = nullptr;
};

/// Must precede all other calls of the library in each thread. The library then prints nothing, and
/// writes nothing at the program's end.
inline void prepare_library() {
  static const bool once = [] {
    H5dont_atexit();
    return true;
  }();
  static_cast<void>(once);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

/// Returns properties that disable the library's own locks, which some file systems refuse.
inline Handle access_without_locks() {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_file_locking(access, false, true);
  return access;
}

/// Opens a file for reading; the handle is negative if its structure is damaged.
inline Handle open_to_read(const std::filesystem::path& file) {
  return {H5Fopen(file.c_str(), H5F_ACC_RDONLY, access_without_locks()), H5Fclose};
}

/// Returns the type of texts of any length.
inline Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

/// Returns the system's message within the library's last error, or else the library's innermost
/// message.
inline std::string last_error() {
  std::string found = "the HDF5 library failed";
  const auto look = [](unsigned, const H5E_error2_t* error, void* text) -> herr_t {
    constexpr std::string_view kBefore = "error message = '";
    const std::string_view said = error->desc ? error->desc : "";
    const std::size_t start = said.find(kBefore);
    const bool of_system = start != std::string_view::npos;
    const std::string_view rest = of_system ? said.substr(start + kBefore.size()) : said;
    *static_cast<std::string*>(text) = rest.substr(0, of_system ? rest.find('\'') : rest.size());
    return of_system ? 1 : 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, look, &found);
  return found;
}

}  // namespace app::hdf5
