#include "app/run/constraint_errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numbers>

#include "app/base/console.h"
#include "app/run/constraint_warning.h"
#include "hydro/mesh/mesh.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostTold = 3;      ///< In a line of the terminal.
constexpr std::size_t kLeastSummed = 10;  ///< Overlaps in the summary, if there are as many.
constexpr double kDegree = std::numbers::pi / 180;  ///< [rad]

std::string partner_name(const engine::SimulationSpec& spec, engine::BodyId id) {
  return id == engine::kWorld ? "ground" : spec.bodies[static_cast<std::size_t>(id)].name;
}

/// Returns the longest edge of the box around a body [m]; infinite for the ground.
double size_of(const engine::SimulationSpec& spec, engine::BodyId id) {
  if (id == engine::kWorld) return std::numeric_limits<double>::infinity();
  return hydro::bounding_box(spec.bodies[static_cast<std::size_t>(id)].mesh_B).sizes().maxCoeff();
}

/// The largest error of a pair of bodies, of a joint, or of one body.
struct Told {
  double share = 0;  ///< Part of a size or of work [-].
  std::string whose;
  std::string text;  ///< With its unit.
};

/// Ordered by their shares, the largest first.
std::vector<Told> by_share(std::vector<Told> all) {
  std::ranges::stable_sort(all, std::ranges::greater(), &Told::share);
  return all;
}

struct PairOverlap {
  engine::Pair pair;
  engine::Peak depth;
  double share = 0;  ///< Part of the size of the smaller body [-].
};

std::vector<PairOverlap> pair_overlaps(const engine::SimulationSpec& spec,
                                       const engine::ConstraintErrors& errors) {
  std::vector<double> sizes;
  for (std::size_t i = 0; i < spec.bodies.size(); ++i)
    sizes.push_back(size_of(spec, static_cast<engine::BodyId>(i)));
  const auto size = [&](engine::BodyId id) {
    return id == engine::kWorld ? std::numeric_limits<double>::infinity()
                                : sizes[static_cast<std::size_t>(id)];
  };
  std::vector<PairOverlap> overlaps;
  for (const auto& [pair, depth] : errors.overlaps)
    overlaps.push_back({.pair = pair,
                        .depth = depth,
                        .share = depth.value / std::min(size(pair.first), size(pair.second))});
  std::ranges::stable_sort(overlaps, std::ranges::greater(), &PairOverlap::share);
  return overlaps;
}

std::vector<Told> told_overlaps(const engine::SimulationSpec& spec,
                                const engine::ConstraintErrors& errors) {
  std::vector<Told> told;
  for (const PairOverlap& overlap : pair_overlaps(spec, errors))
    told.push_back(
        {.share = overlap.share,
         .whose = fmt::format("{} and {}", partner_name(spec, overlap.pair.second),
                              partner_name(spec, overlap.pair.first)),
         .text = fmt::format("{:.2g} m at {:.4g} s", overlap.depth.value, overlap.depth.time)});
  return told;
}

/// A joint's error counts by its separation or its turn, whichever is the larger part.
std::vector<Told> told_joints(const engine::SimulationSpec& spec,
                              const engine::ConstraintErrors& errors) {
  std::vector<Told> told;
  for (std::size_t i = 0; i < spec.joints.size(); ++i) {
    const engine::JointSpec& joint = spec.joints[i];
    const auto& [separation, turn] = errors.joints[i];
    const double apart =
        separation.value / std::min(size_of(spec, joint.first), size_of(spec, joint.second));
    const engine::Peak& worse = apart >= turn.value ? separation : turn;
    std::string text = fmt::format("{:.2g} m", separation.value);
    if (joint.type != engine::JointSpec::Type::ball)
      text += fmt::format(" and {:.2g}°", turn.value / kDegree);
    told.push_back({.share = std::max(apart, turn.value),
                    .whose = joint.name,
                    .text = fmt::format("{} at {:.4g} s", text, worse.time)});
  }
  return by_share(std::move(told));
}

/// What the energy limiter took counts by its share of the work, without a record of work by that
/// of the substeps.
std::vector<Told> told_clamps(const engine::SimulationSpec& spec, const RunErrors& errors) {
  std::vector<Told> told;
  for (std::size_t i = 0; i < errors.works.size(); ++i)
    if (const double share = errors.works[i].clamped_share(); share > 0)
      told.push_back({.share = share,
                      .whose = spec.bodies[i].name,
                      .text = fmt::format("by {:.2g} % of the work on it", 100 * share)});
  if (!errors.works.empty()) return by_share(std::move(told));
  for (std::size_t i = 0; i < errors.counts.size(); ++i)
    if (const engine::Counts& counts = errors.counts[i]; counts.clamped > 0)
      told.push_back(
          {.share = static_cast<double>(counts.clamped) / static_cast<double>(counts.substeps),
           .whose = spec.bodies[i].name,
           .text = fmt::format("in {} of its {} substeps", counts.clamped, counts.substeps)});
  return by_share(std::move(told));
}

