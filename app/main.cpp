#include <fmt/format.h>

#include <exception>

#include "app/cli.h"
#include "app/commands.h"
#include "app/faults.h"
#include "app/render/image.h"
#include "engine/simulation.h"

int main(int argc, char** argv) {
  try {
    return app::command_line(argc, argv);
  } catch (const app::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    const std::size_t count = error.faults().size();
    fmt::print(stderr, "{} problem{}, nothing was run.\n", count, count == 1 ? "" : "s");
    return app::kWrongInput;
  } catch (const engine::SimulationError& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return app::kCannotGoOn;
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return app::kWrongInput;
  }
}
