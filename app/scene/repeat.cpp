#include "app/scene/repeat.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

namespace scene {
namespace {

using Kind = YamlNode::Kind;

/// Most copies of an entry, and most values of a scene with all its copies.
constexpr int kMostCopies = 100'000;
constexpr std::size_t kMostValues = 2'000'000;

/// Where a copy is.
struct Copy {
  int number = 0;
  std::array<int, 3> cell = {0, 0, 0};
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
};

std::vector<Copy> copies_of(const Repeat& repeat) {
  std::vector<Copy> copies;
  std::mt19937_64 random(static_cast<std::uint64_t>(repeat.seed));
  const auto uniform = [&] { return 2 * std::ldexp(static_cast<double>(random() >> 11), -53) - 1; };
  const std::array<int, 3> grid = repeat.grid.value_or(std::array{repeat.copies(), 1, 1});
  for (int iz = 0; iz < grid[2]; ++iz)
    for (int iy = 0; iy < grid[1]; ++iy)
      for (int ix = 0; ix < grid[0]; ++ix) {
        Copy copy{.number = static_cast<int>(copies.size()), .cell = {ix, iy, iz}};
        if (repeat.grid) copy.shift = repeat.spacing.cwiseProduct(Eigen::Vector3d(ix, iy, iz));
        for (int k = 0; k < 3; ++k) copy.shift[k] += repeat.jitter[k] * uniform();
        copies.push_back(copy);
      }
  return copies;
}

/// Sets the variables that tell a copy from others.
void set_copy(const Copy& copy, Variables& variables) {
  std::map<std::string, double>& numbers = variables.numbers;
  numbers["i"] = copy.number;
  numbers["ix"] = copy.cell[0];
  numbers["iy"] = copy.cell[1];
  numbers["iz"] = copy.cell[2];
  numbers["dx"] = copy.shift.x();
  numbers["dy"] = copy.shift.y();
  numbers["dz"] = copy.shift.z();
}

class Expansion {
 public:
  explicit Expansion(Reading& reading) : reading_(reading) {}

  void expand(const Variables& variables, YamlNode& node, const std::string& path) {
    if (++values_ > kMostValues || text_ > kMostText) return;
    if (node.is(Kind::scalar)) return substitute_in(variables, node, path);
    for (YamlEntry& entry : node.entries)
      expand(variables, entry.value, path.empty() ? entry.key : path + "." + entry.key);
    if (!node.is(Kind::list)) return;
    std::vector<YamlNode> items;
    for (std::size_t i = 0; i < node.items.size(); ++i)
      add_copies(variables, node.items[i], path, fmt::format("{}[{}]", path, i), items);
    node.items = std::move(items);
  }

  /// Adds a fault if there were more values or text than a scene may have.
  void finish() {
    if (values_ > kMostValues)
      reading_.fault("", fmt::format("with all copies there are more than {} values", kMostValues));
    else if (text_ > kMostText)
      reading_.fault(
          "", fmt::format("with all copies there are more than {} MiB of text", kMostText >> 20));
  }

 private:
  void substitute_in(const Variables& variables, YamlNode& scalar, const std::string& path) {
    try {
      substitute(variables, scalar, kMostText - text_);
      text_ += scalar.text.size();
    } catch (const VariableFault& fault) {
      reading_.faults.add({reading_.place(fault.mark), path, fault.message});
    }
  }

  /// Adds an entry of a list, or its copies.
  void add_copies(const Variables& variables, YamlNode& item, const std::string& list,
                  const std::string& path, std::vector<YamlNode>& items) {
    const auto entry = std::ranges::find(item.entries, "repeat", &YamlEntry::key);
    if (entry == item.entries.end()) {
      expand(variables, item, path);
      items.push_back(std::move(item));
      return;
    }
    YamlNode block = std::move(entry->value);
    item.entries.erase(entry);
    expand(variables, block, path + ".repeat");
    const Value value{block, path + ".repeat", reading_};
    if (!block.is(Kind::map)) {
      value.refuse("a map with count or grid");
      return;
    }
    Repeat repeat;
    MapReader reader(&block, path + ".repeat", reading_);
    read(reader, repeat);
    reader.report_other_keys();
    Variables own = variables;
    for (const Copy& copy : copies_of(repeat)) {
      if (values_ > kMostValues || text_ > kMostText) return;
      YamlNode& made = items.emplace_back(item);
      number_name(made, copy);
      set_copy(copy, own);
      expand(own, made, path);
      if (list == "bodies") shift(made, copy);
    }
  }

  static void number_name(YamlNode& item, const Copy& copy) {
    for (YamlEntry& entry : item.entries)
      if (entry.key == "name" && entry.value.is(Kind::scalar) && !has_variables(entry.value.text))
        entry.value.text += fmt::format("_{}", copy.number);
  }

  /// Adds the shift to the position of a body. A value that is no position stays as it is: its
  /// reader refuses it.
  static void shift(YamlNode& body, const Copy& copy) {
    if (copy.shift.isZero(0)) return;
    auto entry = std::ranges::find(body.entries, "position", &YamlEntry::key);
    if (entry == body.entries.end()) {
      YamlNode zero{.kind = Kind::scalar, .mark = body.mark, .text = "0"};
      body.entries.push_back({"position", body.mark, {.kind = Kind::list, .mark = body.mark}});
      entry = std::prev(body.entries.end());
      entry->value.items.assign(3, zero);
    }
    if (entry->value.items.size() != 3) return;
    for (int k = 0; k < 3; ++k) {
      YamlNode& number = entry->value.items[static_cast<std::size_t>(k)];
      if (const auto value = plain_number(number)) number.text = exact_text(*value + copy.shift[k]);
    }
  }

  Reading& reading_;
  std::size_t values_ = 0;
  std::size_t text_ = 0;  ///< Length of their text [bytes].
};

}  // namespace

void read(MapReader& map, Repeat& repeat) {
  map.exactly_one_of({"count", "grid"});
  map.optional("count", repeat.count, between(1, kMostCopies));
  map.optional("grid", repeat.grid, between(1, kMostCopies));
  map.optional("spacing", repeat.spacing, number("m"));
  map.optional("jitter", repeat.jitter, not_negative("m"));
  map.optional("seed", repeat.seed, not_negative());
  map.note_condition("grid", "", {"spacing"}, {});
  map.note_condition("spacing", "", {"grid"}, {});
  if (map.has("grid") != map.has("spacing"))
    map.fault("",
              "grid and spacing need each other: the numbers of copies along x, y and z, and "
              "the distances between them [m]");
  if (repeat.grid) {
    double copies = 1;
    for (const int along : *repeat.grid) copies *= along;
    if (copies <= kMostCopies) return;
    map.fault("grid", fmt::format("has {} copies, expected at most {}", copies, kMostCopies));
    repeat.grid.reset();
  }
}

void expand(const Variables& variables, YamlNode& root, Reading& reading) {
  Expansion expansion(reading);
  expansion.expand(variables, root, "");
  expansion.finish();
}

}  // namespace scene
