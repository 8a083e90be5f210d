#include "app/fmu/file_bytes.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace fmu {

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in.is_open() || in.bad()) throw std::runtime_error(file.string() + " cannot be read");
  return bytes;
}

}  // namespace fmu
