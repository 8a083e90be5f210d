#include <stdexcept>

#include "tests/app/fmu/unpacked.h"

namespace support {

void unpack(const std::filesystem::path& archive, const std::filesystem::path&) {
  throw std::runtime_error(archive.string() + " cannot be unpacked without minizip");
}

}  // namespace support