bool is_notable(const Told& one) { return one.share > kNotableError; }

/// `: a 1 m; b 0.5 m; and 3 more`
std::string listed(const std::string& what, const std::vector<Told>& told) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < std::min(told.size(), kMostTold); ++i)
    texts.push_back(told[i].whose + " " + told[i].text);
  if (told.size() > kMostTold) texts.push_back(fmt::format("and {} more", told.size() - kMostTold));
  return fmt::format("  {}: {}", what, fmt::join(texts, "; "));
}

/// Returns ` (and 2 other pairs by more than 1 %)` of those that are notable beside the first.
std::string others(const std::vector<Told>& told, const char* one, const char* many) {
  const auto count = static_cast<std::size_t>(std::ranges::count_if(told, is_notable)) - 1;
  if (count == 0) return "";
  return fmt::format(" (and {} by more than {:g} %)", counted(count, one, many),
                     100 * kNotableError);
}

}  // namespace

Json overlaps_summary(const engine::SimulationSpec& spec, const engine::ConstraintErrors& errors) {
  const std::vector<PairOverlap> overlaps = pair_overlaps(spec, errors);
  Json largest = Json::array();
  for (const PairOverlap& overlap : overlaps) {
    if (largest.size() >= kLeastSummed && overlap.share <= kNotableError) break;
    largest.push_back(
        {{"bodies",
          {partner_name(spec, overlap.pair.second), partner_name(spec, overlap.pair.first)}},
         {"depth", overlap.depth.value},
         {"at", overlap.depth.time},
         {"share_of_size", overlap.share}});
  }
  return {{"pairs", overlaps.size()}, {"largest", largest}};
}

Json joints_summary(const engine::SimulationSpec& spec, const engine::ConstraintErrors& errors) {
  Json all = Json::object();
  for (std::size_t i = 0; i < spec.joints.size(); ++i) {
    const auto& [separation, turn] = errors.joints[i];
    Json& joint = all[spec.joints[i].name];
    joint = {{"position_error_max", separation.value}, {"position_error_at", separation.time}};
    if (spec.joints[i].type == engine::JointSpec::Type::ball) continue;
    joint.update({{"angle_error_max_deg", turn.value / kDegree}, {"angle_error_at", turn.time}});
  }
  return all;
}

std::vector<std::string> error_warnings(const engine::SimulationSpec& spec,
                                        const RunErrors& errors) {
  std::vector<std::string> warnings;
  if (auto missed = constraint_warning(spec, errors.counts)) warnings.push_back(*std::move(missed));
  const auto add = [&](const std::vector<Told>& told, const auto& text) {
    if (!told.empty() && is_notable(told.front())) warnings.push_back(text(told.front(), told));
  };
  add(told_overlaps(spec, errors.constraints), [](const Told& worst, const auto& told) {
    return fmt::format(
        "{} overlapped by {}, {:.3g} % of the smaller one's size{}: contacts give way under heavy "
        "loads and fast impacts, and a shorter step stiffens them",
        worst.whose, worst.text, 100 * worst.share, others(told, "other pair", "other pairs"));
  });
  add(told_joints(spec, errors.constraints), [](const Told& worst, const auto& told) {
    return fmt::format(
        "joint '{}' came apart by {}, {:.3g} % of the smaller body's size{}: a shorter step may "
        "help",
        worst.whose, worst.text, 100 * worst.share, others(told, "other joint", "other joints"));
  });
  add(told_clamps(spec, errors), [](const Told& worst, const auto& told) {
    return fmt::format(
        "body '{}' was slowed {} to keep it from gaining energy{}: a shorter step may help",
        worst.whose, worst.text, others(told, "other body", "other bodies"));
  });
  return warnings;
}

std::vector<std::string> error_lines(const engine::SimulationSpec& spec, const RunErrors& errors) {
  std::vector<std::string> lines;
  const auto add = [&](const std::string& what, const std::vector<Told>& told) {
    if (!told.empty()) lines.push_back(listed(what, told));
  };
  add("largest overlaps", told_overlaps(spec, errors.constraints));
  add("largest errors of joints", told_joints(spec, errors.constraints));
  add("slowed by the energy limiter", told_clamps(spec, errors));
  return lines;
}

}  // namespace app
