#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "app/render/image.h"

namespace render {

/// Texture coordinates of a triangle's corners: places in an image from its lower left corner, in
/// its widths (u) and heights (v). Beyond 0 … 1 the image repeats.
using CornerCoordinates = Eigen::Matrix<float, 2, 3>;

/// Images that lie over the F triangles of a surface.
struct TextureMap {
  std::vector<std::shared_ptr<const Image>> images;
  Eigen::VectorXi of_face;       ///< Image of each triangle; −1: none.
  Eigen::Matrix2Xf coordinates;  ///< 2×3F, of the corners of one triangle after the other.
  Eigen::Matrix3Xf tints;        ///< Colour of each triangle, which multiplies the image's.
  bool of_light = false;  ///< True: light is multiplied (glTF); false: displayed values (MTL).

  CornerCoordinates corners(int face) const { return coordinates.middleCols<3>(3 * face); }
};

/// Returns a colour of an image, multiplied by a tint as body.frag does. RGB as displayed, 0 … 1.
Eigen::Vector3f tinted(const Eigen::Vector3f& texel, const Eigen::Vector3f& tint, bool of_light);

/// Takes means of an image over triangles. It keeps the image at halved sizes, a third more.
class TexelMeans {
 public:
  /// @param image   It must outlive this.
  explicit TexelMeans(const Image& image);

  /// Returns the mean displayed colour over a triangle, RGB 0 … 1: that of evenly spaced points, up
  /// to 1024, a pixel apart in the largest of the images in which they are enough.
  Eigen::Vector3f over(const CornerCoordinates& corners) const;

 private:
  const Image& image_;
  std::vector<Image> halved_;  ///< Each half as large as the one before, down to one pixel.
};

}  // namespace render
