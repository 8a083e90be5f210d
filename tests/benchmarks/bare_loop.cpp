#include "tests/benchmarks/bare_loop.h"

#ifndef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#endif
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/benchmarks/bare_loop.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace bench::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;

struct V3 {
  V x, y, z;
};
HWY_INLINE V dot(const V3& a, const V3& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, a.z * b.z));
}
HWY_INLINE V3 cross(const V3& a, const V3& b) {
  return {hn::MulSub(a.y, b.z, a.z * b.y), hn::MulSub(a.z, b.x, a.x * b.z),
          hn::MulSub(a.x, b.y, a.y * b.x)};
}
HWY_INLINE V3 minus(const V3& a, const V3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

struct Load {
  V3 force, moment;
};

/// Adds the load of a normal traction with the given weights at the vertices: n Σ w and Σ w r × n.
HWY_INLINE void add(const V3 (&r)[3], const V3& n, const V (&w)[3], Load& load) {
  const V sum = w[0] + w[1] + w[2];
  load.force = {hn::MulAdd(sum, n.x, load.force.x), hn::MulAdd(sum, n.y, load.force.y),
                hn::MulAdd(sum, n.z, load.force.z)};
  const V3 arm = {hn::MulAdd(w[0], r[0].x, hn::MulAdd(w[1], r[1].x, w[2] * r[2].x)),
                  hn::MulAdd(w[0], r[0].y, hn::MulAdd(w[1], r[1].y, w[2] * r[2].y)),
                  hn::MulAdd(w[0], r[0].z, hn::MulAdd(w[1], r[1].z, w[2] * r[2].z))};
  const V3 m = cross(arm, n);
  load.moment = {load.moment.x + m.x, load.moment.y + m.y, load.moment.z + m.z};
}

HWY_INLINE void triangle(const V3 (&r)[3], const V3& up, V below, const V3& v, const V3& omega,
                         Load& buoyancy, Load& drag) {
  const D d;
  const V3 a = cross(minus(r[1], r[0]), minus(r[2], r[0]));
  const V area2 = hn::Sqrt(hn::Max(dot(a, a), hn::Set(d, 1e-300)));
  const V inverse = hn::Set(d, 1) / area2;
  const V3 n = {a.x * inverse, a.y * inverse, a.z * inverse};
  const V3 m = cross(n, omega);
  const V normal = dot(v, n);
  V h[3], u[3];
  for (int i = 0; i < 3; ++i) {
    h[i] = below - dot(up, r[i]);
    u[i] = normal + dot(m, r[i]);
  }
  const V sum = h[0] + h[1] + h[2];
  const V k = area2 * hn::Set(d, 1.0 / 24);
  const V w[3] = {k * (sum + h[0]), k * (sum + h[1]), k * (sum + h[2])};
  add(r, n, w, buoyancy);
  const V s = u[0] + u[1] + u[2];
  const V q = hn::MulAdd(u[0], u[0], hn::MulAdd(u[1], u[1], u[2] * u[2]));
  const V b = hn::Set(d, 0.5) * hn::MulAdd(s, s, q);
  const V c = hn::CopySign(area2 * hn::Set(d, 1.0 / 60), s);
  const V x[3] = {c * hn::MulAdd(u[0], u[0] + s, b), c * hn::MulAdd(u[1], u[1] + s, b),
                  c * hn::MulAdd(u[2], u[2] + s, b)};
  add(r, n, x, drag);
}

void loop(const BareTriangles& t, const double* up, double below, const double* motion,
          double* result) {
  const D d;
  const auto three = [&](const double* from) HWY_ATTR {
    return V3{hn::Set(d, from[0]), hn::Set(d, from[1]), hn::Set(d, from[2])};
  };
  const V3 u = three(up), v = three(motion), omega = three(motion + 3);
  const double* from[3][3];
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis) from[i][axis] = t.r[i][axis].data();
  const V z = hn::Zero(d);
  Load buoyancy{{z, z, z}, {z, z, z}}, drag{{z, z, z}, {z, z, z}};
  for (std::size_t i = 0; i < t.count; i += hn::Lanes(d)) {
    V3 r[3];
    for (int j = 0; j < 3; ++j)
      r[j] = {hn::LoadU(d, from[j][0] + i), hn::LoadU(d, from[j][1] + i),
              hn::LoadU(d, from[j][2] + i)};
    triangle(r, u, hn::Set(d, below), v, omega, buoyancy, drag);
  }
  for (const Load* load : {&buoyancy, &drag}) {
    for (const V3* part : {&load->force, &load->moment}) {
      for (const V* value : {&part->x, &part->y, &part->z})
        *result++ = hn::GetLane(hn::SumOfLanes(d, *value));
    }
  }
}

}  // namespace bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bench {

HWY_EXPORT(loop);

BareTriangles::BareTriangles(const hydro::TriMesh& mesh_B)
    : count((static_cast<std::size_t>(mesh_B.face_count()) + 7) / 8 * 8) {
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis) r[i][axis].resize(count, 0.0);
  for (Eigen::Index face = 0; face < mesh_B.face_count(); ++face)
    for (int i = 0; i < 3; ++i)
      for (int axis = 0; axis < 3; ++axis)
        r[i][axis][face] = mesh_B.vertices(axis, mesh_B.faces(i, face));
}

std::array<double, 12> bare_loop(const BareTriangles& triangles, const Eigen::Vector3d& up,
                                 double below, const hydro::Twist& motion) {
  const double six[6] = {motion.linear.x(),  motion.linear.y(),  motion.linear.z(),
                         motion.angular.x(), motion.angular.y(), motion.angular.z()};
  std::array<double, 12> result;
  HWY_DYNAMIC_DISPATCH(loop)(triangles, up.data(), below, six, result.data());
  return result;
}

}  // namespace bench
#endif
