#include <fmt/format.h>

#include "app/commands/commands.h"
#include "app/scene/schema.h"

namespace app {

int schema(bool markdown) {
  fmt::print("{}", markdown ? key_tables() : scene_schema());
  return kDone;
}

}  // namespace app
