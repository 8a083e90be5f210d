#include "app/render/interior_look.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "hydro/interior/places.h"
#include "hydro/loads/clip.h"

namespace render {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

/// Collects triangles.
class Collector {
 public:
  void add(const hydro::Panel& panel, const Eigen::Vector3d& heights) {
    for (int i = 0; i < 3; ++i) points_.emplace_back(panel[i].x(), panel[i].y(), heights[i]);
  }
  Triangles triangles() const {
    Triangles all(3, static_cast<Index>(points_.size()));
    for (std::size_t i = 0; i < points_.size(); ++i) all.col(static_cast<Index>(i)) = points_[i];
    return all;
  }

 private:
  std::vector<Vector3d> points_;
};

hydro::Panel panel_of(const hydro::TriMesh& mesh, const Eigen::Matrix3Xd& points, int face) {
  const auto v = mesh.faces.col(face);
  return {points.col(v[0]), points.col(v[1]), points.col(v[2])};
}

}  // namespace

InteriorLook::InteriorLook(const hydro::TriMesh& mesh_B, const Vector3d& up_B,
                           const hydro::BodyState& state, const std::vector<PocketLook>& waters)
    : mesh_B_(mesh_B),
      state_(state),
      points_W_((state.orientation.toRotationMatrix() * mesh_B.vertices).colwise() +
                state.position),
      division_(hydro::find_pockets(mesh_B, up_B)),
      water_(division_.pockets.size(), nullptr) {
  for (const PocketLook& water : waters) {
    const Vector3d at_B = state.orientation.conjugate() * (water.at_W - state.position);
    const int pocket = hydro::pocket_under(mesh_B, division_, at_B, up_B);
    if (pocket != hydro::kSea) water_[pocket] = &water;
  }
}

void InteriorLook::set_water(const ShadedMesh& skin, const hydro::Sea& sea,
                             VertexWater& water) const {
  if (!has_pockets()) return;
  std::vector<int> pocket_of(skin.vertices.cols(), -2);
  for (Index f = 0; f < skin.triangles.cols(); ++f)
    for (const int v : skin.triangles.col(f)) {
      int& pocket = pocket_of[v];
      const int own = division_.pocket_of_face[f];
      pocket = pocket == -2 || pocket == own ? own : hydro::kSea;
    }
  const Eigen::Matrix3d R_WB = state_.orientation.toRotationMatrix();
  // A depth for surfaces that no water wets. Much lower ones would show as a waterline where they
  // meet the outside.
  const double dry = -hydro::bounding_box(mesh_B_).diagonal().norm();
  for (Index v = 0; v < skin.vertices.cols(); ++v) {
    if (pocket_of[v] < 0) continue;
    const PocketLook* own = water_[pocket_of[v]];
    if (own && own->flooded) continue;
    const Vector3d r_W = R_WB * skin.vertices.col(v);
    const double depth = own ? own->level - (state_.position + r_W).z() : dry;
    water.depths[v] = water.heads[v] = depth;
    // Water that moves with the body has no dynamic pressure.
    water.flow.col(v) = state_.linear_velocity + state_.angular_velocity.cross(r_W) - sea.current;
  }
}

Triangles InteriorLook::surfaces() const {
  Collector surfaces;
  for (std::size_t i = 0; i < water_.size(); ++i) {
    if (!water_[i] || water_[i]->flooded) continue;
    const double level = water_[i]->level;
    for (const int f : division_.pockets[i].faces) {
      const hydro::Panel panel = panel_of(mesh_B_, points_W_, f);
      const Vector3d depth(level - panel[0].z(), level - panel[1].z(), level - panel[2].z());
      for (const hydro::PanelPart& wet : hydro::positive_part(panel, depth))
        surfaces.add(wet.panel, Vector3d::Constant(level));
    }
  }
  return surfaces.triangles();
}

/// True if a pocket has a mouth, and all of it is above the sea.
bool InteriorLook::stands_out(int pocket, const hydro::Sea& sea, double time) const {
  bool has_mouth = false;
  for (const hydro::SillEdge& edge : division_.sills) {
    if (edge.pocket != pocket && edge.other != pocket) continue;
    has_mouth = true;
    for (const int v : {edge.from, edge.to}) {
      const Vector3d p = points_W_.col(v);
      if (hydro::surface_height(sea, p.x(), p.y(), time) > p.z()) return false;
    }
  }
  return has_mouth;
}

Triangles InteriorLook::openings(const hydro::Sea& sea, double time) const {
  Collector openings;
  for (std::size_t i = 0; i < water_.size(); ++i) {
    if ((water_[i] && water_[i]->flooded) || !stands_out(static_cast<int>(i), sea, time)) continue;
    for (const int f : division_.pockets[i].faces) {
      const hydro::Panel panel = panel_of(mesh_B_, points_W_, f);
      Vector3d depth;
      for (int k = 0; k < 3; ++k)
        depth[k] = hydro::surface_height(sea, panel[k].x(), panel[k].y(), time) - panel[k].z();
      for (const hydro::PanelPart& wet : hydro::positive_part(panel, depth)) {
        Vector3d heights;
        for (int k = 0; k < 3; ++k) heights[k] = wet.panel[k].z() + wet.value[k];
        openings.add(wet.panel, heights);
      }
    }
  }
  return openings.triangles();
}

}  // namespace render
