#include "app/assembly/start_warnings.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "engine/contacts/broad_phase.h"
#include "engine/motion/locks.h"
#include "hydro/mesh/mesh_overlap.h"
#include "hydro/mesh/primitives.h"

namespace assembly {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Index;
using Eigen::Vector3d;
using hydro::TriMesh;

/// Part of a body's size to which it may overlap: contacts part such bodies gently.
constexpr double kGentleOverlap = 0.05;

/// Triangles around the sphere of a body that collides as one.
constexpr int kSphereSlices = 24;

/// Number of lines, after which the others are only counted.
constexpr std::size_t kMostLines = 10;

/// Returns the shape by which a body collides, at its start in W, shrunk by kGentleOverlap.
TriMesh shape_W(const engine::BodySpec& body) {
  const AlignedBox3d box = hydro::bounding_box(body.mesh_B);
  TriMesh mesh = body.mesh_B;
  if (body.collision == engine::CollisionShape::box)
    mesh = hydro::translated(hydro::make_box(box.sizes()), box.center());
  if (body.collision == engine::CollisionShape::sphere) {
    const double radius =
        (body.mesh_B.vertices.colwise() - box.center()).colwise().norm().maxCoeff();
    mesh = hydro::translated(hydro::make_sphere(radius, kSphereSlices, kSphereSlices / 2),
                             box.center());
  }
  mesh.vertices = (1 - kGentleOverlap) * (mesh.vertices.colwise() - box.center());
  mesh.vertices.colwise() += box.center();
  mesh.vertices = (body.initial.orientation.toRotationMatrix() * mesh.vertices).colwise() +
                  body.initial.position;
  return mesh;
}

/// Returns the faces of a mesh whose boxes meet a box, relative to its centre.
TriMesh cut_out(const TriMesh& mesh, const AlignedBox3d& box) {
  TriMesh part{.vertices = mesh.vertices.colwise() - box.center(), .faces = mesh.faces};
  Index count = 0;
  for (const auto& face : mesh.faces.colwise()) {
    AlignedBox3d own;
    for (const int v : face) own.extend(mesh.vertices.col(v));
    if (own.intersects(box)) part.faces.col(count++) = face;
  }
  part.faces.conservativeResize(3, count);
  return part;
}

Index cuts_of(const TriMesh& mesh) {
  return mesh.face_count() == 0 ? 0 : hydro::find_overlaps(mesh, hydro::FaceTree(mesh)).count;
}

/// Returns true if faces of one mesh cut through faces of the other.
bool cut(const TriMesh& a, const TriMesh& b, const AlignedBox3d& box) {
  const TriMesh in_a = cut_out(a, box), in_b = cut_out(b, box);
  if (in_a.face_count() == 0 || in_b.face_count() == 0) return false;
  TriMesh both{.vertices = Eigen::Matrix3Xd(3, in_a.vertex_count() + in_b.vertex_count()),
               .faces = Eigen::Matrix3Xi(3, in_a.face_count() + in_b.face_count())};
  both.vertices << in_a.vertices, in_b.vertices;
  both.faces << in_a.faces, (in_b.faces.array() + static_cast<int>(in_a.vertex_count())).matrix();
  return cuts_of(both) > cuts_of(in_a) + cuts_of(in_b);
}

/// Returns true if the first vertex of a mesh lies inside another.
bool begins_inside(const TriMesh& mesh, const TriMesh& other) {
  return hydro::FaceTree(other).contains(mesh.vertices.col(mesh.faces(0, 0)));
}

bool overlap(const TriMesh& a, const TriMesh& b) {
  const AlignedBox3d box = hydro::bounding_box(a).intersection(hydro::bounding_box(b));
  return !box.isEmpty() && (cut(a, b, box) || begins_inside(a, b) || begins_inside(b, a));
}

bool overlaps_ground(const TriMesh& mesh, const engine::Ground& ground) {
  if (const auto* plane = std::get_if<engine::PlaneGround>(&ground))
    return mesh.vertices.row(2).minCoeff() < plane->z;
  const auto* terrain = std::get_if<engine::MeshGround>(&ground);
  if (!terrain) return false;
  // A sheet has no inside: only what cuts it is found.
  return cut(mesh, terrain->mesh_W, hydro::bounding_box(mesh));
}

bool jointed(const engine::SimulationSpec& spec, engine::BodyId a, engine::BodyId b) {
  return std::any_of(spec.joints.begin(), spec.joints.end(), [&](const auto& joint) {
    return (joint.first == a && joint.second == b) || (joint.first == b && joint.second == a);
  });
}

std::string line_of(const engine::SimulationSpec& spec, std::size_t body,
                    const std::string& other) {
  return fmt::format(
      "bodies[{}].position: '{}' overlaps {} at the start, and contacts push them apart; expected "
      "a start without overlap, or collision: none",
      body, spec.bodies[body].name, other);
}

}  // namespace

std::vector<std::string> start_warnings(const engine::SimulationSpec& spec) {
  std::vector<TriMesh> shapes;
  std::vector<AlignedBox3d> boxes;
  for (const engine::BodySpec& body : spec.bodies) {
    const bool collides = body.collision != engine::CollisionShape::none;
    shapes.push_back(collides ? shape_W(body) : TriMesh{});
    boxes.push_back(collides ? hydro::bounding_box(shapes.back()) : AlignedBox3d());
  }
  std::vector<std::string> lines;
  const auto fixed = [&](std::size_t i) { return engine::immovable(spec.bodies[i].locked); };
  for (const auto& [a, b] : engine::overlapping(boxes)) {
    const auto first = static_cast<engine::BodyId>(a), second = static_cast<engine::BodyId>(b);
    if ((fixed(a) && fixed(b)) || jointed(spec, first, second)) continue;
    if (overlap(shapes[a], shapes[b]))
      lines.push_back(
          line_of(spec, fixed(b) ? a : b, fmt::format("'{}'", spec.bodies[fixed(b) ? b : a].name)));
  }
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (!boxes[i].isEmpty() && !fixed(i) &&
        !jointed(spec, static_cast<engine::BodyId>(i), engine::kWorld) &&
        overlaps_ground(shapes[i], spec.ground))
      lines.push_back(line_of(spec, i, "the ground"));
  if (lines.size() <= kMostLines) return lines;
  const std::size_t more = lines.size() - kMostLines;
  lines.resize(kMostLines);
  lines.push_back(fmt::format("bodies: {} more overlap at the start", more));
  return lines;
}

}  // namespace assembly
