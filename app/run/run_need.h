#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/logs/log.h"
#include "app/logs/make_log.h"
#include "app/scene/scene.h"

/// @file
/// Needs of a run besides its bodies (app/assembly/memory_need.h), estimated
/// before its first step. Each is within a factor of two of what was measured.

namespace app {

/// Returns the size of the log of a run [bytes].
/// @param times   Number of times that are logged.
double log_bytes(const LogSubject& subject, double times, LogFormat format);

/// Returns the number of times that a run of the scene logs.
double logged_times(const scene::Scene& scene);

/// Returns the memory that drawing takes [bytes]: the framebuffers of the renderer, which lie in
/// the main memory where no graphics card draws, and the pictures that wait to be written.
double picture_bytes(const std::array<int, 2>& size);

/// Returns a warning of a log that does not fit on the disk.
/// @param available   Free space of the disk [bytes]; none: not known.
std::optional<std::string> log_warning(double bytes, const std::optional<double>& available);

/// Returns a warning of pictures that need more memory than is free; none if the scene has none.
/// @throws InputError if they need more than twice as much
std::optional<std::string> picture_warning(const scene::Scene& scene);

/// Returns warnings of a run that needs more memory or disk than is free.
/// @param draws   True if the run draws pictures.
/// @throws InputError as picture_warning
std::vector<std::string> run_warnings(const scene::Scene& scene, const LogSubject& subject,
                                      LogFormat format, const std::filesystem::path& out,
                                      bool draws);

}  // namespace app
