#include "app/compare/comparison_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/base/quoting.h"

namespace app {
namespace {

using nlohmann::ordered_json;

std::string tolerance_text(const Difference& d) {
  return d.judged() ? fmt::format("{:g}", d.tolerance) : "-";
}

/// Colours a text green, red or grey.
std::string colored(const std::string& text, const Difference& d, bool color) {
  if (!color) return text;
  return fmt::format("\033[{}m{}\033[0m", !d.judged() ? 90 : d.within() ? 32 : 31, text);
}

struct JunitCases {
  std::string text;
  int count = 0;
  int failures = 0;

  void add(const std::string& body, const std::string& name, const std::string& failure) {
    ++count;
    failures += !failure.empty();
    const std::string head =
        fmt::format("  <testcase classname=\"{}\" name=\"{}\"", xml_text(body), xml_text(name));
    text += failure.empty() ? head + "/>\n"
                            : fmt::format("{}>\n    <failure message=\"{}\"/>\n  </testcase>\n",
                                          head, xml_text(failure));
  }
};

}  // namespace

std::string coverage(const BodyComparison& body, const ComparedFiles& files) {
  if (body.in == BodyComparison::In::only_a) return "only in " + files.a;
  if (body.in == BodyComparison::In::only_b) return "only in " + files.b;
  if (body.only_a + body.only_b > 0)
    return fmt::format("{} times compared, {} rows only in {}, {} only in {}", body.times.size(),
                       body.only_a, files.a, body.only_b, files.b);
  return "";
}

std::string verdict(const Difference& d) {
  if (!d.judged()) return "not judged";
  if (d.within()) return "ok";
  return fmt::format("exceeds it from {:g} s", d.first_beyond);
}

std::string table_of(const Comparison& comparison, const ComparedFiles& files, bool color) {
  std::string table = fmt::format("{:<16} {:<17} {:>12} {:<6} {:>8} {:>11}\n", "body", "quantity",
                                  "largest", "unit", "at [s]", "tolerance");
  for (const BodyComparison& body : comparison.bodies) {
    if (const std::string note = coverage(body, files); !note.empty())
      table += fmt::format("{:<16} {}\n", body.name, note);
    if (body.interpolated > 0)
      table += fmt::format("{:<16} interpolated at {} of {} times\n", body.name, body.interpolated,
                           body.times.size());
    if (body.in != BodyComparison::In::both) continue;
    for (std::size_t k = 0; k < kComparedQuantities.size(); ++k) {
      const Difference& d = body.differences[k];
      const std::string row = fmt::format(
          "{:<16} {:<17} {:>12.4g} {:<6} {:>8.3f} {:>11}  ", body.name, kComparedQuantities[k].name,
          d.largest, kComparedQuantities[k].unit, d.when_largest, tolerance_text(d));
      table += row + colored(verdict(d), d, color) + "\n";
    }
  }
  return table + (comparison.same() ? "the same within tolerance\n" : "different\n");
}

std::string json_of(const Comparison& comparison, const ComparedFiles& files) {
  ordered_json all = {{"a", files.a}, {"b", files.b}, {"same", comparison.same()}};
  ordered_json& bodies = all["bodies"] = ordered_json::object();
  for (const BodyComparison& body : comparison.bodies) {
    ordered_json& one = bodies[body.name] = {{"same", body.same()}};
    if (body.in != BodyComparison::In::both) {
      one["only_in"] = body.in == BodyComparison::In::only_a ? files.a : files.b;
      continue;
    }
    one["times"] = body.times.size();
    one["interpolated"] = body.interpolated;
    one["rows_beyond"] = {{"a", body.only_a}, {"b", body.only_b}};
    for (std::size_t k = 0; k < kComparedQuantities.size(); ++k) {
      const Difference& d = body.differences[k];
      ordered_json& quantity = one[kComparedQuantities[k].name];
      quantity = {{"largest", d.largest}, {"at", d.when_largest}};
      quantity["tolerance"] = d.judged() ? ordered_json(d.tolerance) : ordered_json(nullptr);
      quantity["first_beyond"] = d.within() ? ordered_json(nullptr) : ordered_json(d.first_beyond);
    }
  }
  return all.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string junit_of(const Comparison& comparison, const ComparedFiles& files) {
  JunitCases cases;
  for (const BodyComparison& body : comparison.bodies) {
    cases.add(body.name, "times", coverage(body, files));
    if (body.in != BodyComparison::In::both) continue;
    for (std::size_t k = 0; k < kComparedQuantities.size(); ++k) {
      const Difference& d = body.differences[k];
      if (!d.judged()) continue;
      const std::string failure =
          d.within()
              ? ""
              : fmt::format("differs by up to {:g} {} at {:g} s, tolerance {:g}, {}", d.largest,
                            kComparedQuantities[k].unit, d.when_largest, d.tolerance, verdict(d));
      cases.add(body.name, kComparedQuantities[k].name, failure);
    }
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"{} and {}\" tests=\"{}\" failures=\"{}\">\n{}</testsuite>\n",
      xml_text(files.a), xml_text(files.b), cases.count, cases.failures, cases.text);
}

}  // namespace app
