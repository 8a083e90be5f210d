#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "app/render/image.h"
#include "app/render/view.h"

/// @file
/// Arrows and marks drawn over a finished picture at points of the world. Bodies never hide them.

namespace render {

struct Arrow {
  Eigen::Vector3d from_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d to_W = Eigen::Vector3d::Zero();
  Rgb color;
};

/// A disc with a letter beside it.
struct Mark {
  Eigen::Vector3d at_W = Eigen::Vector3d::Zero();
  std::string letter;
  Rgb color;
  bool letter_left = false;
};

/// A line of the legend: a swatch with its name.
struct LegendLine {
  std::string name;
  Rgb color;
};

/// A line of the legend with a range of colours, from left to right.
struct LegendRamp {
  std::string name;
  std::vector<Rgb> colors;
};

struct Annotations {
  std::vector<Arrow> arrows;
  std::vector<Mark> marks;
  std::vector<LegendLine> legend;
  double scale_length = 0;  ///< Length of the legend's arrow at the point looked at [m].
  std::string scale_name;   ///< Label of that arrow.
  std::optional<LegendRamp> ramp;
};

/// Returns the position of a point in a picture [px from the upper left corner]; none for a point
/// behind the eye.
std::optional<Eigen::Vector2d> pixel_of(const View& view, const Image& image,
                                        const Eigen::Vector3d& p_W);

/// Draws an antialiased line with round ends; lengths in pixels.
void draw_line(Image& image, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width,
               Rgb color, double weight = 1);

/// Draws arrows and marks. @param view   View that the picture was drawn from.
void annotate(Image& image, const View& view, const Annotations& notes);

/// Draws the legend at the lower left. A picture that is too small for text gets none.
void add_legend(Image& image, const View& view, const Annotations& notes);

}  // namespace render
