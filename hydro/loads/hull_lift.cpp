#include "hydro/loads/hull_lift.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace hydro {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

/// Number of sections. Fewer: a midship step of a twentieth of the length is taken for a taper.
constexpr int kStations = 20;
/// Part of a section's height or breadth within which its outline is taken as straight [-]. Larger:
/// round sections lose as much of their added mass.
constexpr double kStraightOutline = 5e-3;

/// The vertical as a section sees it.
struct Vertical {
  Vector2d up = Vector2d::Zero();  ///< The vertical's components across the axis.
  double level = 0;                ///< Depth of the origin of the section's plane [m].

  double depth(const Vector2d& p) const { return level - up.dot(p); }
};

/// A wet piece of a section.
struct Piece {
  Vector2d low, high;  ///< Its box [m].
  double area = 0;     ///< [m^2]
  double top = 0;      ///< Depth of its highest point [m].
  double bottom = 0;   ///< Depth of its lowest point [m].

  Vector2d size() const { return high - low; }
  Vector2d middle() const { return (low + high) / 2; }
  bool overlaps(const Piece& other) const {
    return (low.array() < other.high.array()).all() && (other.low.array() < high.array()).all();
  }
  void join(const Piece& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
    area = std::min(area + other.area, size().prod());
    top = std::min(top, other.top);
    bottom = std::max(bottom, other.bottom);
  }
};

/// A piece that grows by the points of its outline.
class Outline {
 public:
  void add(const Vector2d& p, double depth) {
    if (count_++ == 0) {
      piece_ = {.low = p, .high = p, .top = depth, .bottom = depth};
      first_ = p;
    } else {
      const Vector2d a = last_ - first_, b = p - first_;
      piece_.area += (a.x() * b.y() - a.y() * b.x()) / 2;
      piece_.low = piece_.low.cwiseMin(p);
      piece_.high = piece_.high.cwiseMax(p);
      piece_.top = std::min(piece_.top, depth);
      piece_.bottom = std::max(piece_.bottom, depth);
    }
    last_ = p;
  }
  /// Ends the piece. Walls about what is dry inside, whose area is negative, are none.
  void end(std::vector<Piece>& pieces) {
    if (count_ > 2 && piece_.area > 0) pieces.push_back(piece_);
    count_ = 0;
  }

 private:
  int count_ = 0;
  Vector2d first_, last_;
  Piece piece_;
};

/// Adds the pieces of a loop that are below the surface.
void add_wet_pieces(const SectionLoop& loop, const Vertical& vertical, std::vector<Piece>& pieces) {
  const Eigen::Index count = loop.cols();
  Eigen::Index dry = 0;
  while (dry < count && vertical.depth(loop.col(dry)) > 0) ++dry;
  const bool all_wet = dry == count;
  Outline outline;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vector2d p = loop.col((dry + i) % count), q = loop.col((dry + i + 1) % count);
    const double d = vertical.depth(p), e = vertical.depth(q);
    if (all_wet || d > 0) outline.add(p, d);
    if ((d > 0) != (e > 0)) outline.add(p + d / (d - e) * (q - p), 0);
    if (d > 0 && !(e > 0)) outline.end(pieces);
  }
  if (all_wet) outline.end(pieces);
}

/// Joins pieces whose boxes overlap, as those of shapes that stand in each other.
void join_overlapping(std::vector<Piece>& pieces) {
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t k = i + 1; k < pieces.size();) {
      if (!pieces[i].overlaps(pieces[k])) {
        ++k;
        continue;
      }
      pieces[i].join(pieces[k]);
      pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(k));
      k = i + 1;
    }
}

/// C of (3).
double shape_factor(double thickness, double fullness) {
  const double g = (fullness - kPi / 4) / (1 - kPi / 4), q = std::sqrt(thickness);
  const double rectangle = 0.561 * q / (1 + 0.1 * q);
  return std::max(0.7, 1 + rectangle * (g > 0 ? std::min(1.0, g) : g / 3));
}

/// Effect of the surface on a piece, from 0 in the deep to 1 at the surface; on an axis that is
/// upright it is 0.
double nearness(const Piece& piece, double across) {
  const double height = piece.bottom - piece.top;
  return height > 0 ? across * std::max(0.0, 1 - piece.top / height) : 0;
}

/// a of (3) for motion along one of the two coordinates.
double sectional_mass(const Piece& piece, const Vertical& vertical, int along) {
  const Vector2d size = piece.size();
  const double b = size[along], h = size[1 - along];
  if (!(b > 0) || !(h > 0)) return 0;
  const double across = vertical.up.squaredNorm();
  const double near = nearness(piece, across);
  const double vertically = across > 0 ? vertical.up[along] * vertical.up[along] / across : 0;
  const double thickness = b / h * (1 + near * vertically) / (1 + near * (1 - vertically));
  const double surface = 1 + near * (1 - 1.5 * vertically);
  return kPi / 4 * h * h * shape_factor(thickness, piece.area / (b * h)) * surface;
}

/// The largest extent of a piece, its image in the surface included [m].
double largest_extent(const Piece& piece, const Vertical& vertical) {
  const double across = vertical.up.squaredNorm();
  const double height = piece.bottom - piece.top;
  return std::max(piece.size().maxCoeff(), height * (1 + nearness(piece, across)));
}

