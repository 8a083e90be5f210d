#define GLFW_INCLUDE_NONE
#include "app/view/window.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "app/render/gl_functions.h"

namespace app {
namespace {

std::string last_fault() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason is given";
}

std::optional<Key> key_of(int code) {
  switch (code) {
    case GLFW_KEY_SPACE:
      return Key::pause;
    case GLFW_KEY_RIGHT:
      return Key::step;
    case GLFW_KEY_UP:
      return Key::faster;
    case GLFW_KEY_DOWN:
      return Key::slower;
    case GLFW_KEY_ESCAPE:
      return Key::quit;
    default:
      return std::nullopt;
  }
}

/// Maps the letter printed on a key to a command, for any keyboard layout.
std::optional<Key> key_of_letter(unsigned letter) {
  switch (letter) {
    case '.':
      return Key::step;
    case '+':
      return Key::faster;
    case '-':
      return Key::slower;
    case 'r':
      return Key::restart;
    case 'c':
      return Key::home;
    case 'h':
      return Key::help;
    case 'q':
      return Key::quit;
    default:
      return std::nullopt;
  }
}

std::optional<Button> button_of(int code) {
  switch (code) {
    case GLFW_MOUSE_BUTTON_LEFT:
      return Button::left;
    case GLFW_MOUSE_BUTTON_MIDDLE:
      return Button::middle;
    case GLFW_MOUSE_BUTTON_RIGHT:
      return Button::right;
    default:
      return std::nullopt;
  }
}

/// Lifetime of the windowing library.
struct Library {
  Library() {
    if (glfwInit() == GLFW_TRUE) return;
    throw render::Error(fmt::format(
        "there is no screen to open a window on ({}); plimsoll run draws pictures without one",
        last_fault()));
  }
  ~Library() { glfwTerminate(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

struct WindowCloser {
  void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};
using WindowHandle = std::unique_ptr<GLFWwindow, WindowCloser>;

WindowHandle open_window(const std::string& title, int width, int height) {
  // Pictures are drawn in an EGL context, and a thread can use only one kind of context at a time.
  glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  WindowHandle window(glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr));
  if (!window)
    throw render::Error(fmt::format("no window can be opened on this screen: {}", last_fault()));
  return window;
}

std::vector<Event>& events_of(GLFWwindow* window) {
  return *static_cast<std::vector<Event>*>(glfwGetWindowUserPointer(window));
}

/// Converts a position of the mouse in window units to a point (orbit.h).
Eigen::Vector2d point_at(GLFWwindow* window, double x, double y) {
  int width = 0, height = 0;
  glfwGetWindowSize(window, &width, &height);
  return Eigen::Vector2d(2 * x - width, height - 2 * y) / std::max(1, height);
}

void on_button(GLFWwindow* window, int code, int action, int modifiers) {
  const auto button = button_of(code);
  if (!button) return;
  if (action == GLFW_RELEASE)
    return static_cast<void>(events_of(window).push_back(ButtonRelease{}));
  double x = 0, y = 0;
  glfwGetCursorPos(window, &x, &y);
  events_of(window).push_back(ButtonPress{.button = *button,
                                          .at = point_at(window, x, y),
                                          .shift = (modifiers & GLFW_MOD_SHIFT) != 0,
                                          .control = (modifiers & GLFW_MOD_CONTROL) != 0});
}

void set_callbacks(GLFWwindow* window, std::vector<Event>& events) {
  glfwSetWindowUserPointer(window, &events);
  glfwSetKeyCallback(window, [](GLFWwindow* w, int code, int, int action, int) {
    if (const auto key = key_of(code); key && action != GLFW_RELEASE)
      events_of(w).push_back(KeyPress{*key});
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned letter) {
    if (const auto key = key_of_letter(letter)) events_of(w).push_back(KeyPress{*key});
  });
  glfwSetMouseButtonCallback(window, on_button);
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    events_of(w).push_back(MouseMove{point_at(w, x, y)});
  });
  glfwSetScrollCallback(
      window, [](GLFWwindow* w, double, double up) { events_of(w).push_back(Wheel{up}); });
}

}  // namespace

std::string why_no_window() { return ""; }

struct Window::Impl {
  Impl(const std::string& title, int width, int height)
      : window(open_window(title, width, height)) {
    glfwMakeContextCurrent(window.get());
    gl = render::load_gl_functions(glfwGetProcAddress);
    glfwSwapInterval(1);
    set_callbacks(window.get(), events);
    gl.GenTextures(1, &texture);
    gl.GenFramebuffers(1, &source);
  }

  Library library;
  WindowHandle window;
  render::GlFunctions gl;
  std::vector<Event> events;
  GLuint texture = 0;
  GLuint source = 0;  ///< Framebuffer with the texture, the source of copies.
};

Window::Window(const std::string& title, int width, int height)
    : impl_(std::make_unique<Impl>(title, width, height)) {}

Window::~Window() = default;

bool Window::closed() const { return glfwWindowShouldClose(impl_->window.get()) == GLFW_TRUE; }

std::array<int, 2> Window::size() const {
  std::array<int, 2> size = {0, 0};
  glfwGetFramebufferSize(impl_->window.get(), &size[0], &size[1]);
  return size;
}

std::vector<Event> Window::events(double wait) {
  if (wait > 0)
    glfwWaitEventsTimeout(wait);
  else
    glfwPollEvents();
  return std::exchange(impl_->events, {});
}

void Window::draw(const render::Image& image) {
  const render::GlFunctions& gl = impl_->gl;
  const auto [width, height] = size();
  glfwMakeContextCurrent(impl_->window.get());
  gl.BindTexture(GL_TEXTURE_2D, impl_->texture);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
                image.rgb.data());
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, impl_->source);
  gl.FramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, impl_->texture,
                          0);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  // Rows of an image start at the top, those of a framebuffer at the bottom.
  gl.BlitFramebuffer(0, 0, image.width, image.height, 0, height, width, 0, GL_COLOR_BUFFER_BIT,
                     GL_LINEAR);
}

render::Image Window::read() const {
  const render::GlFunctions& gl = impl_->gl;
  const auto [width, height] = size();
  glfwMakeContextCurrent(impl_->window.get());
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  render::Image image = render::filled_image(width, height, {});
  for (int y = 0; y < height; ++y)
    gl.ReadPixels(0, height - 1 - y, width, 1, GL_RGB, GL_UNSIGNED_BYTE, image.pixel(0, y));
  return image;
}

void Window::present() {
  glfwMakeContextCurrent(impl_->window.get());
  glfwSwapBuffers(impl_->window.get());
}

}  // namespace app
