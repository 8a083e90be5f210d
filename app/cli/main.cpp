#include <csignal>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "app/base/console.h"
#include "app/cli/cli.h"
#include "app/cli/guarded.h"

namespace {

/// Keeps some megabytes of freed memory in the process. Readers of meshes and of the store free as
/// much as the next one needs, and new pages from the kernel take a large part of a short run.
void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kMebibyte = 1 << 20;
  ::mallopt(M_MMAP_THRESHOLD, 32 * kMebibyte);  // The largest value that is accepted.
  ::mallopt(M_TRIM_THRESHOLD, 64 * kMebibyte);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  app::open_standard_streams();
  // A write beyond the limit of a file's size is then an error like any other.
  std::signal(SIGXFSZ, SIG_IGN);
  return app::guarded(argc > 1 ? argv[1] : "", [&] {
    const int code = app::command_line(argc, argv);
    app::flush_output();
    return code;
  });
}