double smooth_step(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// The fall of a towards the stern, for motion along one coordinate.
class Fall {
 public:
  /// Goes on to a section nearer to the bow. @param step   Distance from the last one [m].
  /// @return κ Δa / a.
  double to(double mass, double count, double step) {
    if (!(mass > largest_)) return 0;
    const double slope =
        (std::sqrt(mass / (kPi * count)) - std::sqrt(largest_ / (kPi * count))) / step;
    const double ratio = slope / kSeparatingSlope;
    const double part = ratio * ratio / (1 + ratio * ratio) * (mass - largest_) / mass;
    largest_ = mass;
    return part;
  }

 private:
  double largest_ = 0;  ///< [m^2]
};

/// The wet pieces of a section, and the sums of their a for motion along its two coordinates.
struct WetSection {
  std::vector<Piece> pieces;
  std::array<std::vector<double>, 2> masses;  ///< Per piece [m^2].
  std::array<double, 2> mass = {0, 0};        ///< [m^2]
  double girth = 0;                           ///< Largest of the pieces [m].

  void find(const std::vector<SectionLoop>& loops, const Vertical& vertical) {
    pieces.clear();
    for (const SectionLoop& loop : loops) add_wet_pieces(loop, vertical, pieces);
    join_overlapping(pieces);
    girth = 0;
    for (const Piece& piece : pieces) girth = std::max(girth, largest_extent(piece, vertical));
    for (std::size_t along = 0; along < 2; ++along) {
      masses[along].clear();
      mass[along] = 0;
      for (const Piece& piece : pieces) {
        masses[along].push_back(sectional_mass(piece, vertical, static_cast<int>(along)));
        mass[along] += masses[along].back();
      }
    }
  }
};

/// The part of the lift that a body has by its slenderness.
double slender_part(double slenderness) {
  return smooth_step((slenderness - kLeastSlenderness) / (kFullSlenderness - kLeastSlenderness));
}

}  // namespace

HullLift::HullLift(const TriMesh& mesh_B) {
  const Eigen::AlignedBox3d box = bounding_box(mesh_B);
  if (mesh_B.face_count() == 0) return;
  const double length = box.sizes().maxCoeff(&axis_);
  if (!(length > kLeastSlenderness * box.sizes().minCoeff())) return;
  const double middle = box.center()[axis_];
  const auto place = [&](double i) {
    return middle - length / 2 * std::cos(kPi * std::clamp(i / kStations, 0.0, 1.0));
  };
  for (int i = 0; i < kStations; ++i) {
    Station station{.at = place(i + 0.5), .low = place(i), .high = place(i + 1), .loops = {}};
    for (const SectionLoop& loop : mesh_section(mesh_B, axis_, station.at)) {
      if (!(enclosed_area(loop) > 0)) continue;
      const Vector2d size = loop.rowwise().maxCoeff() - loop.rowwise().minCoeff();
      station.loops.push_back(simplified(loop, kStraightOutline * size.maxCoeff()));
    }
    stations_.push_back(std::move(station));
  }
}

Matrix6d HullLift::shed(const Vector3d& up_B, double below, bool ahead) const {
  const std::array<int, 2> across = {(axis_ + 1) % 3, (axis_ + 2) % 3};
  Matrix6d sum = Matrix6d::Zero();
  std::array<Fall, 2> falls;
  WetSection wet;
  double widest = 0, low = std::numeric_limits<double>::infinity(), high = -low;
  double last = ahead ? stations_.front().low : stations_.back().high;
  for (std::size_t n = 0; n < stations_.size(); ++n) {
    const Station& station = stations_[ahead ? n : stations_.size() - 1 - n];
    const double step = std::abs(station.at - last);
    last = station.at;
    wet.find(station.loops,
             {.up = {up_B[across[0]], up_B[across[1]]}, .level = below - up_B[axis_] * station.at});
    if (wet.pieces.empty()) continue;
    widest = std::max(widest, wet.girth);
    low = std::min(low, station.low);
    high = std::max(high, station.high);
    for (std::size_t along = 0; along < 2; ++along) {
      const double part =
          falls[along].to(wet.mass[along], static_cast<double>(wet.pieces.size()), step);
      if (part == 0) continue;
      const Vector3d d = Vector3d::Unit(across[along]);
      for (std::size_t i = 0; i < wet.pieces.size(); ++i) {
        Vector3d c;
        c[axis_] = ahead ? station.low : station.high;
        c[across[0]] = wet.pieces[i].middle()[0];
        c[across[1]] = wet.pieces[i].middle()[1];
        Vector6d b;
        b << d, c.cross(d);
        sum.noalias() += part * wet.masses[along][i] * b * b.transpose();
      }
    }
  }
  if (!(high > low)) return sum;
  // Depth of the upper end: while it is dry the body cannot travel along the vertical.
  const double rise = up_B[axis_];
  const double end = rise > 0 ? stations_.back().high : stations_.front().low;
  const double free = smooth_step((below - rise * end) / widest);
  return slender_part((high - low) / widest) * (1 - (1 - free) * rise * rise) * sum;
}

Matrix6d HullLift::jacobian(const BodyState& state, const HullWater& water) const {
  assert(is_unit(state.orientation));
  const Eigen::Matrix3d R_WB = state.orientation.toRotationMatrix();
  const double U = R_WB.col(axis_).dot(state.linear_velocity - water.velocity);
  if (U == 0 || stations_.empty()) return Matrix6d::Zero();
  const Matrix6d shed_B = shed(R_WB.row(2), water.surface - state.position.z(), U > 0);
  Matrix6d turn = Matrix6d::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = R_WB;
  return -water.density * std::abs(U) * turn * shed_B * turn.transpose();
}

Wrench HullLift::load(const BodyState& state, const HullWater& water) const {
  Vector6d u;
  u << state.linear_velocity - water.velocity, state.angular_velocity;
  const Vector6d F = jacobian(state, water) * u;
  return {F.head<3>(), F.tail<3>()};
}

}  // namespace hydro
