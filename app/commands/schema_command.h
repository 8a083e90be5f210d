#pragma once

namespace app {

/// Prints the scene format for editors as a JSON Schema.
/// @param markdown   True prints the tables of keys of scenes/KEYS.md instead.
/// @return the exit code
int schema(bool markdown);

}  // namespace app
