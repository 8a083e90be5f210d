#include "engine/hollows/flooding.h"

#include <algorithm>
#include <cmath>

#include "engine/base/constants.h"
#include "engine/hollows/pocket_search.h"
#include "engine/hollows/spaces.h"
#include "engine/hollows/streams.h"
#include "engine/hollows/trapped_air.h"
#include "engine/motion/body.h"
#include "engine/motion/substep_path.h"
#include "hydro/airy_waves.h"

namespace engine {
namespace {

using hydro::kSea;

/// The points of Gauss' rule of degree 5 between 0 and 1, and their weights.
constexpr double kPoint[] = {0.1127016653792583, 0.5, 0.8872983346207417};
constexpr double kWeight[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};

/// Lets water run between the pockets of one body at one pose. Heights are above the centre of
/// mass.
class Flooding {
 public:
  /// @param rates   Flows of the pumps without a lift [m^3/s].
  Flooding(const Body& body, const hydro::BodyState& state, double time,
           const std::vector<double>& rates, CarriedWater& carried)
      : body_(body),
        spaces_(body, state, time, carried),
        division_(spaces_.division()),
        rates_(rates),
        water_(carried) {}

  void run(double h);
  /// True if the water over a sill or opening is another by more than half of its height there, as
  /// where it crosses the surface. The sea's slope between is left out.
  bool differs(const hydro::BodyState& there, double later) const;

 private:
  using Sill = std::vector<hydro::SillEdge>::const_iterator;

  bool is_sea(int space) const { return spaces_.is_sea(space); }
  double sea_level(const Eigen::Vector3d& r) const { return spaces_.sea_level(r); }
  double level(int space, const Eigen::Vector3d& r) const { return spaces_.level(space, r); }
  Eigen::Vector3d vertex(int i) const { return spaces_.vertex(i); }

  void add_edge(const hydro::SillEdge& edge, Stream& stream) const;
  void run_over(Sill from, Sill to, double h);
  void run_through(std::size_t opening, double h);
  void run_pump(std::size_t pump, double h);
  bool is_joined(int pocket, const Stream& stream) const;
  void flood(int pocket);
  void isolate();

