#include "hydro/added_mass/bem/quadrature.h"

#include <cmath>
#include <numbers>

namespace hydro::bem {
namespace {

/// Adds the points of one orbit: (a, a, 1 − 2a) and its two cyclic permutations.
void add_orbit(double a, double weight, Rule& rule) {
  for (int i = 0; i < 3; ++i) {
    Eigen::Vector3d at = Eigen::Vector3d::Constant(a);
    at[i] = 1 - 2 * a;
    rule.push_back({at, weight});
  }
}

template <std::size_t N>
HatRule<N> hat_rule(const Rule& rule) {
  HatRule<N> result;
  for (std::size_t k = 0; k < N; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      result.at[k][i] = rule[k].at[static_cast<Eigen::Index>(i)];
      result.hats[k][i] = rule[k].weight * result.at[k][i];
    }
  }
  return result;
}

/// Gauss–Legendre points and weights on [0, 1], by Newton's method on the Legendre polynomial.
std::vector<std::pair<double, double>> gauss(int count) {
  std::vector<std::pair<double, double>> nodes;
  for (int i = 0; i < count; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
    double slope = 1;
    for (int step = 0; step < 20; ++step) {
      double p = 1, previous = 0;
      for (int k = 1; k <= count; ++k) {
        const double next = ((2 * k - 1) * x * p - (k - 1) * previous) / k;
        previous = p;
        p = next;
      }
      slope = count * (x * p - previous) / (x * x - 1);
      x -= p / slope;
    }
    nodes.emplace_back(0.5 * (1 - x), 1 / ((1 - x * x) * slope * slope));
  }
  return nodes;
}

constexpr int kGraded = 6;

Rule make_rule_at_edge() {
  Rule rule;
  for (const auto& [u, u_weight] : gauss(kGraded)) {
    for (const auto& [v, v_weight] : gauss(kGraded)) {
      const double away = u * u;                 // from edge 0 towards corner 2
      const double along = v * v * (3 - 2 * v);  // from corner 0 to corner 1
      const double weight = 2 * (1 - away) * 2 * u * u_weight * 6 * v * (1 - v) * v_weight;
      rule.push_back({{(1 - away) * (1 - along), (1 - away) * along, away}, weight});
    }
  }
  return rule;
}

Rule make_rule_at_corner() {
  Rule rule;
  for (const auto& [u, u_weight] : gauss(kGraded)) {
    for (const auto& [v, v_weight] : gauss(kGraded)) {
      const double away = u * u;  // from corner 0
      const double weight = 2 * away * 2 * u * u_weight * v_weight;
      rule.push_back({{1 - away, away * (1 - v), away * v}, weight});
    }
  }
  return rule;
}

}  // namespace

const Rule& rule_of_degree_2() {
  static const Rule rule = [] {
    Rule three;
    add_orbit(1.0 / 6, 1.0 / 3, three);
    return three;
  }();
  return rule;
}

const Rule& rule_of_degree_4() {
  static const Rule rule = [] {
    Rule six;  // Dunavant, 1985
    add_orbit(0.445948490915965, 0.223381589678011, six);
    add_orbit(0.091576213509771, 0.109951743655322, six);
    return six;
  }();
  return rule;
}

const Rule& rule_of_degree_5() {
  static const Rule rule = [] {
    const double root = std::sqrt(15.0);
    Rule seven = {{Eigen::Vector3d::Constant(1.0 / 3), 0.225}};  // Radon, 1948
    add_orbit((6 - root) / 21, (155 - root) / 1200, seven);
    add_orbit((6 + root) / 21, (155 + root) / 1200, seven);
    return seven;
  }();
  return rule;
}

const Rule& rule_at_edge() {
  static const Rule rule = make_rule_at_edge();
  return rule;
}

const Rule& rule_at_corner() {
  static const Rule rule = make_rule_at_corner();
  return rule;
}

const HatRule<3>& hat_rule_3() {
  static const HatRule<3> rule = hat_rule<3>(rule_of_degree_2());
  return rule;
}

const HatRule<6>& hat_rule_6() {
  static const HatRule<6> rule = hat_rule<6>(rule_of_degree_4());
  return rule;
}

}  // namespace hydro::bem
