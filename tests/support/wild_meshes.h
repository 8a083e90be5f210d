#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hydro/mesh/mending/mend.h"
#include "hydro/mesh/mesh_union.h"
#include "tests/support/meshes.h"

/// @file
/// Meshes with the faults that mesh files of users have, with the volume that is right.

namespace support {

/// A faulty mesh, what mends it, and the volume that it then has [m^3].
struct WildMesh {
  std::string name;
  hydro::TriMesh mesh;
  hydro::MendOptions options;
  double volume;
};

/// The mesh with three vertices of its own for each face, as STL files have it.
inline hydro::TriMesh soup(const hydro::TriMesh& mesh) {
  hydro::TriMesh soup{Eigen::Matrix3Xd(3, 3 * mesh.face_count()),
                      Eigen::Matrix3Xi(3, mesh.face_count())};
  for (int f = 0; f < mesh.face_count(); ++f)
    for (int i = 0; i < 3; ++i) {
      soup.vertices.col(3 * f + i) = mesh.vertices.col(mesh.faces(i, f));
      soup.faces(i, f) = 3 * f + i;
    }
  return soup;
}

inline hydro::TriMesh without(const hydro::TriMesh& mesh,
                              const std::function<bool(const Eigen::Vector3d& middle)>& dropped) {
  hydro::TriMesh rest = mesh;
  Eigen::Index count = 0;
  for (const auto& face : mesh.faces.colwise()) {
    const Eigen::Vector3d middle = mesh.vertices(Eigen::all, face).rowwise().mean();
    if (!dropped(middle)) rest.faces.col(count++) = face;
  }
  rest.faces.conservativeResize(3, count);
  return rest;
}

inline hydro::TriMesh with_faces(hydro::TriMesh mesh, const std::vector<Eigen::Vector3i>& faces) {
  for (const Eigen::Vector3i& face : faces) {
    mesh.faces.conservativeResize(3, mesh.face_count() + 1);
    mesh.faces.rightCols(1) = face;
  }
  return mesh;
}

inline hydro::TriMesh box_at(const Eigen::Vector3d& size, const Eigen::Vector3d& middle,
                             int divisions = 1) {
  return hydro::translated(hydro::make_box(size, divisions), middle);
}

/// A box of 4 x 2 x 1 m, from z = 0 up, whose top and bottom are one quad each and whose long sides
/// have a vertex more in the middle of their upper edge: two T-junctions, made of one vertex each.
inline hydro::TriMesh box_with_t_junctions() {
  hydro::TriMesh mesh = box_at({4, 2, 1}, {0, 0, 0.5});
  // Splits the side faces at y = ±1 with an edge on the top, and not the faces of the top.
  const Eigen::Index count = mesh.face_count();
  for (Eigen::Index f = 0; f < count; ++f) {
    const Eigen::Vector3i face = mesh.faces.col(f);
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d a = mesh.vertices.col(face[i]);
      const Eigen::Vector3d b = mesh.vertices.col(face[(i + 1) % 3]);
      const Eigen::Vector3d c = mesh.vertices.col(face[(i + 2) % 3]);
      if (a.z() != 1 || b.z() != 1 || a.y() != b.y() || c.y() != a.y()) continue;
      mesh.vertices.conservativeResize(3, mesh.vertex_count() + 1);
      mesh.vertices.rightCols(1) = (a + b) / 2;
      const int middle = static_cast<int>(mesh.vertex_count()) - 1;
      mesh.faces.col(f) << face[i], middle, face[(i + 2) % 3];
      mesh = with_faces(mesh, {{middle, face[(i + 1) % 3], face[(i + 2) % 3]}});
    }
  }
  return mesh;
}

