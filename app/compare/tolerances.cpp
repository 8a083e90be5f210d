#include "app/compare/tolerances.h"

#include <fmt/format.h>

#include <cstdlib>

#include "app/compare/quantities.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

/// The part of a tolerance that a word of the command line names; `peak` without one.
struct Limit {
  std::string quantity;
  double Tolerance::*part = &Tolerance::peak;
};

Limit limit_of(const std::string& words) {
  const std::pair<const char*, double Tolerance::*> parts[] = {
      {".peak", &Tolerance::peak}, {".rms", &Tolerance::rms}, {".relative", &Tolerance::relative}};
  for (const auto& [suffix, part] : parts)
    if (words.ends_with(suffix))
      return {words.substr(0, words.size() - std::string(suffix).size()), part};
  return {words};
}

}  // namespace

double Tolerance::peak_limit(double size) const {
  if (peak == kNone && relative == kNone) return kNone;
  return (peak == kNone ? 0 : peak) + (relative == kNone ? 0 : relative * size);
}

Tolerance Tolerances::of(const std::string& name, const std::string& quantity) const {
  const std::size_t dot = quantity.find('.');
  const std::string table = dot == std::string::npos ? quantity : quantity.substr(0, dot);
  if (all.empty() && bodies.empty())
    return {.peak = kDefault, .relative = dot == std::string::npos ? Tolerance::kNone : kDefault};
  const auto own = bodies.find(name);
  const Quantities none;
  for (const Quantities* level : {own == bodies.end() ? &none : &own->second, &all})
    for (const std::string& key : {quantity, table})
      if (const auto found = level->find(key); found != level->end()) return found->second;
  return {};
}

Tolerances parse_tolerances(const std::vector<std::string>& arguments) {
  Tolerances tolerances;
  for (const std::string& argument : arguments) {
    const std::size_t equals = argument.find('=');
    const std::string value = equals == std::string::npos ? "" : argument.substr(equals + 1);
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    if (value.empty() || *end != '\0')
      throw scene::InputError("--tol",
                              fmt::format("found \"{}\", expected QUANTITY=NUMBER", argument));
    const Limit limit = limit_of(argument.substr(0, equals));
    if (const std::string fault = fault_of_quantity(limit.quantity); !fault.empty())
      throw scene::InputError("--tol", fault);
    if (!(number >= 0))
      throw scene::InputError("--tol", fmt::format("{}: expected a number not below 0", argument));
    tolerances.all[limit.quantity].*limit.part = number;
  }
  return tolerances;
}

}  // namespace app
