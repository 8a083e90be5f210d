#pragma once

#include <vector>

#include "app/pictures/drawn_rig.h"
#include "app/pictures/hanging_line.h"
#include "app/pictures/rig_parts.h"
#include "app/pictures/shot_spool.h"
#include "app/render/annotation.h"
#include "app/render/rigging.h"
#include "engine/base/spec.h"

/// @file
/// Lines, joints, anchors and machines in the pictures of a scene.
///
/// The colour of a line is its tension, from grey without tension over green and yellow to red at
/// the largest tension of the sequence. A spring that pushes is blue. A broken line is drawn as
/// short dark ends that hang from the bodies.

namespace app {

/// Colour of a share of the largest tension, −1 … 1; RGB 0 … 1.
Eigen::Vector3d tension_color(double share);

/// Returns the shape of a line that is not broken, from its first end to its second [m, W]: its
/// nodes if they are known, else its shape at rest. A spring is straight here.
Eigen::Matrix3Xd shape_of(const engine::LineSpec& line, const DrawnLine& now,
                          const std::vector<hydro::BodyState>& states, const GroundHeight& ground,
                          double radius);

/// Finds the rigging of each picture of a sequence.
class RigPictures {
 public:
  /// @param spec   It must outlive the object.
  RigPictures(const engine::SimulationSpec& spec, bool joints);

  /// True if the colours depend on the shots that are included.
  bool has_lines() const { return !spec_.lines.empty(); }

  /// Extends the scale of tensions to those in a shot.
  void include(const Shot& shot);

  render::Rigging of(const Shot& shot) const;

  /// Adds the scale of tensions to the legend of a picture, if there are lines.
  void explain(render::Annotations& notes) const;

  /// True if a spring pushes in a shot.
  bool pushes() const { return pushes_; }

  /// Upper end of the scale [N]; 0 while there is no tension.
  double scale_top() const;

 private:
  Eigen::Vector3d color_of(const DrawnLine& line) const;
  void add_line(std::size_t index, const Shot& shot, render::Rigging& rigging) const;

  const engine::SimulationSpec& spec_;
  GroundHeight ground_;
  std::vector<RigPart> parts_;
  double largest_ = 0;  ///< Largest amount of a tension [N].
  bool pushes_ = false;
};

}  // namespace app
