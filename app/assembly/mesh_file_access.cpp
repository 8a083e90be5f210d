#include "app/assembly/mesh_file_access.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <cstdio>
#include <memory>
#include <system_error>

namespace assembly {
namespace {

namespace fs = std::filesystem;

/// Opens a regular file for reading. @return null if it is none
std::FILE* open_regular(const char* path) {
  // Without O_NONBLOCK the open of a pipe waits until somebody writes to it.
  const int descriptor = ::open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
  if (descriptor < 0) return nullptr;
  struct stat status = {};
  const bool regular = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
  std::FILE* const stream = regular ? ::fdopen(descriptor, "rb") : nullptr;
  if (stream == nullptr) ::close(descriptor);
  return stream;
}

/// A regular file that assimp reads.
class ReadStream : public Assimp::IOStream {
 public:
  explicit ReadStream(std::FILE* stream) : stream_(stream, std::fclose) {}

  size_t Read(void* buffer, size_t size, size_t count) override {
    return size == 0 ? 0 : std::fread(buffer, size, count, stream_.get());
  }
  size_t Write(const void*, size_t, size_t) override { return 0; }
  aiReturn Seek(size_t offset, aiOrigin origin) override {
    const int from = origin == aiOrigin_SET   ? SEEK_SET
                     : origin == aiOrigin_CUR ? SEEK_CUR
                                              : SEEK_END;
    const bool done = ::fseeko(stream_.get(), static_cast<off_t>(offset), from) == 0;
    return done ? aiReturn_SUCCESS : aiReturn_FAILURE;
  }
  size_t Tell() const override {
    return static_cast<size_t>(std::max<off_t>(0, ::ftello(stream_.get())));
  }
  size_t FileSize() const override {
    struct stat status = {};
    const bool known = ::fstat(::fileno(stream_.get()), &status) == 0;
    return known ? static_cast<size_t>(status.st_size) : 0;
  }
  void Flush() override {}

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream_;
};

bool lies_in(const fs::path& file, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
         folder.end();
}

}  // namespace

MeshFileAccess::MeshFileAccess(const fs::path& file)
    : file_(fs::canonical(file)), folder_(fs::canonical(fs::absolute(file).parent_path())) {}

fs::path MeshFileAccess::allowed(const char* path) const {
  std::error_code error;
  const fs::path file = fs::canonical(path, error);
  if (error || !fs::is_regular_file(file, error)) return {};
  return file == file_ || lies_in(file, folder_) ? file : fs::path();
}

bool MeshFileAccess::Exists(const char* path) const { return !allowed(path).empty(); }

Assimp::IOStream* MeshFileAccess::Open(const char* path, const char* mode) {
  const fs::path file = allowed(path);
  if (mode == nullptr || mode[0] != 'r' || file.empty()) return nullptr;
  std::FILE* const stream = open_regular(path);
  if (stream == nullptr) return nullptr;
  opened_.insert(file);
  return new ReadStream(stream);
}

std::uintmax_t MeshFileAccess::bytes_opened() const {
  std::uintmax_t bytes = 0;
  for (const fs::path& file : opened_) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);
    if (!error) bytes += size;
  }
  return bytes;
}

void MeshFileAccess::Close(Assimp::IOStream* stream) { delete stream; }

}  // namespace assembly
