#include "app/compare/comparison_data.h"

#include <algorithm>
#include <iterator>

#include "app/logs/motion_columns.h"
#include "app/pages/packed_rows.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;
using Columns = std::vector<std::vector<double>>;

constexpr std::size_t kLeastComparedRows = 16;  ///< Fewer rows do not show a motion.

Json differences_of(const BodyComparison& body) {
  Json all = Json::array();
  for (const Difference& d : body.differences)
    all.push_back({{"quantity", d.quantity},
                   {"unit", d.unit},
                   {"largest", finite_or_null(d.largest)},
                   {"at", d.when_largest},
                   {"rms", finite_or_null(d.rms)},
                   {"tolerance", finite_or_null(d.peak_limit)},
                   {"rms_tolerance", finite_or_null(d.rms_limit)},
                   {"limits", limits_text(d)},
                   {"first_beyond", finite_or_null(d.first_beyond)},
                   {"judged", d.judged()},
                   {"within", d.within()},
                   {"verdict", verdict(d)}});
  return all;
}

/// Returns of each table its verdict, and the names and quantities beyond their tolerance.
Json tables_of(const Comparison& comparison, const ComparedFiles& files) {
  Json all = Json::array();
  for (const TableComparison& table : comparison.tables) {
    Json& one = all.emplace_back(Json{{"name", table.name},
                                      {"same", table.same()},
                                      {"judged", table.judged},
                                      {"note", only_in(table.in, files)},
                                      {"names", table.names.size()},
                                      {"beyond", Json::array()}});
    for (const BodyComparison& name : table.names) {
      const Json differences = differences_of(name);
      Json beyond = Json::array();
      std::ranges::copy_if(differences, std::back_inserter(beyond),
                           [](const Json& d) { return !d["within"].get<bool>(); });
      if (!name.same())
        one["beyond"].push_back(
            {{"name", name.name}, {"note", coverage(name, files)}, {"differences", beyond}});
    }
  }
  return all;
}

}  // namespace

Json comparison_data(const ComparedPage& page, const ComparisonLimits& limits) {
  const auto& [comparison, files, provenance, a, b, replay] = page;
  const std::size_t columns = 2 * motion_columns().size() + kComparedQuantities.size();
  const std::size_t bodies = std::max<std::size_t>(comparison.bodies.size(), 1);
  const std::size_t most = std::max(kLeastComparedRows, limits.numbers / (columns * bodies));
  Json all = Json::array();
  for (const BodyComparison& body : comparison.bodies) {
    Json& one = all.emplace_back(Json{{"name", body.name}, {"same", body.same()}});
    one["note"] = coverage(body, files);
    one["interpolated"] = body.interpolated;
    one["times"] = body.times.size();
    Columns motion_a, motion_b;
    if (const auto track = a.tracks.find(body.name); track != a.tracks.end()) {
      motion_a = motion_of(track->second);
      one["a"] = packed_rows(track->second.times, motion_a, most);
    }
    if (const auto track = b.tracks.find(body.name); track != b.tracks.end()) {
      motion_b = motion_of(track->second);
      if (!motion_a.empty()) start_alike(motion_a, motion_b);
      one["b"] = packed_rows(track->second.times, motion_b, most);
    }
    if (body.in != In::both) continue;
    one["differences"] = differences_of(body);
    one["over"] = packed_rows(body.times, body.difference_over, most);
  }
  return {{"program", PLIMSOLL_VERSION},
          {"a", files.a},
          {"b", files.b},
          {"same", comparison.same()},
          {"verdict", verdict_text(comparison)},
          {"differs", provenance ? json_of(*provenance) : Json(nullptr)},
          {"columns", motion_columns()},
          {"bodies", all},
          {"tables", tables_of(comparison, files)},
          {"replay", replay}};
}

}  // namespace app
