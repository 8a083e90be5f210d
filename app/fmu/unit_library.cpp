#include "app/fmu/unit_library.h"

#include <stdexcept>
#include <system_error>

#include "app/base/child_process.h"

namespace fmu {

std::filesystem::path unit_library() {
  const char* const name = "plimsoll_unit.so";
  std::error_code error;
  const auto folder = std::filesystem::path(app::program_path()).parent_path();
  const std::filesystem::path built = folder / "fmu" / name;
  const std::filesystem::path installed = (folder / PLIMSOLL_UNIT_FOLDER / name).lexically_normal();
  for (const std::filesystem::path& file : {built, installed})
    if (std::filesystem::is_regular_file(file, error)) return file;
  throw std::runtime_error("the library of units is missing: it is neither " + built.string() +
                           " nor " + installed.string() +
                           "; build the target plimsoll_unit, or install plimsoll anew");
}

}  // namespace fmu
