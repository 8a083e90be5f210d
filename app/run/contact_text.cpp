#include "app/run/contact_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <vector>

namespace app {
namespace {

/// Largest number of surfaces and pairs that are named.
constexpr std::size_t kMostSurfaces = 6;

std::string name_of(const engine::SimulationSpec& spec, engine::BodyId id) {
  return id == engine::kWorld ? "ground" : spec.bodies[id].name;
}

/// Appends `whose: friction …, restitution …` with the values there are.
void add_surface(std::vector<std::string>& texts, const std::string& whose,
                 std::optional<double> friction, std::optional<double> restitution) {
  std::vector<std::string> values;
  if (friction) values.push_back(fmt::format("friction {:g}", *friction));
  if (restitution) values.push_back(fmt::format("restitution {:g}", *restitution));
  if (!values.empty()) texts.push_back(fmt::format("{}: {}", whose, fmt::join(values, ", ")));
}

std::optional<double> unless(double value, double usual) {
  return value == usual ? std::nullopt : std::optional(value);
}

}  // namespace

std::string contact_text(const engine::SimulationSpec& spec) {
  const engine::BodySpec usual;
  std::vector<std::string> texts;
  for (const engine::BodySpec& body : spec.bodies)
    add_surface(texts, body.name, unless(body.friction, usual.friction),
                unless(body.restitution, usual.restitution));
  add_surface(texts, "ground", unless(spec.ground_friction, usual.friction),
              unless(spec.ground_restitution, usual.restitution));
  for (const engine::ContactSpec& contact : spec.contacts)
    add_surface(
        texts,
        fmt::format("{} and {}", name_of(spec, contact.first), name_of(spec, contact.second)),
        contact.friction, contact.restitution);
  if (texts.size() > kMostSurfaces) {
    const std::size_t more = texts.size() - kMostSurfaces;
    texts.resize(kMostSurfaces);
    texts.push_back(fmt::format("and {} more", more));
  }
  return fmt::format("{}", fmt::join(texts, "; "));
}

}  // namespace app
