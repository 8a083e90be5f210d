#include <fmt/format.h>

#include <exception>
#include <new>

#include "app/cli.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/faults.h"
#include "engine/simulation.h"

namespace {

int run_command(int argc, char** argv) {
  const int code = app::command_line(argc, argv);
  app::flush_output();
  return code;
}

void say_faults(const app::InputError& error) {
  const std::size_t count = error.faults().size();
  app::say(error.what());
  app::say(fmt::format("{} problem{}, nothing was run.", count, count == 1 ? "" : "s"));
}

}  // namespace

int main(int argc, char** argv) {
  app::open_standard_streams();
  try {
    return run_command(argc, argv);
  } catch (const app::InputError& error) {
    say_faults(error);
    return app::kWrongInput;
  } catch (const engine::SimulationError& error) {
    app::say(fmt::format("error: {}", error.what()));
    return app::kCannotGoOn;
  } catch (const std::bad_alloc&) {
    app::say("error: the memory is used up; give meshes, pictures or logs of a smaller size");
    return app::kWrongInput;
  } catch (const std::exception& error) {
    app::say(fmt::format("error: {}", error.what()));
    return app::kWrongInput;
  }
}
