#include "hydro/resistance/thin_ship.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>

#include "hydro/decompositions.h"
#include "hydro/parallel.h"
#include "hydro/radiation/gauss_rule.h"

namespace hydro {

/// Vertices of the wetted faces, with those that the surface cuts, and the faces themselves.
struct ThinShip::WetMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::size_t, 3>> faces;

  /// Area times outward unit normal [m^2].
  Eigen::Vector3d area_vector(const std::array<std::size_t, 3>& face) const {
    const Eigen::Vector3d& p = vertices[face[0]];
    return (vertices[face[1]] - p).cross(vertices[face[2]] - p) / 2;
  }
};

namespace {

using Complex = std::complex<double>;
using WetMesh = ThinShip::WetMesh;

// Froude numbers of the table.
constexpr double kLeastFroude = 0.1, kLargestFroude = 1;
constexpr double kLargestFroudeStep = 0.02;
constexpr double kLowFroude = 0.2;  ///< Below it the table is half as fine.
/// Part of the volume up to which a part of the hull need not be slender [-].
constexpr double kLeastPart = 0.01;
/// Square of the distance within which a source is spread, over its face's area [-].
constexpr double kCore = 0.1;
constexpr double kSame = 1e-9;  ///< Distance of corners that are one, over the length [-].
/// Step of 1/Fn², which grows by 2π from a hump to the next.
constexpr double kHumpStep = 0.5;

// Limits of the integral over the waves' directions.
constexpr double kPhasePerPiece = 8;      ///< [rad]
constexpr double kLargestPiece = 0.3;     ///< Longest piece, in u [-].
constexpr double kLeastPiece = 1e-5;      ///< Part of the sum below which pieces are left out [-].
constexpr double kLargestLambda = 60;     ///< [-]
constexpr double kDeepest = 36;           ///< Exponent below which a wave is not felt [-].
constexpr double kSmallDifference = 0.5;  ///< Difference of exponents with a short series.

/// Cuts the mesh at z = 0. Faces that share a cut edge share its point.
WetMesh wet_part(const Eigen::Matrix3Xd& vertices, const TriMesh& mesh) {
  WetMesh wet;
  std::map<std::array<int, 2>, std::size_t> known;  // A vertex twice: itself.
  const auto add = [&](std::array<int, 2> key, const Eigen::Vector3d& at) {
    const auto [place, is_new] = known.emplace(key, wet.vertices.size());
    if (is_new) wet.vertices.push_back(at);
    return place->second;
  };
  for (const auto face : mesh.faces.colwise()) {
    std::vector<std::size_t> corners;
    for (int i = 0; i < 3; ++i) {
      const int from = face[i], to = face[(i + 1) % 3];
      const Eigen::Vector3d a = vertices.col(from), b = vertices.col(to);
      if (a.z() < 0) corners.push_back(add({from, from}, a));
      if ((a.z() < 0) == (b.z() < 0)) continue;
      const int low = a.z() < 0 ? from : to, high = a.z() < 0 ? to : from;
      const Eigen::Vector3d p = vertices.col(low), q = vertices.col(high);
      Eigen::Vector3d cut = p + p.z() / (p.z() - q.z()) * (q - p);
      cut.z() = 0;
      corners.push_back(add({low, high}, cut));
    }
    for (std::size_t i = 2; i < corners.size(); ++i)
      wet.faces.push_back({corners[0], corners[i - 1], corners[i]});
  }
  return wet;
}

/// Turns the mesh about z so that its sides face x the least. @return its x axis before
Eigen::Vector2d turn_along(WetMesh& wet) {
  Eigen::Matrix2d facing = Eigen::Matrix2d::Zero();
  for (const auto& face : wet.faces) {
    const Eigen::Vector3d a = wet.area_vector(face);
    if (a.norm() > 0) facing += a.head<2>() * a.head<2>().transpose() / a.norm();
  }
  const Eigen::Vector2d along = eigen_decomposition(facing).vectors.col(0);
  for (Eigen::Vector3d& v : wet.vertices)
    v.head<2>() = Eigen::Vector2d(along.dot(v.head<2>()), along.x() * v.y() - along.y() * v.x());
  return along;
}

/// The part that each vertex is of: parts are connected by edges below the surface.
std::vector<std::size_t> parts_of(const WetMesh& wet) {
  std::vector<std::size_t> root(wet.vertices.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&root](std::size_t v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (const auto& face : wet.faces)
    for (const std::size_t v : {face[1], face[2]}) root[find(v)] = find(face[0]);
  std::map<std::size_t, std::size_t> numbers;
  std::vector<std::size_t> parts(wet.vertices.size());
  for (std::size_t v = 0; v < parts.size(); ++v)
    parts[v] = numbers.emplace(find(v), numbers.size()).first->second;
  return parts;
}

[[noreturn]] void refuse_slenderness(const Eigen::Vector2d& size) {
  std::array<char, 160> text;
  std::snprintf(text.data(), text.size(),
                "a part of it in the water is %.3g m long and %.3g m wide, and thin-ship theory "
                "asks for a length of %g widths",
                size.x(), size.y(), kLeastThinShip);
  throw std::invalid_argument(text.data());
}

/// a/b without regard to overflow.
Complex ratio(const Complex& a, const Complex& b) { return a * std::conj(b) / std::norm(b); }

/// exp[a, b] = (e^a − e^b)/(a − b)
Complex divided(const Complex& a, const Complex& b, const Complex& exp_a, const Complex& exp_b) {
  const Complex d = a - b;
  if (std::norm(d) > kSmallDifference * kSmallDifference) return ratio(exp_a - exp_b, d);
  Complex sum = 1, term = 1;
  for (int n = 2; n <= 9; ++n) sum += term *= d / static_cast<double>(n);
  return exp_b * sum;
}

/// exp[a, b, c]: half of the mean of exp over a triangle with these values at its corners.
Complex divided(std::array<Complex, 3> at, std::array<Complex, 3> exp_at) {
  const auto gap = [&at](int i, int j) { return std::norm(at[i] - at[j]); };
  if (gap(0, 1) > gap(0, 2) && gap(0, 1) >= gap(1, 2)) {
    std::swap(at[1], at[2]);
    std::swap(exp_at[1], exp_at[2]);
  } else if (gap(1, 2) > gap(0, 2)) {
    std::swap(at[0], at[1]);
    std::swap(exp_at[0], exp_at[1]);
  }
  const auto& [a, b, c] = at;
  const double largest = gap(0, 2);
  if (largest > kSmallDifference * kSmallDifference)
    return ratio(divided(a, b, exp_at[0], exp_at[1]) - divided(b, c, exp_at[1], exp_at[2]), a - c);
  // With h_n the sum of p^i q^(n−i): exp[a, b, c] = e^b Σ h_n / (n + 2)!.
  const Complex p = a - b, q = c - b, sum = p + q, product = p * q;
  Complex before = 0, h = 1, series = 0.5;
  double factor = 0.5;
  const int terms = largest < 1e-4 ? 3 : largest < 1e-2 ? 5 : 8;  // of relative error below 1e-9
  for (int n = 1; n <= terms; ++n) {
    const Complex next = sum * h - product * before;
    before = h;
    h = next;
    factor /= n + 2;
    series += factor * h;
  }
  return exp_at[1] * series;
}

}  // namespace

ThinShip::ThinShip(const TriMesh& mesh_B, const MeanPose& pose) {
  Eigen::Matrix3Xd vertices = pose.orientation.toRotationMatrix() * mesh_B.vertices;
  vertices.row(2).array() += pose.height;
  WetMesh wet = wet_part(vertices, mesh_B);
  if (wet.faces.empty()) throw std::invalid_argument("nothing of it is in the water");
  along_ = turn_along(wet);
  const std::vector<std::size_t> part_of = parts_of(wet);
  measure_parts(wet, part_of);
  gather_sources(wet, part_of);
}

void ThinShip::measure_parts(const WetMesh& wet, const std::vector<std::size_t>& part_of) {
  std::vector<Eigen::AlignedBox2d> boxes(*std::ranges::max_element(part_of) + 1);
  std::vector<double> volumes(boxes.size()), moments(boxes.size());
  Eigen::AlignedBox2d all;
  for (std::size_t v = 0; v < part_of.size(); ++v) {
    boxes[part_of[v]].extend(wet.vertices[v].head<2>());
    all.extend(wet.vertices[v].head<2>());
  }
  double blunt = 0, section = 0;
  for (const auto& face : wet.faces) {
    const Eigen::Vector3d a = wet.area_vector(face);
    Eigen::Vector3d y;
    for (int i = 0; i < 3; ++i) y[i] = wet.vertices[face[i]].y();
    volumes[part_of[face[0]]] += a.y() * y.mean();
    moments[part_of[face[0]]] += a.y() * (y.squaredNorm() + y.sum() * y.sum()) / 24;  // ½ y² n_y
    section += std::abs(a.x());
    if (std::abs(a.x()) > std::numbers::sqrt2 / 2 * a.norm()) blunt += std::abs(a.x());
  }
  bluntness_ = section > 0 ? blunt / section : 0;
  length_ = all.sizes().x();
  const double whole = std::reduce(volumes.begin(), volumes.end());
  Eigen::AlignedBox1d planes;
  for (std::size_t p = 0; p < boxes.size(); ++p) {
    const Eigen::Vector2d size = boxes[p].sizes();
    const bool counts = volumes[p] > kLeastPart * whole;
    if (counts && size.x() < kLeastThinShip * size.y()) refuse_slenderness(size);
    parts_.push_back({.length = size.x(),
                      .beam = size.y(),
                      .y = volumes[p] > 0 ? moments[p] / volumes[p] : boxes[p].center().y()});
    planes.extend(Eigen::Matrix<double, 1, 1>(parts_.back().y));
  }
  width_ = planes.sizes()[0];
}

void ThinShip::gather_sources(const WetMesh& wet, const std::vector<std::size_t>& part_of) {
  // Both sides of a hull that is alike on them have the same corners on its centre plane.
  std::map<std::array<double, 3>, std::size_t> corners;
  std::vector<std::size_t> corner_of;
  for (std::size_t v = 0; v < part_of.size(); ++v) {
    const Eigen::Vector3d& at = wet.vertices[v];
    const auto rounded = [this](double number) { return std::round(number / (kSame * length_)); };
    const std::array<double, 3> key = {static_cast<double>(part_of[v]), rounded(at.x()),
                                       rounded(at.z())};
    const auto [place, is_new] = corners.emplace(key, x_.size());
    if (is_new) {
      x_.push_back(at.x());
      z_.push_back(at.z());
    }
    corner_of.push_back(place->second);
  }
  std::map<std::array<std::size_t, 3>, Face> faces;
  for (const auto& face : wet.faces) {
    Face added{.corners = {corner_of[face[0]], corner_of[face[1]], corner_of[face[2]]},
               .source = -wet.area_vector(face).x(),
               .part = part_of[face[0]]};
    std::ranges::sort(added.corners);
    for (const std::size_t corner : added.corners) added.top = std::max(added.top, z_[corner]);
    const auto [place, is_new] = faces.emplace(added.corners, added);
    if (!is_new) place->second.source += added.source;
  }
  for (const auto& [corner, face] : faces) faces_.push_back(face);
  for (const auto& face : wet.faces)
    panels_.push_back(
        {.at = (wet.vertices[face[0]] + wet.vertices[face[1]] + wet.vertices[face[2]]) / 3,
         .rise = wet.area_vector(face).z()});
  std::ranges::sort(faces_, std::ranges::greater(), &Face::top);
}

std::vector<double> ThinShip::numbers() const {
  std::vector<double> all = {length_, width_};
  for (const Part& part : parts_) all.push_back(part.y);
  all.insert(all.end(), x_.begin(), x_.end());
  all.insert(all.end(), z_.begin(), z_.end());
  for (const Face& face : faces_) {
    for (const std::size_t corner : face.corners) all.push_back(static_cast<double>(corner));
    all.insert(all.end(), {face.source, static_cast<double>(face.part)});
  }
  for (const Panel& panel : panels_)
    all.insert(all.end(), {panel.at.x(), panel.at.y(), panel.at.z(), panel.rise});
  all.insert(all.end(), {along_.x(), along_.y()});
  return all;
}

double ThinShip::amplitude(double k, double lambda) const {
  const double deepest = -kDeepest / (k * lambda * lambda);
  std::vector<Complex> at(x_.size()), exp_at(x_.size());
  for (std::size_t v = 0; v < x_.size(); ++v) {
    at[v] = k * lambda * Complex(lambda * z_[v], x_[v]);
    if (z_[v] > 2 * deepest) exp_at[v] = std::exp(at[v]);
  }
  std::vector<Complex> K(parts_.size());
  for (const Face& face : faces_) {
    if (face.top < deepest) break;
    const auto& [a, b, c] = face.corners;
    K[face.part] += face.source * divided({at[a], at[b], at[c]}, {exp_at[a], exp_at[b], exp_at[c]});
  }
  const double across = k * lambda * std::sqrt(lambda * lambda - 1);
  Complex left = 0, right = 0;
  for (std::size_t p = 0; p < K.size(); ++p) {
    const Complex turn = std::polar(1.0, across * parts_[p].y);
    left += K[p] * turn;
    right += K[p] * std::conj(turn);
  }
  return (std::norm(left) + std::norm(right)) / 2;
}

double ThinShip::resistance(double speed, double gravity) const {
  const double k = gravity / (speed * speed);
  double sum = 0, lambda = 1;
  for (int small = 0; small < 3 && lambda < kLargestLambda;) {
    const double u = std::acosh(lambda);
    double end = std::min(u + kLargestPiece, std::acosh(lambda + kPhasePerPiece / (k * length_)));
    end = std::min(end, u + kPhasePerPiece / (k * width_ * std::cosh(2 * (u + kLargestPiece))));
    const double half = (end - u) / 2;
    double piece = 0;
    for (std::size_t i = 0; i < kGaussAt.size(); ++i)
      for (const double side : {-1, 1}) {
        const double at = std::cosh(u + half * (1 + side * kGaussAt[i]));
        piece += half * kGaussWeight[i] * amplitude(k, at) * at * at;
      }
    sum += piece;
    small = piece <= kLeastPiece * sum ? small + 1 : 0;
    lambda = std::cosh(end);
  }
  return 4 * gravity * k / std::numbers::pi * sum;
}

ThinShip::Suction ThinShip::suction() const {
  struct Source {
    Eigen::Vector3d at;
    double strength;  ///< n_x dS/(4π) [m^2]
    double core;      ///< Square of a distance within which it is spread [m^2].
  };
  std::vector<Source> sources;
  for (const Face& face : faces_) {
    const auto& [a, b, c] = face.corners;
    const double area =
        std::abs((x_[b] - x_[a]) * (z_[c] - z_[a]) - (x_[c] - x_[a]) * (z_[b] - z_[a])) / 2;
    sources.push_back(
        {.at = {(x_[a] + x_[b] + x_[c]) / 3, parts_[face.part].y, (z_[a] + z_[b] + z_[c]) / 3},
         .strength = -face.source / (4 * std::numbers::pi),
         .core = kCore * area});
  }
  std::vector<double> forces(panels_.size());
  parallel_for(panels_.size(), [&](std::size_t i) {
    double along = 0;  // φ_x
    for (const Source& source : sources)
      for (const double side : {1, -1}) {
        const Eigen::Vector3d r =
            panels_[i].at - Eigen::Vector3d(source.at.x(), source.at.y(), side * source.at.z());
        const double square = r.squaredNorm() + source.core;
        along += source.strength * r.x() / (square * std::sqrt(square));
      }
    forces[i] = -along * panels_[i].rise;
  });
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  double sum = 0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    sum += forces[i];
    moment += forces[i] * panels_[i].at.head<2>();
  }
  if (!(sum < 0)) return {};
  const Eigen::Vector2d at = moment / sum;
  return {.area = -sum,
          .centre = {along_.x() * at.x() - along_.y() * at.y(),
                     along_.y() * at.x() + along_.x() * at.y()}};
}

WaveResistance wave_resistance(const ThinShip& ship, double gravity) {
  WaveResistance result;
  for (double froude = kLeastFroude; froude < kLargestFroude;) {
    result.speeds.push_back(froude * std::sqrt(gravity * ship.length()));
    const double step = froude < kLowFroude ? 2 * kHumpStep : kHumpStep;
    froude += std::min(kLargestFroudeStep, step * froude * froude * froude / 2);
  }
  result.speeds.push_back(kLargestFroude * std::sqrt(gravity * ship.length()));
  result.suction = ship.suction();
  result.forces.resize(result.speeds.size());
  parallel_for(result.speeds.size(), [&](std::size_t i) {
    result.forces[i] = ship.resistance(result.speeds[i], gravity);
  });
  return result;
}

}  // namespace hydro
