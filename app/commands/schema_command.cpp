#include "app/commands/schema_command.h"

#include <fmt/format.h>

#include "app/base/exit_code.h"
#include "app/scene/schema.h"

namespace app {

int schema(bool markdown) {
  fmt::print("{}", markdown ? scene::key_tables() : scene::json_schema());
  return kDone;
}

}  // namespace app
