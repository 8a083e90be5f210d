#pragma once

#include "app/render/body_appearance.h"
#include "app/render/color_scale.h"
#include "app/render/gl_mesh.h"
#include "app/render/gl_program.h"
#include "app/render/gl_textures.h"
#include "app/render/interior_look.h"
#include "app/render/shaded_mesh.h"
#include "app/render/view.h"

/// @file
/// Meshes and textures of the graphics device that a Renderer draws. The context must be
/// current in all functions.

namespace render {

/// Successive triangles of a body with one texture.
struct DrawnPart {
  GLuint texture = 0;  ///< 0: none.
  Eigen::Index first = 0, count = 0;
};

/// A body on the graphics device.
struct DrawnBody {
  hydro::TriMesh mesh_B;  ///< The mesh behind the skin.
  double radius;          ///< Distance of its farthest vertex from the origin of B [m].
  ShadedMesh skin_B;
  GlMesh mesh;
  GlMesh edges;                  ///< All edges of the mesh for a wireframe, else its creases.
  bool painted;                  ///< True: triangles have colours of their own.
  std::vector<DrawnPart> parts;  ///< All triangles; empty without textures.
  bool of_light;                 ///< How textures and colours multiply (texture_map.h).

  bool wet = false;  ///< A part of it is under water in the present picture.
  double churn = 0;  ///< How much it churns the surface then; 0 where it does not reach it.
};

/// @param textures       Those of its paint, which must outlive them.
/// @param longest_edge   Length above which edges are split [m].
/// @param wireframe      True: all edges are drawn.
DrawnBody make_body(const GlFunctions& gl, GlTextures& textures, const BodyAppearance& look,
                    double longest_edge, bool wireframe);

/// Draws the look of a body with the current program.
/// @param color   Colour of a body that is not painted, RGB 0 … 1.
void draw_look(const GlFunctions& gl, const GlProgram& program, const DrawnBody& body,
               const Eigen::Vector3d& color);

/// Gives the vertices of a body the water about them.
/// @param waves      Waves of the sea at this time.
/// @param interior   The water in the body's pockets.
void wet(DrawnBody& body, const hydro::BodyState& state, const hydro::Sea& sea,
         const hydro::AiryWaves& waves, double time, const std::optional<InteriorLook>& interior);

/// Returns the ground in E.
GlMesh make_ground(const GlFunctions& gl, const hydro::TriMesh& ground_W, const View& view);

/// Returns the level ground at z [m, W] to the horizon, in E.
GlMesh make_plane(const GlFunctions& gl, double z, const View& view);

/// Returns level triangles in E, three corners each, moved toward the eye by a part of their
/// distance, as water.
GlMesh make_level(const GlFunctions& gl, const Triangles& triangles_W, const View& view,
                  double nearer);

/// Returns a texture of the colours, from low to high.
GLuint make_scale_texture(const GlFunctions& gl, ColorMap colors);

}  // namespace render
