#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "app/render/image.h"
#include "app/render/view.h"

/// @file
/// Arrows and marks put on a finished picture at places of the world. Nothing hides them.

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

struct Annotations {
  std::vector<Arrow> arrows;
  std::vector<Mark> marks;
  std::vector<LegendLine> legend;
  double scale_length = 0;  ///< Of the arrow that the legend shows [m], at the point looked at.
  std::string scale_name;   ///< What that arrow stands for.
};

/// Where a point is in a picture [px from its upper left corner]; none for one behind the eye.
std::optional<Eigen::Vector2d> pixel_of(const View& view, const Image& image,
                                        const Eigen::Vector3d& p_W);

/// A line with round ends, antialiased; lengths in pixels.
void draw_line(Image& image, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width,
               Rgb color, double weight = 1);

/// Draws arrows and marks. @param view   That the picture was drawn from.
void annotate(Image& image, const View& view, const Annotations& notes);

/// Draws the legend, lower left. A picture that is too small for text has none.
void add_legend(Image& image, const View& view, const Annotations& notes);

}  // namespace render
