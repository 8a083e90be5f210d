#include "app/scene/override.h"

#include <fmt/format.h>

namespace scene {

Override parse_override(const std::string& argument) {
  const std::size_t bracket = argument.find(']');
  const std::size_t equals = argument.find('=');
  // A name in brackets may itself hold an equals sign.
  const bool in_brackets = equals != std::string::npos && argument.find('[') < equals &&
                           bracket != std::string::npos && equals < bracket;
  const std::size_t end = in_brackets ? argument.find('=', bracket) : equals;
  if (end == std::string::npos || end == 0)
    throw InputError(
        {Fault{{kOverridePlace},
               "",
               fmt::format("found {}, expected KEY.PATH=VALUE, as in bodies[0].density=700",
                           argument.empty() ? "nothing" : argument)}});
  return {argument.substr(0, end), argument.substr(end + 1)};
}

}  // namespace scene
