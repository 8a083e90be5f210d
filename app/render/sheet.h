#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "app/render/annotation.h"
#include "app/render/color_scale.h"
#include "app/render/image.h"

namespace render {

/// Collects a sequence of pictures in one figure. Pictures stand side by side, lettered (a), (b),
/// …, with their times; the shared scales of pressures and tensions stand below.
///
/// It keeps small copies of at most kMostFrames pictures. When more are added, every second one is
/// dropped and from then on only every second, fourth, … is taken, so that the pictures stay evenly
/// spaced, the first stays the first and memory stays bounded.
class ContactSheet {
 public:
  static constexpr int kMostFrames = 24;
  static constexpr int kFrameWidth = 480;  ///< Width of a picture on the sheet [px].

  /// @param scale     None: no scale is drawn (a dry scene).
  /// @param columns   Number of columns, at most that of pictures. None: `sheet_columns` chooses
  ///     it.
  /// @param ramp      Further scale; none: it is not drawn.
  explicit ContactSheet(std::optional<PressureScale> scale,
                        std::optional<int> columns = std::nullopt,
                        std::optional<LegendRamp> ramp = std::nullopt)
      : scale_(scale), columns_(columns), ramp_(std::move(ramp)) {}

  /// Adds the next picture, drawn at `time` [s]. All pictures must have the same size.
  void add(const Image& frame, double time);

  /// Returns the sheet of the pictures so far. @throws Error if there are none.
  Image image() const;

  /// Times of the pictures that are on the sheet [s].
  std::vector<double> times() const;

 private:
  struct Frame {
    Image image;
    double time = 0;
  };
  std::optional<PressureScale> scale_;
  std::optional<int> columns_;
  std::optional<LegendRamp> ramp_;
  std::vector<Frame> frames_;
  long seen_ = 0;
  long stride_ = 1;
};

/// Returns the number of columns for `count` pictures of the given ratio of width to height, chosen
/// for a sheet between 4:3 and 16:9 with few gaps: 4 for 12 pictures of 4:3.
int sheet_columns(int count, double frame_aspect);

}  // namespace render
