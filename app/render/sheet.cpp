#include "app/render/sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/render/overlay.h"
#include "app/render/text.h"

namespace render {
namespace {

constexpr int kGap = 16;       ///< Between pictures [px].
constexpr int kMargin = 24;    ///< Around the sheet [px].
constexpr int kTextSize = 22;  ///< [px]; 8 pt when the sheet is printed 19 cm wide.
constexpr int kCaption = 40;   ///< Height of the line under a picture [px].

std::string caption(std::size_t index, double time) {
  return fmt::format("({})  {}", static_cast<char>('a' + index), time_label(time));
}

/// Draws a scale of colours and its name in the middle of a row of the sheet.
void write_ramp(Image& sheet, const LegendRamp& ramp, int top, const Font& font) {
  constexpr int kBar = 192;  // [px]
  const int thickness = kTextSize;
  const double middle = sheet.width / 2.0;
  const int left = static_cast<int>(middle) - kGap / 2 - kBar;
  for (int x = 0; x < kBar; ++x)
    for (int y = 0; y < thickness; ++y)
      blend(sheet, left + x, top + y,
            ramp.colors[static_cast<std::size_t>(x) * ramp.colors.size() / kBar], 1);
  font.write(sheet, ramp.name, middle + kGap / 2.0, top + 0.5 * (thickness + font.cap_height()),
             Align::left);
}

}  // namespace

int sheet_columns(int count, double frame_aspect) {
  constexpr double kAspect = 1.55;  // half-way from 4:3 to 16:9
  int best = 1;
  double least = 1e300;
  for (int columns = 1; columns <= count; ++columns) {
    const int rows = (count + columns - 1) / columns;
    const double off_aspect = std::abs(std::log(frame_aspect * columns / rows / kAspect));
    // Half a sheet of gaps weighs as much as a sheet e times too wide.
    const double gaps = 2.0 * (rows * columns - count) / (rows * columns);
    if (off_aspect + gaps < least) {
      least = off_aspect + gaps;
      best = columns;
    }
  }
  return best;
}

void ContactSheet::add(const Image& frame, double time) {
  if (seen_++ % stride_ != 0) return;
  if (frames_.size() == kMostFrames) {
    for (std::size_t i = 1; 2 * i < frames_.size(); ++i) frames_[i] = std::move(frames_[2 * i]);
    frames_.resize(kMostFrames / 2);
    stride_ *= 2;
  }
  const int height = std::max(1, static_cast<int>(std::lround(static_cast<double>(kFrameWidth) *
                                                              frame.height / frame.width)));
  frames_.push_back({resized(frame, kFrameWidth, height), time});
}

std::vector<double> ContactSheet::times() const {
  std::vector<double> times;
  for (const Frame& frame : frames_) times.push_back(frame.time);
  return times;
}

Image ContactSheet::image() const {
  if (frames_.empty()) throw Error("a contact sheet needs at least one picture");
  const int frame_height = frames_[0].image.height;
  const int count = static_cast<int>(frames_.size());
  const int columns = columns_
                          ? std::min(*columns_, count)
                          : sheet_columns(count, static_cast<double>(kFrameWidth) / frame_height);
  const int rows = (count + columns - 1) / columns;
  const int width = 2 * kMargin + columns * (kFrameWidth + kGap) - kGap;
  // A single column is too narrow for the scale at the usual size of its text.
  const int scale_text = std::min(kTextSize, width / 42);
  const Image legend = scale_ ? lying_scale(*scale_, width, scale_text) : Image{};
  const int pictures_height = kMargin + rows * (frame_height + kCaption + kGap);
  const int scales_height = legend.height + (ramp_ ? kCaption : 0);
  Image sheet = filled_image(width, pictures_height + scales_height, {255, 255, 255});
  const Font font(kTextSize);
  for (int i = 0; i < count; ++i) {
    const Frame& frame = frames_[static_cast<std::size_t>(i)];
    const int left = kMargin + i % columns * (kFrameWidth + kGap);
    const int top = kMargin + i / columns * (frame_height + kCaption + kGap);
    paste(sheet, frame.image, left, top);
    font.write(sheet, caption(static_cast<std::size_t>(i), frame.time), left + kFrameWidth / 2.0,
               top + frame_height + 0.5 * (kCaption + font.cap_height()), Align::center);
  }
  if (scale_) paste(sheet, legend, 0, pictures_height);
  if (ramp_) write_ramp(sheet, *ramp_, pictures_height + legend.height, font);
  return sheet;
}

}  // namespace render
