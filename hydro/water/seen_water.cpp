#include "hydro/water/seen_water.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "hydro/airy_waves.h"
#include "hydro/loads/refine.h"

namespace hydro {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Width of the damped edge of the window over its side [-].
constexpr double kEdge = 0.2;

/// Damping across the edge over the group velocity of waves as long as the edge is wide [-].
constexpr double kDamping = 8;

/// Longest step of the water over 1/ω of the shortest waves of the grid [-], and longest way of a
/// body in a step over a cell [-]. No wave that the filter leaves is mistaken for another one from
/// step to step: both are below π.
constexpr double kLongestStep = 2, kLongestWay = 1.5;

/// Height of the water that counts as still, over a cell [-].
constexpr double kStill = 1e-6;

Vector2d current_of(const Sea& sea) { return sea.current.head<2>(); }

/// Weights of four neighbours at a part of the way between the middle two: Catmull and Rom's
/// spline.
Eigen::Vector4d cubic_weights(double t) {
  return Eigen::Vector4d(((2 - t) * t - 1) * t, (3 * t - 5) * t * t + 2, ((4 - 3 * t) * t + 1) * t,
                         (t - 1) * t * t) /
         2;
}

}  // namespace

double SurfacePatch::at(double x, double y) const {
  const double column = (x - origin.x()) / cell, row = (y - origin.y()) / cell;
  const Index n = heights.cols();
  if (!(column >= 1 && row >= 1 && column < static_cast<double>(n - 2) &&
        row < static_cast<double>(heights.rows() - 2)))
    return 0;
  const auto c = static_cast<Index>(column), r = static_cast<Index>(row);
  const Eigen::Vector4d across = cubic_weights(column - static_cast<double>(c));
  const Eigen::Vector4d along = cubic_weights(row - static_cast<double>(r));
  return along.dot(heights.block<4, 4>(r - 1, c - 1).cast<double>() * across);
}

PeriodicSquare square_about(const std::vector<WaterMover>& bodies,
                            const std::vector<BodyState>& states, const Sea& sea) {
  double largest = 0;
  Vector2d low = Vector2d::Constant(HUGE_VAL), high = -low;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].mesh_B == nullptr) continue;
    const double radius = bodies[i].radius;
    largest = std::max(largest, radius);
    low = low.cwiseMin(Vector2d(states[i].position.head<2>().array() - radius));
    high = high.cwiseMax(Vector2d(states[i].position.head<2>().array() + radius));
  }
  const double side = (high - low).maxCoeff() + 22 * largest;
  PeriodicSquare square{
      .cells = 256, .deepest = largest, .gravity = sea.gravity, .depth = sea.depth};
  if (side / square.cells > largest / 8) square.cells = 512;
  square.cell = side / square.cells;
  return square;
}

struct SeenWater::LocalSea {
  double elevation;  ///< Of the surface above W's origin, at the body's centre [m].
  Vector2d slope;
  Vector3d velocity;      ///< Of the water at the body's centre [m/s].
  Eigen::Matrix3d shear;  ///< Its change along x, y and z, in columns [1/s].
};

SeenWater::SeenWater(const Sea& sea, std::vector<WaterMover> bodies, const PeriodicSquare& square)
    : sea_(sea),
      bodies_(std::move(bodies)),
      waves_(square),
      longest_(kLongestStep / std::sqrt(sea.gravity * M_PI / waves_.square().cell)) {}

Vector2d SeenWater::in_square(const Vector2d& p_W, double time) const {
  return (p_W - time * current_of(sea_)) / waves_.square().cell;
}

/// Takes the window to the middle of the bodies, by whole cells.
void SeenWater::follow_bodies(const std::vector<BodyState>& states) {
  Vector2d low = Vector2d::Constant(HUGE_VAL), high = -low;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].mesh_B == nullptr) continue;
    const Vector2d place = in_square(states[i].position.head<2>(), now_.time);
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  now_.column = std::round((low.x() + high.x()) / 2);
  now_.row = std::round((low.y() + high.y()) / 2);
}

SeenWater::LocalSea SeenWater::local_sea(const WaterMover& body, const BodyState& state) const {
  const Vector3d& c = state.position;
  const double d = body.radius / 2;
  const auto surface = [&](double x, double y) { return surface_height(sea_, x, y, now_.time); };
  const auto water = [&](const Vector3d& p) { return water_at(sea_, p, now_.time).velocity; };
  LocalSea local{.elevation = surface(c.x(), c.y()),
                 .slope = {(surface(c.x() + d, c.y()) - surface(c.x() - d, c.y())) / (2 * d),
                           (surface(c.x(), c.y() + d) - surface(c.x(), c.y() - d)) / (2 * d)},
                 .velocity = water(c)};
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d step = d * Vector3d::Unit(axis);
    local.shear.col(axis) = (water(c + step) - water(c - step)) / (2 * d);
  }
  return local;
}

/// Adds the sources of a wet piece, in W axes about the centre of mass, halved to a cell's size.
void SeenWater::add_piece(const Panel& panel, const BodyState& state, const LocalSea& local,
                          double duration) {
  const double cell = waves_.square().cell;
  const PanelSplit split = longest_split(panel, [&](const Vector3d& a, const Vector3d& b) {
    return (b - a).squaredNorm() > cell * cell ? 0.5 : 0.0;
  });
  if (split.edge >= 0) {
    const Vector3d &a = panel[split.edge], &b = panel[(split.edge + 1) % 3],
                   &c = panel[(split.edge + 2) % 3];
    const Vector3d middle = (a + b) / 2;
    add_piece({a, middle, c}, state, local, duration);
    add_piece({middle, b, c}, state, local, duration);
    return;
  }
  const Vector3d r = (panel[0] + panel[1] + panel[2]) / 3;
  const Vector3d velocity =
      state.linear_velocity + state.angular_velocity.cross(r) - local.velocity - local.shear * r;
  const double volume = velocity.dot(area_vector(panel)) * duration;
  const Vector2d place = in_square((state.position + r).head<2>(), now_.time);
  const double reach = waves_.square().cells / 2.0 - 2;
  if ((place - Vector2d(now_.column, now_.row)).cwiseAbs().maxCoeff() > reach) return;
  const double surface = local.elevation + local.slope.dot(r.head<2>());
  waves_.add_source(place.x(), place.y(), std::min(0.0, state.position.z() + r.z() - surface),
                    volume);
  largest_ = std::max(largest_, std::abs(volume));
}

