#include "app/scene/isolated_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <new>
#include <system_error>

#include "app/base/machine.h"
#include "app/scene/diagnostics.h"

namespace scene {
namespace {

constexpr double kGibibyte = 1024.0 * 1024 * 1024;

/// The last byte of an answer says what stands before it: that was read, or the text of a fault
/// after whatever had been read.
constexpr char kRead = 'r', kFault = 'f';

void put(const app::CallOutput& output, const std::string& bytes) {
  output({bytes.data(), bytes.size()});
}

/// End of the text of a fault.
struct FaultEnd {
  std::uint32_t length = 0;           ///< Length of the text [bytes].
  std::int32_t line = 0, column = 0;  ///< Place of the fault.
};

/// Writes a fault: its text, its end, and the mark.
void put_fault(const app::CallOutput& output, const std::string& text, const Place& place) {
  const FaultEnd end{static_cast<std::uint32_t>(text.size()), place.line, place.column};
  put(output, text);
  output({reinterpret_cast<const char*>(&end), sizeof end});
  put(output, {kFault});
}

/// Does the work of the child.
void answer(const std::function<void(const app::CallOutput&)>& read,
            const app::CallOutput& output) {
  try {
    read(output);
    put(output, {kRead});
  } catch (const InputError& error) {
    put_fault(output, error.faults().front().message, error.faults().front().place);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    put_fault(output, fmt::format("cannot be read: {}", error.what()), {});
  }
}

std::string sentence(const app::CallResult& result, const app::CallLimits& limits,
                     const std::string& reader) {
  using End = app::CallResult::End;
  if (result.end == End::too_slow)
    return fmt::format("takes more than {} s to be read", limits.cpu_seconds);
  if (result.end == End::out_of_memory)
    return fmt::format("needs more than {} GiB of memory to be read",
                       app::gigabytes(static_cast<double>(limits.memory) / kGibibyte));
  return fmt::format("the file ends {} ({}): it is damaged, or made to do so", reader,
                     result.cause);
}

}  // namespace

std::string read_isolated(const std::filesystem::path& file, const std::string& reader,
                          const std::function<void(const app::CallOutput&)>& read,
                          const app::CallLimits& limits) {
  app::CallResult result =
      app::forked_call([&](const app::CallOutput& output) { answer(read, output); }, limits);
  if (result.end != app::CallResult::End::returned)
    throw InputError(file, sentence(result, limits, reader));
  std::string& bytes = result.bytes;
  const char mark = bytes.back();
  bytes.pop_back();
  if (mark == kRead) return std::move(bytes);
  FaultEnd end;
  bytes.copy(reinterpret_cast<char*>(&end), sizeof end, bytes.size() - sizeof end);
  throw InputError({Fault{{file, end.line, end.column},
                          "",
                          bytes.substr(bytes.size() - sizeof end - end.length, end.length)}});
}

std::string read_hdf5_isolated(const std::filesystem::path& file,
                               const std::function<void(const app::CallOutput&)>& read) {
  constexpr int kSeconds = 10;
  constexpr double kBytesPerSecond = 1e6;  // Compressed ones of a slow disk.
  return read_isolated(file, "the reader of HDF5", read,
                       limits_by_size(file, kSeconds, kBytesPerSecond));
}

app::CallLimits limits_by_size(const std::filesystem::path& file, int seconds,
                               double bytes_per_second) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  const double size = error ? 0 : static_cast<double>(bytes);
  const double memory = 4 * kGibibyte + 64 * size;
  const int most = seconds + static_cast<int>(std::min(size / bytes_per_second, 3600.0));
  // The process waits for a slow disk, and on a loaded machine.
  return {.memory =
              static_cast<std::size_t>(std::min(memory, app::available_memory().value_or(memory))),
          .cpu_seconds = most,
          .wall_seconds = 60.0 + 10 * most};
}

}  // namespace scene
