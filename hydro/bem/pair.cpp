#include "hydro/bem/pair.h"

#include <algorithm>
#include <cmath>

#include "hydro/bem/quadrature.h"

namespace hydro::bem {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;
using Eigen::Vector3d;

/// Pieces that are no larger than this times their distance are not halved. As kNear and kFar, it
/// is no simple fraction.
constexpr double kClose = 1.0137;

/// Halvings of an element beside one that is very near.
constexpr int kDeepest = 7;

/// Adds the integrals over one piece of the first element, closed form over the second.
void add_piece(const Corners& piece, double area, const Rule& rule, const Element& b,
               PairIntegrals& sum) {
  for (const Node& node : rule) {
    const Vector3d x = point(piece, node);
    const Potentials inner = potentials(b, x);
    const double weight = area * node.weight;
    sum.single += weight * inner.single;
    sum.first += weight * inner.single * x;
    sum.second += weight * (inner.first + inner.single * x);
  }
}

double size(const Corners& c) {
  const Vector3d middle = (c[0] + c[1] + c[2]) / 3;
  return std::max({(c[0] - middle).norm(), (c[1] - middle).norm(), (c[2] - middle).norm()});
}

/// As add_piece, on halves where the second element is nearer than the piece's size.
void add_near(const Corners& c, double area, const Element& b, int depth, PairIntegrals& sum) {
  const Vector3d middle = (c[0] + c[1] + c[2]) / 3;
  if (depth == kDeepest || size(c) <= kClose * distance(b, middle)) {
    add_piece(c, area, rule_of_degree_5(), b, sum);
    return;
  }
  std::size_t longest = 0;
  for (std::size_t e = 1; e < 3; ++e)
    if ((c[(e + 1) % 3] - c[e]).norm() > (1 + 1e-6) * (c[(longest + 1) % 3] - c[longest]).norm())
      longest = e;
  const Vector3d& start = c[longest];
  const Vector3d& end = c[(longest + 1) % 3];
  const Vector3d& top = c[(longest + 2) % 3];
  const Vector3d half = 0.5 * (start + end);
  add_near({start, half, top}, area / 2, b, depth + 1, sum);
  add_near({half, end, top}, area / 2, b, depth + 1, sum);
}

PairIntegrals product(const Element& a, const Element& b, const Rule& rule) {
  PairIntegrals sum;
  for (const Node& i : rule) {
    const Vector3d x = point(a.corners, i);
    for (const Node& j : rule) {
      const Vector3d y = point(b.corners, j);
      const double value = a.area * i.weight * b.area * j.weight / (x - y).norm();
      sum.single += value;
      sum.first += value * x;
      sum.second += value * y;
    }
  }
  return sum;
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
    add_piece({a.corners[e], a.corners[(e + 1) % 3], a.centroid}, a.area / 3, rule_at_edge(), a,
              sum);
  sum.single = self_integral(a);
  sum.second = sum.first;
  return sum;
}

/// The corners of `a` turned so that the common edge or corner comes first.
Corners turned(const Element& a, const std::array<int, 3>& shared, int count) {
  for (std::size_t i = 0; i < 3; ++i) {
    const bool here = shared[i] >= 0 && (count == 1 || shared[(i + 1) % 3] >= 0);
    if (here) return {a.corners[i], a.corners[(i + 1) % 3], a.corners[(i + 2) % 3]};
  }
  return a.corners;
}

}  // namespace

PairIntegrals pair_integrals(const Element& a, const Element& b, const std::array<int, 3>& shared) {
  const auto count = std::count_if(shared.begin(), shared.end(), [](int i) { return i >= 0; });
  if (count == 3) return self(a);
  PairIntegrals sum;
  if (count > 0) {
    const Rule& rule = count == 2 ? rule_at_edge() : rule_at_corner();
    add_piece(turned(a, shared, static_cast<int>(count)), a.area, rule, b, sum);
    return sum;
  }
  if (is_far(a, b)) return product(a, b, rule_of_degree_2());
  const double reach = kNear * (a.radius + b.radius);
  if ((a.centroid - b.centroid).squaredNorm() > reach * reach)
    return product(a, b, rule_of_degree_4());
  add_near(a.corners, a.area, b, 0, sum);
  return sum;
}

}  // namespace hydro::bem