void SeenWater::add_sources(const WaterMover& body, const BodyState& state, double duration) {
  const LocalSea local = local_sea(body, state);
  const double above = state.position.z() - local.elevation;
  if (above > body.radius * (1 + local.slope.norm()) || -above > waves_.square().side() / 2) return;
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  for (Index face = 0; face < body.mesh_B->face_count(); ++face) {
    Panel panel = panel_of(*body.mesh_B, face);
    Vector3d depth;
    for (int i = 0; i < 3; ++i) {
      panel[i] = R_WB * panel[i];
      depth[i] = local.slope.dot(panel[i].head<2>()) - above - panel[i].z();
    }
    if (depth.maxCoeff() <= 0) continue;
    if (depth.minCoeff() >= 0)
      add_piece(panel, state, local, duration);
    else
      for (const PanelPart& part : positive_part(panel, depth))
        add_piece(part.panel, state, local, duration);
  }
}

void SeenWater::follow(double time, const std::vector<BodyState>& states) {
  if (!now_.started) now_ = {.time = time, .started = true};
  double fastest = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (bodies_[i].mesh_B != nullptr)
      fastest = std::max(fastest, states[i].linear_velocity.norm() +
                                      bodies_[i].radius * states[i].angular_velocity.norm());
  const double cell = waves_.square().cell, elapsed = time - now_.time;
  if (elapsed < longest_ * (1 - 1e-9) && elapsed * fastest < kLongestWay * cell) return;
  if (!now_.still) waves_.advance(elapsed);
  now_.time = time;
  follow_bodies(states);
  largest_ = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (bodies_[i].mesh_B != nullptr) add_sources(bodies_[i], states[i], elapsed);
  if (now_.still && largest_ < kStill * cell * cell * cell) return;
  now_.still = false;
  waves_.take_sources();
  now_.undamped += elapsed;
  if (now_.undamped > 4 * longest_) damp_edges();
}

void SeenWater::damp_edges() {
  const PeriodicSquare& square = waves_.square();
  const double width = kEdge * square.side();
  const double speed = std::sqrt(square.gravity * width / (2 * M_PI)) / 2;
  const double rate = kDamping * speed / width;
  const auto factors = [&](double middle) {
    Eigen::VectorXf factor(square.cells);
    for (Index i = 0; i < square.cells; ++i) {
      const double away =
          std::abs(std::remainder(static_cast<double>(i) - middle, square.cells)) * square.cell;
      const double s = std::max(0.0, (away - square.side() / 2) / width + 1);
      factor[i] = static_cast<float>(std::exp(-rate * s * s * now_.undamped));
    }
    return factor;
  };
  waves_.damp(factors(now_.column), factors(now_.row));
  now_.undamped = 0;
}

std::optional<SurfacePatch> SeenWater::patch(double time) const {
  if (now_.still) return std::nullopt;
  const Eigen::MatrixXf torus = waves_.elevation(time - now_.time);
  const Index n = torus.rows();
  const Index half = n / 2;
  const auto first_column = static_cast<Index>(now_.column) - half;
  const auto first_row = static_cast<Index>(now_.row) - half;
  SurfacePatch patch{.heights = Eigen::MatrixXf(n, n), .cell = waves_.square().cell};
  for (Index column = 0; column < n; ++column)
    for (Index row = 0; row < n; ++row)
      patch.heights(row, column) =
          torus((first_row + row) & (n - 1), (first_column + column) & (n - 1));
  patch.origin =
      Vector2d(now_.column - static_cast<double>(half), now_.row - static_cast<double>(half)) *
          patch.cell +
      time * current_of(sea_);
  return patch;
}

std::string SeenWater::state() const {
  const double numbers[] = {now_.time,
                            now_.undamped,
                            now_.column,
                            now_.row,
                            now_.started ? 1.0 : 0.0,
                            now_.still ? 1.0 : 0.0};
  const Eigen::MatrixXcd& zeta = waves_.state();
  std::string bytes(reinterpret_cast<const char*>(numbers), sizeof numbers);
  bytes.append(reinterpret_cast<const char*>(zeta.data()), sizeof *zeta.data() * zeta.size());
  return bytes;
}

void SeenWater::restore(const std::string& state) {
  double numbers[6];
  Eigen::MatrixXcd zeta(waves_.square().cells, waves_.square().cells);
  if (state.size() != sizeof numbers + sizeof *zeta.data() * zeta.size())
    throw std::invalid_argument("the state of the bodies' waves is that of another scene");
  std::memcpy(numbers, state.data(), sizeof numbers);
  std::memcpy(zeta.data(), state.data() + sizeof numbers, state.size() - sizeof numbers);
  now_ = {.time = numbers[0],
          .undamped = numbers[1],
          .column = numbers[2],
          .row = numbers[3],
          .started = numbers[4] != 0,
          .still = numbers[5] != 0};
  waves_.restore(std::move(zeta));
}

}  // namespace hydro
