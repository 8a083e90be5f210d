#include "app/base/open_file.h"

#include <sys/stat.h>

namespace app {

bool has_name(int descriptor, const std::filesystem::path& name) {
  struct stat open = {};
  struct stat named = {};
  return ::fstat(descriptor, &open) == 0 && ::stat(name.c_str(), &named) == 0 &&
         open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

}  // namespace app
