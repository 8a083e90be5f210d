#include "hydro/mesh/mending/mend.h"

#include <cstdio>
#include <utility>

#include "hydro/mesh/edge_table.h"
#include "hydro/mesh/mending/cap.h"
#include "hydro/mesh/mending/clean_faces.h"
#include "hydro/mesh/mending/mirror.h"
#include "hydro/mesh/mending/solid_union.h"
#include "hydro/mesh/mending/thicken.h"
#include "hydro/mesh/mending/turn_faces.h"
#include "hydro/mesh/mesh_parts.h"
#include "hydro/mesh/open_loops.h"
#include "hydro/mesh/weld.h"

namespace hydro {
namespace {

constexpr double kDefaultWeld = 1e-5;  // see default_weld()

/// Most rounds of cleaning: each drops faces that the one before has left flat or repeated.
constexpr int kMostRounds = 8;

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string plural(Eigen::Index count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

Eigen::Index turned_faces(const TriMesh& before, const TriMesh& after) {
  Eigen::Index count = 0;
  for (Eigen::Index f = 0; f < before.face_count(); ++f)
    count += before.faces.col(f) != after.faces.col(f);
  return count;
}

/// Mends one mesh, step by step.
class Mender {
 public:
  Mender(TriMesh mesh, const MendOptions& options)
      : options_(options), crack_(options.weld.value_or(default_weld(mesh))) {
    result_.mesh = std::move(mesh);
  }

  MendedMesh mend() {
    clean();
    turn(turned_consistently(mesh()), "to agree with their neighbours");
    if (options_.mirror) mirror(*options_.mirror);
    if (options_.cap) cap();
    if (options_.thickness) thicken(*options_.thickness);
    turn(turned_outward(mesh(), options_.unite ? Nested::as_drawn : Nested::cavity),
         "out of the solid");
    if (options_.unite) unite();
    result_.report = check_mesh(mesh());
    return std::move(result_);
  }

 private:
  TriMesh& mesh() { return result_.mesh; }
  void changed(std::string text) { result_.changes.push_back(std::move(text)); }

  void clean() {
    mesh() = welded(mesh(), 0);
    Eigen::Index merged = 0, flat = 0, repeated = 0, stitches = 0;
    for (int round = 0; round < kMostRounds; ++round) {
      const Eigen::Index vertices = mesh().vertex_count(), faces = mesh().face_count();
      mesh() = welded_among(mesh(), open_vertices(mesh()), crack_);
      merged += vertices - mesh().vertex_count();
      flat += dropped(without_flat_faces(mesh()));
      repeated += dropped(without_duplicate_faces(mesh()));
      const Eigen::Index before = mesh().face_count();
      mesh() = stitched(mesh(), crack_);
      stitches += mesh().face_count() - before;
      if (vertices == mesh().vertex_count() && faces == mesh().face_count()) break;
    }
    const Eigen::Index walls = dropped(without_inner_walls(mesh()));
    mesh() = welded(mesh(), 0);
    const std::string within = " within " + short_number(crack_) + " m";
    if (merged > 0)
      changed(plural(merged, "vertex was", "vertices were") + " welded to others" + within);
    if (flat > 0) changed(plural(flat, "face", "faces") + " without area dropped");
    if (repeated > 0) changed(plural(repeated, "repeated face", "repeated faces") + " dropped");
    if (stitches > 0)
      changed(plural(stitches, "T-junction was", "T-junctions were") + " stitched" + within);
    if (walls > 0) changed(plural(walls, "face", "faces") + " of walls inside dropped");
  }

  /// Takes a mesh with fewer faces. @return their number
  Eigen::Index dropped(TriMesh fewer) {
    const Eigen::Index count = mesh().face_count() - fewer.face_count();
    if (count > 0) mesh() = std::move(fewer);
    return count;
  }

  void turn(TriMesh turned, const char* how) {
    const Eigen::Index count = turned_faces(mesh(), turned);
    if (count > 0) changed(plural(count, "face was", "faces were") + " turned " + how);
    mesh() = std::move(turned);
  }

  void mirror(int axis) {
    const std::string plane = std::string(1, "xyz"[axis]) + " = 0";
    std::optional<TriMesh> whole = with_mirror_image(mesh(), axis, crack_);
    if (!whole) {
      result_.failures.push_back("the mesh lies on both sides of the plane " + plane +
                                 " and is no half to be mirrored in it");
      return;
    }
    mesh() = std::move(*whole);
    changed("the half was mirrored in the plane " + plane);
  }

  void cap() {
    CappedMesh closed = capped(mesh());
    if (closed.loops > 0)
      changed(plural(closed.loops, "flat open loop was", "flat open loops were") + " capped");
    else
      result_.failures.push_back("there is no flat open loop to be capped");
    mesh() = std::move(closed.mesh);
  }

  void thicken(double thickness) {
    if (open_vertices(mesh()).empty()) {
      result_.failures.push_back("there is no open part to be given a thickness");
      return;
    }
    mesh() = turned_outward(std::move(mesh()));
    mesh() = thickened(mesh(), thickness);
    changed("open parts became plates of " + short_number(thickness) + " m");
  }

  void unite() {
    if (!open_vertices(mesh()).empty()) {
      result_.failures.push_back("parts are open, and only closed ones can be united");
      return;
    }
    const std::vector<TriMesh> solids = solids_of(mesh());
    std::optional<TriMesh> whole = united(solids);
    if (!whole) {
      result_.failures.push_back(
          "the parts could not be united: one cuts itself, or they touch in many places; join them "
          "in a program that draws solids");
      return;
    }
    const std::size_t left = solids_of(*whole).size();
    if (left == solids.size()) {
      result_.failures.push_back("there are no closed parts that overlap or touch");
      return;
    }
    mesh() = std::move(*whole);
    changed(std::to_string(solids.size()) + " closed parts were united to " + std::to_string(left));
  }

  const MendOptions options_;
  const double crack_;  ///< [m]
  MendedMesh result_;
};

}  // namespace

double default_weld(const TriMesh& mesh) {
  return mesh.vertex_count() == 0 ? 0 : kDefaultWeld * bounding_box(mesh).diagonal().norm();
}

MendedMesh mended(TriMesh mesh, const MendOptions& options) {
  return Mender(std::move(mesh), options).mend();
}

}  // namespace hydro
