#include "app/compare/comparison_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/base/console.h"
#include "app/base/quoting.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

/// Colours a text green, red or grey.
std::string colored(const std::string& text, const Difference& d, bool color) {
  if (!color) return text;
  return fmt::format("\033[{}m{}\033[0m", !d.judged() ? 90 : d.within() ? 32 : 31, text);
}

/// The widths of the columns of names.
struct Widths {
  std::size_t name = 12;
  std::size_t quantity = 16;
};

Widths widths_of(const Comparison& comparison) {
  Widths widths;
  const auto widen = [&](const BodyComparison& body, bool of_table) {
    widths.name = std::max(widths.name, body.name.size());
    for (const Difference& d : body.differences)
      if (!of_table || !d.within()) widths.quantity = std::max(widths.quantity, d.quantity.size());
  };
  for (const BodyComparison& body : comparison.bodies) widen(body, false);
  for (const TableComparison& table : comparison.tables)
    for (const BodyComparison& name : table.names) widen(name, true);
  return widths;
}

std::string row_of(const std::string& name, const Difference& d, const Widths& widths, bool color) {
  const std::string row = fmt::format("{:<{}}  {:<{}} {:>11.4g} {:>11.4g} {:<6} {:>8.3f} {:>11}  ",
                                      name, widths.name, d.quantity, widths.quantity, d.largest,
                                      d.rms, d.unit, d.when_largest, limits_text(d));
  return shown(row) + colored(verdict(d), d, color) + "\n";
}

/// Returns what to say of a name besides its quantities.
std::string notes_of(const BodyComparison& body, const ComparedFiles& files, const Widths& widths) {
  std::string text;
  if (const std::string note = coverage(body, files); !note.empty())
    text += fmt::format("{:<{}}  {}\n", body.name, widths.name, note);
  if (body.interpolated > 0)
    text += fmt::format("{:<{}}  interpolated at {} of {} times\n", body.name, widths.name,
                        body.interpolated, body.times.size());
  return shown(text, "\n");
}

/// Counts the quantities of a table: judged, and beyond their tolerance.
struct Count {
  std::size_t judged = 0;
  std::size_t beyond = 0;
};

Count count_of(const TableComparison& table) {
  Count count;
  for (const BodyComparison& name : table.names)
    for (const Difference& d : name.differences) {
      count.judged += d.judged();
      count.beyond += !d.within();
    }
  return count;
}

std::string lines_of(const TableComparison& table, const ComparedFiles& files, const Widths& widths,
                     bool color) {
  if (table.in != In::both)
    return shown(fmt::format("{}: {}{}", table.name, only_in(table.in, files),
                             table.judged ? "" : ", not judged")) +
           "\n";
  std::string text;
  const Count count = count_of(table);
  text += fmt::format("{}: {} of {}, {} judged, {} beyond tolerance\n", table.name,
                      counted(table.names.empty() ? 0 : table.names.front().differences.size(),
                              "quantity", "quantities"),
                      counted(table.names.size(), "name", "names"), count.judged, count.beyond);
  for (const BodyComparison& name : table.names) {
    if (name.judged) text += notes_of(name, files, widths);
    for (const Difference& d : name.differences)
      if (!d.within()) text += row_of(name.name, d, widths, color);
  }
  return text;
}

Json json_of(const Difference& d) {
  Json json = {{"largest", finite_or_null(d.largest)},
               {"at", d.when_largest},
               {"tolerance", finite_or_null(d.peak_limit)},
               {"first_beyond", finite_or_null(d.first_beyond)},
               {"rms", finite_or_null(d.rms)}};
  if (d.rms_limit != Tolerance::kNone) json["rms_tolerance"] = d.rms_limit;
  return json;
}

Json json_of(const BodyComparison& body, const ComparedFiles& files) {
  Json one = {{"same", body.same()}};
  if (body.in != In::both) {
    one["only_in"] = body.in == In::only_a ? files.a : files.b;
    return one;
  }
  one["times"] = body.times.size();
  one["interpolated"] = body.interpolated;
  one["rows_beyond"] = {{"a", body.only_a}, {"b", body.only_b}};
  for (const Difference& d : body.differences) one[d.quantity] = json_of(d);
  return one;
}

Json json_of(const TableComparison& table, const ComparedFiles& files) {
  Json one = {{"same", table.same()}};
  if (table.in != In::both) one["only_in"] = table.in == In::only_a ? files.a : files.b;
  Json& names = one["names"] = Json::object();
  for (const BodyComparison& name : table.names) names[name.name] = json_of(name, files);
  return one;
}

}  // namespace

Json finite_or_null(double number) { return std::isfinite(number) ? Json(number) : Json(nullptr); }

