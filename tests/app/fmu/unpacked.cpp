#include "tests/app/fmu/unpacked.h"

#include <unzip.h>

#include <array>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>

namespace support {
namespace {

void expect(bool good, const std::filesystem::path& archive) {
  if (!good) throw std::runtime_error(archive.string() + " is no good archive");
}

}  // namespace

void unpack(const std::filesystem::path& archive, const std::filesystem::path& folder) {
  const std::unique_ptr<void, decltype(&unzClose)> zip(unzOpen64(archive.c_str()), unzClose);
  expect(zip != nullptr, archive);
  int more = unzGoToFirstFile(zip.get());
  for (; more == UNZ_OK; more = unzGoToNextFile(zip.get())) {
    std::array<char, 1024> name{};
    expect(unzGetCurrentFileInfo64(zip.get(), nullptr, name.data(), name.size() - 1, nullptr, 0,
                                   nullptr, 0) == UNZ_OK,
           archive);
    const std::filesystem::path file = folder / name.data();
    std::filesystem::create_directories(file.parent_path());
    std::ofstream out(file, std::ios::binary);
    expect(unzOpenCurrentFile(zip.get()) == UNZ_OK, archive);
    std::string part(1 << 16, '\0');
    int size = 0;
    while ((size = unzReadCurrentFile(zip.get(), part.data(), static_cast<unsigned>(part.size()))) >
           0)
      out.write(part.data(), size);
    // Closing tells of a wrong checksum.
    expect(size == 0 && unzCloseCurrentFile(zip.get()) == UNZ_OK, archive);
  }
  expect(more == UNZ_END_OF_LIST_OF_FILE, archive);
}

}  // namespace support
