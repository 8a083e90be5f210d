#include "tests/stress/run_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace stress {
namespace {

double plain_number(const std::string& text) {
  std::size_t used = 0;
  double value = 0;
  try {
    value = std::stod(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used == 0 || used != text.size())
    throw std::invalid_argument(fmt::format("'{}' is no number", text));
  return value;
}

const Dimension& dimension_named(const std::string& name) {
  for (const Dimension& dimension : dimensions())
    if (dimension.name == name) return dimension;
  throw std::invalid_argument(fmt::format("'{}' is no parameter of a run", name));
}

}  // namespace

const std::vector<Dimension>& dimensions() {
  static const std::vector<Dimension> all = {
      {Key::shape, "shape", {"cube", "ball", "shell", "plate", "needle", "tub", "tank", "teapot"}},
      {Key::density,
       "density",
       {"0.5", "1e-6", "0.001", "0.01", "0.1", "0.99", "1", "1.01", "2", "8", "20"}},
      {Key::size, "size", {"1", "0.001", "0.01", "0.1", "10", "100", "300"}},
      {Key::speed, "speed", {"10", "0", "1", "30", "100", "300"}},
      {Key::entry, "entry", {"down", "slant", "skim"}},
      {Key::spin, "spin", {"0", "1", "10", "100", "300"}},
      {Key::pose, "pose", {"tilted", "flat"}},
      {Key::start, "start", {"above", "half", "deep"}},
      {Key::step, "step", {"1/60", "1/15", "1/30", "1/120", "1/240", "1/1000"}},
      {Key::water,
       "water",
       {"flat", "current", "swell", "steep", "breaking", "short", "jonswap", "bumps", "cliff"}},
      {Key::coefs, "coefs", {"default", "none", "thesis", "lift", "x100", "x100lift"}},
      {Key::added, "added", {"deep", "waves", "none", "0.5", "1", "10", "100", "1000"}},
      {Key::with,
       "with",
       {"free", "locked", "pinned", "hinged", "slider", "chain", "fixed", "floor", "terrain",
        "wall", "stack", "overload", "rope", "leash", "spring", "moored", "driven"}},
      {Key::steps, "steps", {"200"}}};
  return all;
}

RunName::RunName() {
  for (std::size_t i = 0; i < kKeys; ++i) values_[i] = dimensions()[i].values.front();
}

RunName RunName::with(Key key, const std::string& value) const {
  RunName other = *this;
  other.values_[static_cast<std::size_t>(key)] = value;
  return other;
}

double RunName::number(Key key) const {
  const std::string& text = (*this)[key];
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return plain_number(text);
  return plain_number(text.substr(0, slash)) / plain_number(text.substr(slash + 1));
}

std::string RunName::text() const {
  std::vector<std::string> parts;
  for (const Dimension& dimension : dimensions())
    parts.push_back(dimension.name + "=" + (*this)[dimension.key]);
  return fmt::format("{}", fmt::join(parts, " "));
}

RunName parse_run(const std::string& text) {
  RunName run;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos)
      throw std::invalid_argument(fmt::format("'{}' is not of the form key=value", word));
    run = run.with(dimension_named(word.substr(0, equals)).key, word.substr(equals + 1));
  }
  return run;
}

}  // namespace stress
