#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "app/render/image.h"
#include "app/view/controls.h"

/// @file
/// A window on a screen that shows images. No other file knows the windowing library.

namespace app {

/// Returns an empty text if this program can open windows, else what to install and do.
std::string why_no_window();

/// Window that is used by one thread. Only one may exist at a time.
class Window {
 public:
  /// @throws render::Error if there is no screen or no graphics for a window.
  Window(const std::string& title, int width, int height);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Returns true after the user has closed it.
  bool closed() const;
  /// Width and height [px]; zero while it is minimised.
  std::array<int, 2> size() const;

  /// Returns the events since the last call, after waiting for one for up to `wait` [s].
  std::vector<Event> events(double wait);

  /// Fills the window with an image, stretched to the window's size; `present` shows it.
  void draw(const render::Image& image);
  /// Returns the pixels that the window will show; to be called between `draw` and `present`.
  render::Image read() const;
  /// Shows the image that was drawn; waits for the screen's refresh.
  void present();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace app
