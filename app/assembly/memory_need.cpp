#include "app/assembly/memory_need.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "hydro/mesh/primitives.h"

namespace assembly {
namespace {

/// Bytes per triangle of a body. A run of an icosphere takes 500 of 1.3 million and 475 of 5.2
/// million triangles; a mesh from a file takes some more, whose vertices are repeated.
constexpr double kBodyBytes = 600;

/// Bytes per triangle of compressed interactions, measured at 99,904 triangles (1.3 GB). They grow
/// as F log F.
constexpr double kCompressedBytes = 13'000;
constexpr double kCompressedTriangles = 1e5;

/// Up to so many panels all interactions are stored.
constexpr double kMostStored = 5000;

double square(double x) { return x * x; }

struct Triangles {
  double operator()(const scene::Shapes& s) const {
    double sum = 0;
    for (const scene::PlacedShape& part : s.parts) sum += std::visit(*this, part.shape);
    return sum;
  }
  double operator()(const scene::Mesh&) const { return 0; }
  double operator()(const scene::Box& s) const { return 12 * square(s.divisions); }
  double operator()(const scene::Sphere& s) const { return 2.0 * s.slices * (s.stacks - 1); }
  double operator()(const scene::Icosphere& s) const { return 20 * std::pow(4, s.subdivisions); }
  double operator()(const scene::Ellipsoid& s) const { return 2.0 * s.slices * (s.stacks - 1); }
  double operator()(const scene::Cylinder& s) const {
    const int rings = hydro::cylinder_cap_rings(s.radius, s.height, s.slices, s.stacks);
    return 2.0 * s.slices * (s.stacks + 2.0 * rings - 1);
  }
};

}  // namespace

double triangles_of(const scene::Shape& shape) { return std::visit(Triangles(), shape); }

double body_bytes(double triangles) { return kBodyBytes * triangles; }

double added_mass_bytes(double triangles, const hydro::AddedMassOptions& options) {
  if (options.method == hydro::AddedMassMethod::constant) return 8 * square(triangles);
  if (triangles > kMostStored)
    return kCompressedBytes * triangles * std::log(triangles) / std::log(kCompressedTriangles);
  const double panels = std::max(triangles, static_cast<double>(options.most_panels));
  return 8 * square(2 * panels);
}

}  // namespace assembly
