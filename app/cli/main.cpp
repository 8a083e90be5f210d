#include <fmt/format.h>

#include <csignal>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/cli/cli.h"
#include "app/scene/diagnostics.h"
#include "engine/simulation.h"

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

int run_command(int argc, char** argv) {
  const int code = app::command_line(argc, argv);
  app::flush_output();
  return code;
}

/// @param command   Of the command line.
void say_faults(const scene::InputError& error, const std::string& command) {
  const std::size_t count = error.faults().size();
  const bool runs = command == "run" || command == "sweep" || command == "view";
  app::say(error.what());
  app::say(fmt::format("{} problem{}{}", count, count == 1 ? "" : "s",
                       runs ? ", nothing was run." : "."));
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  app::open_standard_streams();
  // A write beyond the limit of a file's size is then an error like any other.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return run_command(argc, argv);
  } catch (const scene::InputError& error) {
    say_faults(error, argc > 1 ? argv[1] : "");
    return app::kWrongInput;
  } catch (const engine::SimulationError& error) {
    app::say(fmt::format("error: {}", error.what()));
    return app::kCannotGoOn;
  } catch (const std::bad_alloc&) {
    app::say("error: out of memory; use smaller meshes, pictures or logs");
    return app::kWrongInput;
  } catch (const std::logic_error& error) {
    app::say(fmt::format("error: {}", error.what()));
    app::say(
        "This is a fault of plimsoll. Please report it with the scene, its meshes and the "
        "command.");
    return app::kOwnFault;
  } catch (const std::exception& error) {
    app::say(fmt::format("error: {}", error.what()));
    return app::kWrongInput;
  }
}
