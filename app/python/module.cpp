#include <dlfcn.h>

#include <filesystem>

#include "app/base/program_files.h"
#include "app/python/bindings.h"

namespace {

/// The folder of the package, to which this library belongs.
std::filesystem::path package_folder() {
  Dl_info info;
  return dladdr(reinterpret_cast<void*>(&package_folder), &info) == 0
             ? std::filesystem::path()
             : std::filesystem::path(info.dli_fname).parent_path();
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled part of plimsoll.";
  module.attr("__version__") = PLIMSOLL_VERSION;
  app::look_for_program_files_in(package_folder() / "share");
  python::bind_end(module);
  python::bind_errors(module);
  python::bind_scene(module);
  python::bind_simulation(module);
  python::bind_batch(module);
  python::bind_hydro(module);
}
