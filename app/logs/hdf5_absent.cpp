#include "app/logs/hdf5_file.h"
#include "app/logs/hdf5_reader.h"
#include "app/scene/diagnostics.h"

/// Replaces hdf5_file.cpp and hdf5_reader.cpp in a build without the library.

namespace app {
namespace {

[[noreturn]] void refuse_file(const std::filesystem::path& file) {
  throw scene::InputError(file, why_no_hdf5());
}

}  // namespace

std::string why_no_hdf5() {
  return "this plimsoll was built without HDF5; install libhdf5-dev (Debian, Ubuntu; or HDF5 "
         "1.10.7 "
         "or later) and build it again from a new configuration";
}

struct Hdf5Writer::File {};

Hdf5Writer::Hdf5Writer(const std::filesystem::path& file, Mode) { refuse_file(file); }
Hdf5Writer::~Hdf5Writer() = default;
void Hdf5Writer::set_attributes(const Hdf5Attributes&) {}
void Hdf5Writer::add_texts(const std::string&, const std::vector<std::string>&) {}
std::size_t Hdf5Writer::add_series(const Hdf5Series&, const std::array<std::size_t, 2>&) {
  return 0;
}
std::size_t Hdf5Writer::find_series(const Hdf5Series&, std::size_t, std::uint64_t) { return 0; }
std::uint64_t Hdf5Writer::hash_of(std::size_t) const { return 0; }
void Hdf5Writer::reserve(std::size_t) {}
void Hdf5Writer::append(std::size_t, std::span<const double>) {}
void Hdf5Writer::flush() {}
void Hdf5Writer::close() {}

Hdf5Reader::Hdf5Reader(const std::filesystem::path& file, const std::vector<std::string>&) {
  refuse_file(file);
}
std::vector<std::string> Hdf5Reader::texts(const std::string&) const { return {}; }
std::vector<double> Hdf5Reader::numbers(const std::string&, const std::vector<std::size_t>&) const {
  return {};
}

}  // namespace app
