#include <stdexcept>

#include "app/fmu/archive.h"

namespace fmu {

std::string why_no_archives() { return "this program was built without minizip"; }

void write_archive(const std::filesystem::path& file, const std::vector<ArchiveEntry>&) {
  throw std::runtime_error(file.string() + ": " + why_no_archives());
}

}  // namespace fmu
