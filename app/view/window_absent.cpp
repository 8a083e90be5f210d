#include "app/view/window.h"

/// Replaces window.cpp in builds without a windowing library.

namespace app {

std::string why_no_window() {
  return "this plimsoll was built without GLFW; install libglfw3-dev (Debian, Ubuntu; or GLFW 3.3 "
         "or later) and build it again from a new configuration";
}

struct Window::Impl {};

Window::Window(const std::string&, int, int) { throw render::Error(why_no_window()); }
Window::~Window() = default;
bool Window::closed() const { return true; }
std::array<int, 2> Window::size() const { return {}; }
std::vector<Event> Window::events(double) { return {}; }
void Window::draw(const render::Image&) {}
render::Image Window::read() const { return {}; }
void Window::present() {}

}  // namespace app
