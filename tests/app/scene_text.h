#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/scene/reader.h"

namespace support {

/// A small valid scene of one box, named `a`.
inline const char* const kSmallScene =
    "plimsoll: 1\n"
    "duration: 1\n"
    "bodies:\n"
    "  - name: a\n"
    "    box: {size: [1, 1, 1]}\n"
    "    density: 500\n";

/// Folder of the files that the scenes of tests name.
std::filesystem::path data_folder();

/// Writes `text` to a file of the running test's own. @return its path.
std::filesystem::path write_scene(const std::string& text);

/// Reads `text` as a scene file. @param overrides   As on the command line: `step=0.1`.
scene::Scene read_scene_text(const std::string& text,
                             const std::vector<std::string>& overrides = {});

/// The faults of `text` as a scene file, without the file's name: `2:11: duration: found …`.
std::vector<std::string> faults_of(const std::string& text,
                                   const std::vector<std::string>& overrides = {});

/// The faults of a scene file, without its name.
std::vector<std::string> faults_of_file(const std::filesystem::path& file,
                                        const std::vector<scene::Override>& overrides = {});

}  // namespace support
