#include "app/cli/guarded.h"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <stdexcept>

#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/scene/diagnostics.h"
#include "engine/simulation.h"

namespace app {
namespace {

void say_faults(const scene::InputError& error, const std::string& command) {
  const std::size_t count = error.faults().size();
  const bool runs = command == "run" || command == "sweep" || command == "view";
  say(error.what());
  say(fmt::format("{} problem{}{}", count, count == 1 ? "" : "s",
                  runs ? ", nothing was run." : "."));
}

}  // namespace

int guarded(const std::string& name, const std::function<int()>& command) {
  try {
    return command();
  } catch (const scene::InputError& error) {
    say_faults(error, name);
    return kWrongInput;
  } catch (const engine::SimulationError& error) {
    say(fmt::format("error: {}", error.what()));
    return kCannotGoOn;
  } catch (const std::bad_alloc&) {
    say("error: out of memory; use smaller meshes, pictures or logs");
    return kWrongInput;
  } catch (const std::logic_error& error) {
    say(fmt::format("error: {}", error.what()));
    say("This is a fault of plimsoll. Please report it with the scene, its meshes and the "
        "command.");
    return kOwnFault;
  } catch (const std::exception& error) {
    say(fmt::format("error: {}", error.what()));
    return kWrongInput;
  }
}

}  // namespace app
