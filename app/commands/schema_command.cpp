#include "app/commands/schema_command.h"

#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/scene/schema.h"

namespace app {

int schema(bool markdown) {
  print(markdown ? scene::key_tables() : scene::json_schema());
  return kDone;
}

}  // namespace app
