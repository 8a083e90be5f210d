#pragma once

#include <optional>
#include <vector>

#include "app/render/color_scale.h"
#include "app/render/image.h"

namespace render {

/// Collects a sequence of pictures as one figure: side by side, lettered (a), (b), …, each with its
/// time, the shared pressure scale below.
///
/// It keeps small copies of at most 24 pictures. When more come, every second one is dropped and
/// from then on only every second, fourth, … is taken, so that the pictures stay evenly spaced,
/// the first stays the first and memory stays bounded.
class ContactSheet {
 public:
  static constexpr int kMostFrames = 24;
  static constexpr int kFrameWidth = 480;  ///< Of a picture on the sheet [px].

  /// @param scale     None: no scale is drawn (a dry scene).
  /// @param columns   None: as `sheet_columns` has it. Never more than pictures.
  explicit ContactSheet(std::optional<PressureScale> scale,
                        std::optional<int> columns = std::nullopt)
      : scale_(scale), columns_(columns) {}

  /// Adds the next picture, drawn at `time` [s]. All must have one size.
  void add(const Image& frame, double time);

  /// The sheet of the pictures so far. @throws Error if there are none.
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
  std::vector<Frame> frames_;
  long seen_ = 0;
  long stride_ = 1;
};

/// Columns that `count` pictures are laid out in: a sheet between 4:3 and 16:9 with few gaps if
/// pictures have the given width to height; 4 for 12 pictures of 4:3.
int sheet_columns(int count, double frame_aspect);

}  // namespace render
