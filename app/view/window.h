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

/// Empty if this program can open windows; else what to install and do.
std::string why_no_window();

/// One thread at a time; one window at a time.
class Window {
 public:
  /// @throws render::Error if there is no screen or no graphics for a window.
  Window(const std::string& title, int width, int height);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Somebody has closed it.
  bool closed() const;
  /// Width and height [px]; zero while it is put aside.
  std::array<int, 2> size() const;

  /// Keys and mouse since the last call, waiting for one so long [s].
  std::vector<Event> events(double wait);

  /// Fills the window with an image, stretched if it is of another size; `present` shows it.
  void draw(const render::Image& image);
  /// What the window will show: its own pixels, between `draw` and `present`.
  render::Image read() const;
  /// Shows what was drawn; waits for the screen.
  void present();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace app