/// All kinds. Those that have no right answer by themselves come with the options that choose one.
inline std::vector<WildMesh> wild_meshes() {
  using Eigen::Vector3d;
  using hydro::MendOptions;
  using hydro::TriMesh;
  std::vector<WildMesh> all;
  const auto add = [&](std::string name, TriMesh mesh, MendOptions options, double volume) {
    all.push_back({std::move(name), std::move(mesh), options, volume});
  };
  const TriMesh box = box_at({4, 2, 1}, {0, 0, 0.5}, 4);
  const auto top = [](const Vector3d& p) { return p.z() > 1 - 1e-9; };
  const auto bottom = [](const Vector3d& p) { return p.z() < 1e-9; };

  add("triangle soup", soup(box), {}, 8);
  TriMesh cracked = soup(hydro::make_icosphere(1, 3));
  Random random(5);
  const double sphere = hydro::mended(hydro::make_icosphere(1, 3), {}).report.volume;
  for (auto v : cracked.vertices.colwise()) v += random.vector(4e-6);
  add("hair cracks", cracked, {}, sphere);
  for (auto v : cracked.vertices.colwise()) v += random.vector(1e-4);
  add("wide cracks", cracked, {.weld = 1e-3}, sphere);
  add("T-junctions", box_with_t_junctions(), {}, 8);
  add("inside out", hydro::flipped(box), {}, 8);
  TriMesh mixed = box;
  for (Eigen::Index f = 0; f < mixed.face_count(); f += 3)
    mixed.faces.col(f).tail<2>().reverseInPlace();
  add("mixed orientation", mixed, {}, 8);
  add("one part of two inside out", united(box, hydro::flipped(box_at({1, 1, 1}, {5, 0, 0.5}))), {},
      9);
  add("half hull, open at the plane",
      without(box_at({4, 1, 1}, {0, 0.5, 0.5}, 4), [](const Vector3d& p) { return p.y() < 1e-9; }),
      {.mirror = 1}, 8);
  add("half hull, closed at the plane", box_at({4, 1, 1}, {0, 0.5, 0.5}, 4), {.mirror = 1}, 8);
  add("half hull without a deck",
      without(box_at({4, 1, 1}, {0, 0.5, 0.5}, 4),
              [&](const Vector3d& p) { return p.y() < 1e-9 || top(p); }),
      {.cap = true, .mirror = 1}, 8);
  add("half of a pair of hulls", box_at({4, 0.5, 1}, {0, 1, 0.5}, 2), {.mirror = 1}, 4);
  add("open top", without(box, top), {.cap = true}, 8);
  add("open top and bottom", without(box, [&](const Vector3d& p) { return top(p) || bottom(p); }),
      {.cap = true}, 8);
  const TriMesh tube =
      united(box_at({2, 2, 1}, {0, 0, 0.5}, 2), hydro::flipped(box_at({1, 1, 1}, {0, 0, 0.5}, 3)));
  add("open wall of a tube", without(tube, [&](const Vector3d& p) { return top(p) || bottom(p); }),
      {.cap = true}, 3);
  add("a triangle is missing",
      without(box,
              [](const Vector3d& p) { return (p - Vector3d(2, 0.1666, 0.4166)).norm() < 0.09; }),
      {.cap = true}, 8);
  add("repeated faces", with_faces(box, {box.faces.col(0), box.faces.col(7), box.faces.col(7)}), {},
      8);
  add("every face drawn from both sides", united(box, hydro::flipped(box)), {}, 8);
  TriMesh sliver = box_with_t_junctions();
  for (int v = 8; v < 10; ++v) {
    // Fills the gap beside a T-junction by a face without area.
    const double side = sliver.vertices(1, v);
    std::vector<int> ends;
    for (int k = 0; k < 8; ++k)
      if (sliver.vertices(1, k) == side && sliver.vertices(2, k) == 1) ends.push_back(k);
    sliver = with_faces(sliver, {{ends[0], v, ends[1]}});
  }
  add("faces without area", sliver, {}, 8);
  add("two overlapping parts", united(box, box_at({1, 1, 2}, {0.3, 0.2, 1.1})), {.unite = true},
      8 + 1.1);
  add("overlapping parts, flush at a side", united(box, box_at({1, 1, 2}, {0.5, 0.5, 1.1})),
      {.unite = true}, 8 + 1.1);
  add("a mast through two decks",
      united(united(box, box_at({4, 2, 0.5}, {0, 0, 2.25})),
             hydro::translated(hydro::make_cylinder(0.2, 4, 24, 3), {0.1, 0.07, 2})),
      {.unite = true},
      8 + 4 + hydro::mended(hydro::make_cylinder(0.2, 4, 24, 3), {}).report.volume * 2.5 / 4);
  add("a box on a box", united(box, box_at({1, 1, 1}, {0.3, 0.2, 1.5})), {.unite = true}, 9);
  add("boxes that share a face",
      united(box_at({1, 1, 1}, {0.5, 0, 0.5}), box_at({1, 1, 1}, {-0.5, 0, 0.5})), {}, 2);
  add("a part inside another, as a cavity", united(box, box_at({1, 1, 0.5}, {0.3, 0.2, 0.5})), {},
      7.5);
  add("a part inside another, as a fitting", united(box, box_at({1, 1, 0.5}, {0.3, 0.2, 0.5})),
      {.unite = true}, 8);
  const TriMesh halves =
      hydro::mended(united(box_at({2, 2, 1}, {-1, 0, 0.5}, 2), box_at({2, 2, 1}, {1, 0, 0.5}, 2)),
                    {})
          .mesh;
  TriMesh wall = soup(halves);
  const TriMesh bulkhead =
      without(box_at({2, 2, 1}, {-1, 0, 0.5}, 2), [](const Vector3d& p) { return p.x() < -1e-9; });
  add("a bulkhead between the walls", united(wall, soup(bulkhead)), {}, 8);
  add("open shell of a plate", without(box, top), {.thickness = 0.1}, 8 - 3.8 * 1.8 * 0.9);
  return all;
}

}  // namespace support
