#pragma once

#include <map>
#include <memory>

#include "app/render/gl_mesh.h"
#include "app/render/gl_program.h"
#include "app/render/rigging.h"
#include "app/render/view.h"

namespace render {

/// Draws the rigging of a picture. The meshes of parts stay on the graphics device, whose context
/// must be current when the object is destroyed.
class GlRigging {
 public:
  explicit GlRigging(const GlFunctions& gl) : gl_(gl) {}

  /// @param body     The current program, which draws bodies, with the view set and without a sea.
  /// @param thinnest Least radius of a tube as a part of its distance along the view [-].
  void draw(const GlProgram& body, const View& view, double thinnest, const Rigging& rigging);

 private:
  void draw_part(const GlProgram& body, const View& view, const Part& part);

  const GlFunctions& gl_;
  std::map<std::shared_ptr<const hydro::TriMesh>, GlMesh> meshes_;
};

/// Returns a tube's mesh relative to the eye, as thick as it is drawn.
hydro::TriMesh drawn_tube(const Tube& tube, const View& view, double thinnest);

}  // namespace render