  const Body& body_;
  Spaces spaces_;
  const hydro::Pockets& division_;
  const std::vector<double>& rates_;
  CarriedWater& water_;
};

/// Adds what runs over an edge of a sill.
void Flooding::add_edge(const hydro::SillEdge& edge, Stream& stream) const {
  const std::array<Eigen::Vector3d, 2> end = {vertex(edge.from), vertex(edge.to)};
  std::array<double, 2> first, second, head;
  for (int i = 0; i < 2; ++i) {
    first[i] = level(edge.pocket, end[i]) - end[i].z();
    second[i] = level(edge.other, end[i]) - end[i].z();
    head[i] = std::max(first[i], second[i]);
    stream.lowest = std::min(stream.lowest, end[i].z());
    stream.submerged = stream.submerged && second[i] > 0;
  }
  if (std::max(head[0], head[1]) <= 0) return;
  // The part of the edge under water.
  double from = 0, to = 1;
  if (head[0] < 0) from = std::isfinite(head[0]) ? head[0] / (head[0] - head[1]) : 1;
  if (head[1] < 0) to = std::isfinite(head[1]) ? head[0] / (head[0] - head[1]) : 0;
  const double length = (to - from) * (end[1] - end[0]).head<2>().norm();
  for (int k = 0; k < 3 && length > 0; ++k) {
    const double s = from + kPoint[k] * (to - from);
    const auto at = [s](const std::array<double, 2>& ends) {
      return std::isfinite(ends[0] + ends[1]) ? ends[0] + s * (ends[1] - ends[0]) : -HUGE_VAL;
    };
    const double in = weir_flow(at(second), at(first), spaces_.sea().gravity);
    const double out = weir_flow(at(first), at(second), spaces_.sea().gravity);
    const double weight = kWeight[k] * length;
    stream.rate += weight * (at(second) > at(first) ? in : -out);
    stream.length += weight;
    stream.sea_level += weight * (at(second) + end[0].z() + s * (end[1].z() - end[0].z()));
  }
}

void Flooding::run_over(Sill from, Sill to, double h) {
  const int first = from->pocket, second = from->other;
  if (is_sea(first) && is_sea(second)) return;
  Stream stream;
  for (Sill edge = from; edge != to; ++edge) add_edge(*edge, stream);
  if (!(stream.length > 0)) return;
  stream.sea_level /= stream.length;
  if (is_sea(first)) {
    // The other pocket is the one that may be flooded.
    Stream turned = stream;
    turned.rate = -stream.rate;
    turned.sea_level = sea_level(vertex(from->from));
    spaces_.exchange(second, kSea, turned, h);
    if (is_joined(second, turned)) flood(second);
  } else {
    spaces_.exchange(first, second, stream, h);
    if (is_sea(second) && is_joined(first, stream)) flood(first);
  }
}

void Flooding::run_through(std::size_t opening, double h) {
  const auto [first, second] = water_.openings[opening];
  if (first == second || (is_sea(first) && is_sea(second))) return;
  const Opening& hole = body_.spec->openings[opening];
  const Eigen::Vector3d r = spaces_.R_WB() * hole.at_B;
  const int inner = is_sea(first) ? second : first, outer = is_sea(first) ? first : second;
  const double difference = spaces_.head(outer, r) - spaces_.head(inner, r);
  if (difference == 0 || !(level(difference > 0 ? outer : inner, r) > r.z())) return;
  Stream stream{.rate = hole.discharge * hole.area *
                        std::copysign(std::sqrt(2 * spaces_.sea().gravity * std::abs(difference)),
                                      difference),
                .lowest = r.z(),
                .head = std::abs(difference)};
  if (is_sea(outer)) stream.sea_level = r.z() + spaces_.head(outer, r);
  spaces_.exchange(inner, outer, stream, h);
}

void Flooding::run_pump(std::size_t pump, double h) {
  const auto [from, to] = water_.pumps[pump];
  if (!(rates_[pump] > 0) || from == to || (is_sea(from) && is_sea(to))) return;
  const PumpSpec& spec = body_.spec->pumps[pump];
  const Eigen::Vector3d suction = spaces_.R_WB() * spec.from_B;
  const Eigen::Vector3d outlet = spaces_.R_WB() * spec.to_B.value_or(spec.from_B);
  const double low = level(from, suction);
  if (!(low > suction.z())) return;
  const double high = spec.to_B ? std::max(level(to, outlet), outlet.z()) : level(to, outlet);
  const auto air = [&](int space) { return is_sea(space) ? 0 : air_head(spaces_, space); };
  const double lift = high - low + air(to) - air(from);
  double volume = pump_flow(rates_[pump], lift, spec.head) * h;
  if (!is_sea(from))
    volume =
        std::min(volume, water_.pockets[from].volume - spaces_.volume_up_to(from, suction.z()));
  if (!is_sea(to) && spaces_.is_void(to))  // A full void takes no more.
    volume = std::min(volume, spaces_.capacity(to) - water_.pockets[to].volume);
  if (volume > 0) spaces_.bring(from, to, volume);
}

/// True if the sea above a sill and the water in a full pocket behind it are one.
bool Flooding::is_joined(int pocket, const Stream& stream) const {
  const double over = stream.sea_level - stream.lowest;
  const double level = water_.pockets[pocket].surface.level;
  const bool near = std::abs(stream.sea_level - level) <= kJoinedHead * over;
  const double whole = spaces_.volume_up_to(pocket, spaces_.spill_of({pocket}));
  // A pocket whose mouth looks down holds nothing.
  const bool turned = whole <= kLastWater * division_.pockets[pocket].capacity;
  return over > 0 && (stream.submerged || near || turned) && water_.pockets[pocket].volume >= whole;
}

/// Makes a pocket part of the sea. It carries the most water that it has held, and would hold up to
/// its spill height since.
void Flooding::flood(int pocket) {
  PocketContent& content = water_.pockets[pocket];
  content.flooded = true;
  content.surface.level = spaces_.spill_of({pocket});
  const double whole = spaces_.volume_up_to(pocket, content.surface.level);
  if (whole > content.volume) spaces_.set_volume(pocket, whole);
}

/// Parts flooded pockets from the sea that no water above a sill connects with it.
void Flooding::isolate() {
  const int n = static_cast<int>(water_.pockets.size());
  std::vector<int> group(n);
  for (int i = 0; i < n; ++i) group[i] = water_.pockets[i].flooded ? i : n;
  const auto of = [&](int space) { return space == kSea ? kSea : group[space]; };
  for (const hydro::SillEdge& edge : division_.sills) {
    const int a = of(edge.pocket), b = of(edge.other);
    if (a == n || b == n || a == b) continue;
    const auto under_water = [&](int v) { return sea_level(vertex(v)) > vertex(v).z(); };
    if (!under_water(edge.from) && !under_water(edge.to)) continue;
    std::replace(group.begin(), group.end(), std::max(a, b), std::min(a, b));
  }
  std::vector<std::vector<int>> parted(n);
  for (int i = 0; i < n; ++i)
    if (0 <= group[i] && group[i] < n) parted[group[i]].push_back(i);
  // Pockets that part at once are no longer sea for one another.
  for (const std::vector<int>& pockets : parted)
    for (const int i : pockets) water_.pockets[i].flooded = false;
  for (const std::vector<int>& pockets : parted) {
    if (pockets.empty()) continue;
    // Over lower sills it runs into other pockets, not at once.
    double spill = spaces_.spill_of(pockets, true);
    if (!std::isfinite(spill)) spill = spaces_.spill_of(pockets);
    for (const int i : pockets) {
      water_.pockets[i].surface.level = spill;
      spaces_.set_volume(i, spaces_.volume_up_to(i, spill));
    }
  }
}

bool Flooding::differs(const hydro::BodyState& there, double later) const {
  const auto sea_over = [&](const hydro::BodyState& s, double time) {
    return hydro::surface_height(spaces_.sea(), s.position.x(), s.position.y(), time) -
           s.position.z();
  };
  const double rise =
      sea_over(there, spaces_.time() + later) - sea_over(spaces_.state(), spaces_.time());
  const Eigen::RowVector3d up_there = there.orientation.toRotationMatrix().row(2);
  const auto differs = [&](const Eigen::Vector3d& p_B, int space) {
    const Eigen::Vector3d r = spaces_.R_WB() * p_B;
    const double over = level(space, r) - r.z();
    const double over_there = over + r.z() - up_there.dot(p_B) + (is_sea(space) ? rise : 0);
    return std::max(over, over_there) > 0 && std::abs(over_there - over) > std::abs(over) / 2;
  };
  const Eigen::Matrix3Xd& vertices = body_.spec->mesh_B.vertices;
  for (const hydro::SillEdge& edge : division_.sills)
    for (const int v : {edge.from, edge.to})
      if (differs(vertices.col(v), edge.pocket) || differs(vertices.col(v), edge.other))
        return true;
  for (std::size_t i = 0; i < water_.openings.size(); ++i)
    for (const int space : water_.openings[i])
      if (differs(body_.spec->openings[i].at_B, space)) return true;
  return false;
}

void Flooding::run(double h) {
  isolate();
  for (std::size_t i = 0; i < water_.pockets.size(); ++i)
    if (water_.pockets[i].flooded) flood(static_cast<int>(i));
  for (Sill from = division_.sills.begin(); from != division_.sills.end();) {
    const Sill to = std::find_if(from, division_.sills.end(), [&](const hydro::SillEdge& edge) {
      return edge.pocket != from->pocket || edge.other != from->other;
    });
    run_over(from, to, h);
    from = to;
  }
  for (std::size_t i = 0; i < water_.openings.size(); ++i) run_through(i, h);
  for (std::size_t i = 0; i < water_.pumps.size(); ++i) run_pump(i, h);
  pass_air(spaces_);
}

/// True if water may run for a time h about the end of a way.
bool may_run(const Body& body, const CarriedWater& carried, const SubstepPath& path,
             const std::vector<double>& rates, double h) {
  if (!carried.interior) return false;
  const auto dips = [&](double time) {
    return lowest_sill(body, carried, path.at(time)) < body.environment.highest;
  };
  return carried.holds() || !carried.openings.empty() || pumping(rates) || dips(0) ||
         dips(-h / 2) || dips(h / 2);
}

/// The water after it has run for a time h about the end of a way at `time` [s].
std::shared_ptr<CarriedWater> run_water(const Body& body, const SubstepPath& path, double time,
                                        double h, const std::vector<double>& rates,
                                        const CarriedWater& carried) {
  auto water = std::make_shared<CarriedWater>(carried);
  const hydro::BodyState end = path.at(0);
  Flooding whole(body, end, time, rates, *water);
  if (!whole.differs(path.at(-h / 2), -h / 2) && !whole.differs(path.at(h / 2), h / 2)) {
    whole.run(h);
    constexpr auto flooded = &PocketContent::flooded;
    if (std::ranges::equal(carried.pockets, water->pockets, {}, flooded, flooded)) return water;
  }
  *water = carried;
  for (int i = 0; i < kWaterParts; ++i) {
    const double since = ((i + 0.5) / kWaterParts - 0.5) * h;
    Flooding(body, path.at(since), time + since, rates, *water).run(h / kWaterParts);
  }
  return water;
}

}  // namespace

void let_water_run(const Body& body, const hydro::BodyState& before, double time, double h,
                   const std::vector<double>& rates, Motion& motion) {
  const std::shared_ptr<const CarriedWater> old = motion.carried_water;
  if (!old || (!old->holds() && !may_be_wet(body, motion.state))) return;
  motion.carried_water = divided_for(body, before, motion.state, time, old);
  const SubstepPath path(before, motion.state, h);
  if (may_run(body, *motion.carried_water, path, rates, h)) {
    const auto after = run_water(body, path, time, h, rates, *motion.carried_water);
    settle(motion.state.orientation.toRotationMatrix(), *after);
    after->inertia_B = water_inertia(after->pockets, body.environment.sea->density);
    if (after->pockets != motion.carried_water->pockets) motion.carried_water = after;
  }
  const Matrix6d change = motion.carried_water->inertia_B - old->inertia_B;
  if (!body.has_added_mass || change.isZero(0)) return;
  const double jump = std::abs(change(0, 0)) / (body.rigid_B + motion.added()).diagonal()[0];
  motion = share_momentum(body, motion, motion.added() + change);
  if (jump <= kMassJump) return;
  // Accelerations and reactions of another mass tell nothing of the next ones.
  motion.accelerations.clear();
  motion.load_acceleration_W.reset();
}

}  // namespace engine
