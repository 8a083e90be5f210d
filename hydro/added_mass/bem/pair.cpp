#include "hydro/added_mass/bem/pair.h"

#include <algorithm>
#include <cmath>

#include "hydro/added_mass/bem/quadrature.h"

namespace hydro::bem {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;
using Eigen::Vector3d;

/// Size over distance up to which pieces are not halved. Like kNear and kFar, it is no simple
/// fraction.
constexpr double kClose = 1.0137;

/// Largest number of halvings of an element beside a very near one.
constexpr int kDeepest = 7;

/// Adds the integrals over one piece of `a`, with the closed form over `b`.
void add_piece(const Element& a, const Corners& piece, double area, const Rule& rule,
               const Element& b, PairIntegrals& sum) {
  for (const Node& node : rule) {
    const Vector3d x = point(piece, node);
    const PotentialMoments inner = potential_moments(b, x);
    const Vector3d hats = area * node.weight * hats_at(a, x);
    const Vector3d below = hats_at(b, x);
    Vector3d inside;  // ∫ λ_j/r
    Vector3d raised;  // ∫ λ_j n·y/r with the normal of a
    const double foot = a.normal.dot(x) + b.normal.dot(b.centroid - x) * a.normal.dot(b.normal);
    const double across =
        a.normal.dot(inner.first) - b.normal.dot(inner.first) * a.normal.dot(b.normal);
    const Vector3d bent = inner.second * a.normal;
    for (std::size_t j = 0; j < 3; ++j) {
      const auto k = static_cast<Eigen::Index>(j);
      inside[k] = below[k] * inner.single + b.slopes[j].dot(inner.first);
      raised[k] = foot * inside[k] + below[k] * across + b.slopes[j].dot(bent);
    }
    sum.hats += hats * inside.transpose();
    sum.rise += (b.normal.dot(x) * inner.single) * hats;
    sum.other_rise += hats.sum() * raised;
  }
}

double size(const Corners& c) {
  const Vector3d middle = (c[0] + c[1] + c[2]) / 3;
  return std::max({(c[0] - middle).norm(), (c[1] - middle).norm(), (c[2] - middle).norm()});
}

/// Relative difference of areas below which elements count as equal: the choice of the larger must
/// not depend on round-off.
constexpr double kSameArea = 1e-9;

void add_near(const Element& a, const Corners& c, double area, const Element& b, int depth,
              PairIntegrals& sum);

/// Splits the piece in two at the middle of the longest edge, or in four if no edge is longer than
/// all others.
void add_parts(const Element& a, const Corners& c, double area, const Element& b, int depth,
               PairIntegrals& sum) {
  std::array<double, 3> lengths;
  for (std::size_t e = 0; e < 3; ++e) lengths[e] = (c[(e + 1) % 3] - c[e]).norm();
  const auto e =
      static_cast<std::size_t>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
  const Vector3d &start = c[e], &end = c[(e + 1) % 3], &top = c[(e + 2) % 3];
  const Vector3d half = 0.5 * (start + end);
  if (lengths[e] > (1 + kSameLength) * std::max(lengths[(e + 1) % 3], lengths[(e + 2) % 3])) {
    add_near(a, {start, half, top}, area / 2, b, depth + 1, sum);
    add_near(a, {half, end, top}, area / 2, b, depth + 1, sum);
    return;
  }
  const Vector3d right = 0.5 * (end + top), left = 0.5 * (top + start);
  add_near(a, {start, half, left}, area / 4, b, depth + 2, sum);
  add_near(a, {half, end, right}, area / 4, b, depth + 2, sum);
  add_near(a, {left, right, top}, area / 4, b, depth + 2, sum);
  add_near(a, {right, left, half}, area / 4, b, depth + 2, sum);
}

/// Adds a piece, in parts where the second element is nearer than the piece's size.
void add_near(const Element& a, const Corners& c, double area, const Element& b, int depth,
              PairIntegrals& sum) {
  const Vector3d middle = (c[0] + c[1] + c[2]) / 3;
  if (depth >= kDeepest || size(c) <= kClose * distance(b, middle)) {
    add_piece(a, c, area, rule_of_degree_5(), b, sum);
  } else {
    add_parts(a, c, area, b, depth, sum);
  }
}

/// (4A²/3) Σ ln(s/(s − l))/l over the edges' lengths l, s half their sum (Eibert and Hansen, 1995).
double self_integral(const Element& a) {
  const double half = 0.5 * (a.lengths[0] + a.lengths[1] + a.lengths[2]);
  double sum = 0;
  for (const double length : a.lengths) sum -= std::log1p(-length / half) / length;
  return 4 * a.area * a.area / 3 * sum;
}

PairIntegrals self(const Element& a) {
  PairIntegrals sum;
  for (std::size_t e = 0; e < 3; ++e)
    add_piece(a, {a.corners[e], a.corners[(e + 1) % 3], a.centroid}, a.area / 3, rule_at_edge(), a,
              sum);
  sum.hats = (0.5 * (sum.hats + sum.hats.transpose())).eval();
  sum.hats *= self_integral(a) / sum.hats.sum();
  sum.rise = a.normal.dot(a.centroid) * sum.hats.rowwise().sum();
  sum.other_rise = sum.rise;
  return sum;
}

/// The corners of `a`, rotated so that the common edge or corner is first.
Corners turned(const Element& a, const std::array<int, 3>& shared, int count) {
  for (std::size_t i = 0; i < 3; ++i) {
    const bool here = shared[i] >= 0 && (count == 1 || shared[(i + 1) % 3] >= 0);
    if (here) return {a.corners[i], a.corners[(i + 1) % 3], a.corners[(i + 2) % 3]};
  }
  return a.corners;
}

}  // namespace

PairIntegrals integrals_from(const Element& a, const Element& b, const std::array<int, 3>& shared) {
  const auto count = std::count_if(shared.begin(), shared.end(), [](int i) { return i >= 0; });
  if (count == 3) return self(a);
  PairIntegrals sum;
  if (count > 0) {
    const Rule& rule = count == 2 ? rule_at_edge() : rule_at_corner();
    add_piece(a, turned(a, shared, static_cast<int>(count)), a.area, rule, b, sum);
  } else {
    add_near(a, a.corners, a.area, b, 0, sum);
  }
  return sum;
}

PairIntegrals pair_integrals(const Element& a, const Element& b, const std::array<int, 3>& shared) {
  std::array<int, 3> back = {-1, -1, -1};
  for (std::size_t i = 0; i < 3; ++i)
    if (shared[i] >= 0) back[static_cast<std::size_t>(shared[i])] = static_cast<int>(i);
  const bool same = std::count(shared.begin(), shared.end(), -1) == 0;
  if (same || a.area < (1 - kSameArea) * b.area) return integrals_from(a, b, shared);
  const PairIntegrals other = turned(integrals_from(b, a, back));
  if (b.area < (1 - kSameArea) * a.area) return other;
  const PairIntegrals one = integrals_from(a, b, shared);
  return {(one.hats + other.hats) / 2, (one.rise + other.rise) / 2,
          (one.other_rise + other.other_rise) / 2};
}

}  // namespace hydro::bem