std::string only_in(In in, const ComparedFiles& files) {
  if (in == In::both) return "";
  return "only in " + (in == In::only_a ? files.a : files.b);
}

std::string coverage(const BodyComparison& body, const ComparedFiles& files) {
  if (body.in != In::both) return only_in(body.in, files);
  if (body.only_a + body.only_b > 0)
    return fmt::format("{} times compared, {} rows only in {}, {} only in {}", body.times.size(),
                       body.only_a, files.a, body.only_b, files.b);
  return "";
}

std::string verdict(const Difference& d) {
  if (!d.judged()) return "not judged";
  if (d.within()) return "ok";
  if (d.first_beyond == Difference::kNever) return "rms exceeds it";
  return fmt::format("exceeds it from {:g} s", d.first_beyond);
}

std::string limits_text(const Difference& d) {
  const std::string rms =
      d.rms_limit == Tolerance::kNone ? "" : fmt::format("rms {:.4g}", d.rms_limit);
  if (d.peak_limit == Tolerance::kNone) return rms.empty() ? "-" : rms;
  return fmt::format("{:.4g}{}{}", d.peak_limit, rms.empty() ? "" : ", ", rms);
}

JudgedQuantities judged_quantities(const Comparison& comparison) {
  std::vector<std::pair<std::string, bool>> all;
  const auto add = [&all](const std::string& name, bool judged) {
    const auto known = std::ranges::find(all, name, &std::pair<std::string, bool>::first);
    if (known == all.end())
      all.emplace_back(name, judged);
    else
      known->second = known->second || judged;
  };
  for (const BodyComparison& body : comparison.bodies)
    for (const Difference& d : body.differences) add(d.quantity, d.judged());
  for (const TableComparison& table : comparison.tables) {
    const Count count = count_of(table);
    std::size_t quantities = 0;
    for (const BodyComparison& name : table.names) quantities += name.differences.size();
    if (table.in == In::both && quantities == 0) continue;
    const bool in_parts = table.in == In::both && count.judged > 0 && count.judged < quantities;
    if (!in_parts) add(table.name, table.judged && (count.judged > 0 || table.in != In::both));
    for (const BodyComparison& name : table.names)
      for (const Difference& d : name.differences)
        if (in_parts) add(d.quantity, d.judged());
  }
  JudgedQuantities quantities;
  for (const auto& [name, judged] : all)
    (judged ? quantities.judged : quantities.not_judged).push_back(name);
  return quantities;
}

std::string verdict_text(bool same) { return same ? "the same within tolerance" : "different"; }

std::string verdict_text(const Comparison& comparison) {
  const JudgedQuantities quantities = judged_quantities(comparison);
  const std::string verdict = verdict_text(comparison.same());
  if (quantities.not_judged.empty()) return verdict;
  if (quantities.judged.empty() && comparison.same())
    return "nothing was judged: none of the tolerances is of what both runs have";
  return fmt::format("{} by {}; not judged: {}", verdict,
                     quantities.judged.empty()
                         ? "what only one run has"
                         : fmt::format("{}", fmt::join(quantities.judged, ", ")),
                     fmt::join(quantities.not_judged, ", "));
}

std::string names_text(const ComparedFiles& files) {
  return fmt::format("A: {}\nB: {}\n", files.a, files.b);
}

std::string table_of(const Comparison& comparison, const ComparedFiles& files, bool color) {
  const Widths widths = widths_of(comparison);
  std::string table =
      fmt::format("{:<{}}  {:<{}} {:>11} {:>11} {:<6} {:>8} {:>11}\n", "body", widths.name,
                  "quantity", widths.quantity, "largest", "rms", "unit", "at [s]", "tolerance");
  for (const BodyComparison& body : comparison.bodies) {
    table += notes_of(body, files, widths);
    for (const Difference& d : body.differences) table += row_of(body.name, d, widths, color);
  }
  for (const TableComparison& one : comparison.tables) table += lines_of(one, files, widths, color);
  return table + verdict_text(comparison) + "\n";
}

Json json_of(const Comparison& comparison, const ComparedFiles& files,
             const std::optional<Provenance>& provenance) {
  const JudgedQuantities quantities = judged_quantities(comparison);
  Json all = {{"a", files.a},
              {"b", files.b},
              {"same", comparison.same()},
              {"judged", quantities.judged},
              {"not_judged", quantities.not_judged}};
  if (provenance) all["differs"] = json_of(*provenance);
  Json& bodies = all["bodies"] = Json::object();
  for (const BodyComparison& body : comparison.bodies) bodies[body.name] = json_of(body, files);
  Json& tables = all["tables"] = Json::object();
  for (const TableComparison& table : comparison.tables) tables[table.name] = json_of(table, files);
  return all;
}

}  // namespace app
