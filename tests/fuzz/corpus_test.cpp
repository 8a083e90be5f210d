#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

/// The targets of libFuzzer, each fed once with the files that tools/fuzz starts it from. A target
/// ends the process where a reader does anything but read an input or refuse it.

// clang-format off
#define LLVMFuzzerTestOneInput read_as_scene
#include "tests/fuzz/scene_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput read_as_override
#include "tests/fuzz/override_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput read_as_table
#include "tests/fuzz/table_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput read_as_log
#include "tests/fuzz/log_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput read_as_hdf5
#include "tests/fuzz/hdf5_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput read_as_tolerance
#include "tests/fuzz/tolerance_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput read_as_folder
#include "tests/fuzz/folder_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput read_as_mesh
#include "tests/fuzz/mesh_fuzz.cpp"
#undef LLVMFuzzerTestOneInput
// clang-format on

namespace {

namespace fs = std::filesystem;

struct Target {
  std::string name;
  int (*read)(const std::uint8_t*, std::size_t);
  std::vector<std::string> folders;  ///< As corpus_of in tools/fuzz has them.
};

const Target kTargets[] = {
    {"scene", read_as_scene, {"scenes", "tests/data/bad_scenes", "tests/data/bad_hollows"}},
    {"override", read_as_override, {"tests/fuzz/corpus/override"}},
    {"table", read_as_table, {"tests/data/heights", "scenes/files"}},
    {"log", read_as_log, {"tests/fuzz/corpus/log"}},
    {"hdf5", read_as_hdf5, {"tests/fuzz/corpus/hdf5"}},
    {"tolerance", read_as_tolerance, {"tests/fuzz/corpus/tolerance"}},
    {"folder", read_as_folder, {"tests/fuzz/corpus/folder"}},
    {"mesh",
     read_as_mesh,
     {"tests/fuzz/corpus/mesh", "tests/fuzz/corpus/meshes", "tests/data/bad_meshes"}}};

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Corpus : public testing::TestWithParam<Target> {};

TEST_P(Corpus, IsReadOrRefused) {
  constexpr std::size_t kLongest = 1 << 18;  // Longer ones are meshes of scenes.
  int fed = 0;
  for (const std::string& folder : GetParam().folders)
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(PLIMSOLL_SOURCE_DIR) / folder)) {
      if (!entry.is_regular_file() || entry.file_size() > kLongest) continue;
      const std::string bytes = bytes_of(entry.path());
      SCOPED_TRACE(entry.path());
      GetParam().read(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
      ++fed;
    }
  EXPECT_GT(fed, 0);
}

INSTANTIATE_TEST_SUITE_P(Readers, Corpus, testing::ValuesIn(kTargets),
                         [](const auto& target) { return target.param.name; });

}  // namespace
