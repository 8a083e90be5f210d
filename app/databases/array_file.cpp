#include "app/databases/array_file.h"

#include <fmt/format.h>

#include "app/scene/diagnostics.h"

namespace databases {

Array ArrayFile::require(const std::string& name) const {
  std::optional<Array> found = find(name);
  if (!found) refuse(fmt::format("has no array {}", name));
  return *std::move(found);
}

std::optional<double> ArrayFile::number(const std::string& name) const {
  const std::optional<Array> found = find(name);
  return found && !found->numbers.empty() ? std::optional(found->numbers.front()) : std::nullopt;
}

std::optional<std::string> ArrayFile::text(const std::string& name) const {
  const std::optional<Array> found = find(name);
  return found && !found->texts.empty() ? std::optional(found->texts.front()) : std::nullopt;
}

void ArrayFile::refuse(const std::string& message) const {
  throw scene::InputError(path_, message);
}

}  // namespace databases
