#include "tests/support/reference_loads.h"

#include <Eigen/Geometry>
#include <cmath>

#include "hydro/loads/viscous_drag.h"

namespace support {
namespace {

struct GaussPoint {
  long double x, weight;
};

/// Six-point Gauss-Legendre rule on 0 … 1.
std::vector<GaussPoint> gauss() {
  const long double x[] = {0.2386191860831969086305017L, 0.6612093864662645136613996L,
                           0.9324695142031520278123016L};
  const long double w[] = {0.4679139345726910473898703L, 0.3607615730481386075698335L,
                           0.1713244923791703450402961L};
  std::vector<GaussPoint> points;
  for (int i = 0; i < 3; ++i) {
    points.push_back({(1 - x[i]) / 2, w[i] / 2});
    points.push_back({(1 + x[i]) / 2, w[i] / 2});
  }
  return points;
}

Vector3l integrate_triangle(const Vector3l& a, const Vector3l& b, const Vector3l& c,
                            const std::function<Vector3l(const Vector3l&)>& f, int splits) {
  static const std::vector<GaussPoint> points = gauss();
  const long double twice_area = (b - a).cross(c - a).norm();
  Vector3l sum = Vector3l::Zero();
  for (int i = 0; i < splits; ++i) {
    for (int j = 0; j < splits; ++j) {
      for (const GaussPoint& p : points) {
        for (const GaussPoint& q : points) {
          const long double u = (i + p.x) / splits;
          const long double v = (j + q.x) / splits;
          const Vector3l r = a + u * (b - a) + u * v * (c - b);
          sum += p.weight * q.weight * u * f(r);
        }
      }
    }
  }
  return twice_area / (splits * splits) * sum;
}

}  // namespace

Polygon clip(const Polygon& polygon, const std::function<long double(const Vector3l&)>& f) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3l& a = polygon[i];
    const Vector3l& b = polygon[(i + 1) % polygon.size()];
    const long double fa = f(a);
    const long double fb = f(b);
    if (fa >= 0) kept.push_back(a);
    if ((fa > 0 && fb < 0) || (fa < 0 && fb > 0)) kept.push_back(a + fa / (fa - fb) * (b - a));
  }
  return kept.size() < 3 ? Polygon{} : kept;
}

Vector3l integrate(const Polygon& polygon, const std::function<Vector3l(const Vector3l&)>& f,
                   int splits) {
  Vector3l sum = Vector3l::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sum += integrate_triangle(polygon[0], polygon[i - 1], polygon[i], f, splits);
  return sum;
}

hydro::Loads reference_loads(const hydro::TriMesh& mesh_B, const hydro::BodyState& state,
                             const hydro::Sea& sea, const hydro::Coefficients& coefficients,
                             int viscous_splits) {
  const long double rho = sea.density;
  const Vector3l v0 = (state.linear_velocity - sea.current).cast<long double>();
  const Vector3l w = state.angular_velocity.cast<long double>();
  const Eigen::Matrix<long double, 3, 3> R =
      state.orientation.cast<long double>().toRotationMatrix();
  const Eigen::Matrix<long double, 3, 3> K =
      R * coefficients.drag_shape.cast<long double>() * R.transpose();
  const long double level =
      static_cast<long double>(sea.level) - static_cast<long double>(state.position.z());
  hydro::Loads loads;
  for (Eigen::Index face = 0; face < mesh_B.face_count(); ++face) {
    Polygon panel;
    for (int i = 0; i < 3; ++i)
      panel.push_back(R * mesh_B.vertices.col(mesh_B.faces(i, face)).cast<long double>());
    const Vector3l n = (panel[1] - panel[0]).cross(panel[2] - panel[0]).normalized();
    const auto depth = [&](const Vector3l& r) { return level - r.z(); };
    const auto velocity = [&](const Vector3l& r) -> Vector3l { return v0 + w.cross(r); };
    const auto normal_speed = [&](const Vector3l& r) { return velocity(r).dot(n); };
    const auto drag_speed = [&](const Vector3l& r) -> long double {
      return (K * v0 + w.cross(r)).dot(n);
    };
    const auto tangential = [&](const Vector3l& r) -> Vector3l {
      return velocity(r) - normal_speed(r) * n;
    };
    const Polygon wet = clip(panel, depth);
    const auto add = [&](hydro::Wrench& load, const Polygon& where, const auto& traction,
                         int splits) {
      load.force += integrate(where, traction, splits).template cast<double>();
      const auto moment = [&](const Vector3l& r) -> Vector3l { return r.cross(traction(r)); };
      load.moment += integrate(where, moment, splits).template cast<double>();
    };
    if (coefficients.buoyancy) {
      const auto traction = [&](const Vector3l& r) -> Vector3l {
        return -rho * sea.gravity * depth(r) * n;
      };
      add(loads.buoyancy, wet, traction, 1);
    }
    for (const int sign : {1, -1}) {
      const double c_p =
          sign > 0 ? coefficients.pressure_drag.front : coefficients.pressure_drag.back;
      const auto drag = [&](const Vector3l& r) -> Vector3l {
        return -rho / 2 * c_p * sign * drag_speed(r) * drag_speed(r) * n;
      };
      const Polygon part = clip(wet, [&](const Vector3l& r) { return sign * drag_speed(r); });
      add(loads.pressure_drag, part, drag, 1);
    }
    const auto lift = [&](const Vector3l& r) -> Vector3l {
      return -rho / 2 * coefficients.lift * tangential(r).squaredNorm() * n;
    };
    add(loads.lift, wet, lift, 1);
    const auto viscous = [&](const Vector3l& r) -> Vector3l {
      const Vector3l t = tangential(r);
      const long double speed = t.norm();
      return -rho / 2 *
             hydro::viscous_coefficient(coefficients.viscous_drag, static_cast<double>(speed)) *
             speed * t;
    };
    if (viscous_splits > 0) add(loads.viscous_drag, wet, viscous, viscous_splits);
    const auto unit = [](const Vector3l&) -> Vector3l { return Vector3l::UnitX(); };
    loads.wetted_area += static_cast<double>(integrate(wet, unit).x());
    const auto flux = [&](const Vector3l& r) -> Vector3l {
      return -depth(r) * n.z() * Vector3l::UnitX();
    };
    loads.displaced_volume += static_cast<double>(integrate(wet, flux).x());
  }
  loads.pressure_drag.force = K.cast<double>() * loads.pressure_drag.force;
  return loads;
}

}  // namespace support
