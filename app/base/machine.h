#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace app {

/// Returns the memory that this process can still use without swapping [bytes]: what the kernel
/// estimates as available, or what the limits of the control groups and of the address space leave
/// if that is less. None if it is not known.
std::optional<double> available_memory();

/// Returns the space for files in a folder, or in the nearest folder above it that exists [bytes].
/// None if it is not known.
std::optional<double> available_disk(const std::filesystem::path& folder);

/// Returns a number of gigabytes for a sentence: `0.25`, `3.4`, `240`.
std::string gigabytes(double number);

/// Verdict on a need of memory on this machine.
struct MemoryVerdict {
  bool fault = false;  ///< The need is more than twice what is free: it cannot work.
  std::string text;    ///< `needs about 38 GiB of memory, this machine has 24 GiB free`
};

/// Judges a need; none if it is not more than the free amount.
/// @param available   [bytes]; none: not known.
std::optional<MemoryVerdict> judged_need(double bytes, const std::optional<double>& available);

}  // namespace app
