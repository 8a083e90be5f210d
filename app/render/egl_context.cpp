#include "app/render/egl_context.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "app/render/image.h"

namespace render {
namespace {

constexpr const char* kAdvice =
    "install a graphics driver, or Mesa's software rasteriser: "
    "apt install libegl1 libegl-mesa0 libgl1-mesa-dri";

/// The functions of EGL that are used.
struct Egl {
  decltype(&eglGetProcAddress) GetProcAddress = nullptr;
  decltype(&eglGetError) GetError = nullptr;
  decltype(&eglQueryString) QueryString = nullptr;
  decltype(&eglGetDisplay) GetDisplay = nullptr;
  decltype(&eglInitialize) Initialize = nullptr;
  decltype(&eglBindAPI) BindAPI = nullptr;
  decltype(&eglChooseConfig) ChooseConfig = nullptr;
  decltype(&eglCreateContext) CreateContext = nullptr;
  decltype(&eglDestroyContext) DestroyContext = nullptr;
  decltype(&eglMakeCurrent) MakeCurrent = nullptr;
  decltype(&eglGetCurrentContext) GetCurrentContext = nullptr;
  PFNEGLGETPLATFORMDISPLAYEXTPROC GetPlatformDisplay = nullptr;  // null: not supported
  PFNEGLQUERYDEVICESEXTPROC QueryDevices = nullptr;              // null: not supported
  PFNEGLQUERYDEVICESTRINGEXTPROC QueryDeviceString = nullptr;    // null: not supported
};

template <typename Function>
void load(void* library, Function& function, const char* name) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (!function) throw Error(fmt::format("libEGL.so.1 has no {}; {}", name, kAdvice));
}

template <typename Function>
void load_extension(const Egl& egl, Function& function, const char* name) {
  function = reinterpret_cast<Function>(egl.GetProcAddress(name));
}

Egl load_egl() {
  // The library is never closed, since drivers leave threads and exit handlers behind.
  void* library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (!library) throw Error(fmt::format("no graphics library ({}); {}", dlerror(), kAdvice));
  Egl egl;
  load(library, egl.GetProcAddress, "eglGetProcAddress");
  load(library, egl.GetError, "eglGetError");
  load(library, egl.QueryString, "eglQueryString");
  load(library, egl.GetDisplay, "eglGetDisplay");
  load(library, egl.Initialize, "eglInitialize");
  load(library, egl.BindAPI, "eglBindAPI");
  load(library, egl.ChooseConfig, "eglChooseConfig");
  load(library, egl.CreateContext, "eglCreateContext");
  load(library, egl.DestroyContext, "eglDestroyContext");
  load(library, egl.MakeCurrent, "eglMakeCurrent");
  load(library, egl.GetCurrentContext, "eglGetCurrentContext");
  load_extension(egl, egl.GetPlatformDisplay, "eglGetPlatformDisplayEXT");
  load_extension(egl, egl.QueryDevices, "eglQueryDevicesEXT");
  load_extension(egl, egl.QueryDeviceString, "eglQueryDeviceStringEXT");
  return egl;
}

const Egl& egl() {
  static const Egl functions = load_egl();
  return functions;
}

/// The last error of EGL as a sentence.
std::string last_error() {
  switch (const EGLint code = egl().GetError()) {
    case EGL_SUCCESS:
      return "no reason is given";
    case EGL_NOT_INITIALIZED:
      return "its display cannot be initialised (no driver, or no right to use the device)";
    case EGL_BAD_ACCESS:
      return "the context is in use by another thread";
    case EGL_BAD_ALLOC:
      return "it is out of memory";
    case EGL_BAD_ATTRIBUTE:
      return "it does not know an attribute that was asked for";
    case EGL_BAD_CONFIG:
      return "it has no matching pixel format";
    case EGL_BAD_CONTEXT:
      return "the context is not valid";
    case EGL_BAD_DISPLAY:
      return "there is no such display";
    case EGL_BAD_MATCH:
      return "it has no OpenGL 3.3 core";
    case EGL_BAD_PARAMETER:
      return "it does not support this platform";
    case EGL_BAD_SURFACE:
      return "it cannot draw without a surface";
    case EGL_CONTEXT_LOST:
      return "the device was reset";
    default:
      return fmt::format("EGL error 0x{:04x}", code);
  }
}

bool has_word(const char* words, std::string_view word) {
  return words && fmt::format(" {} ", words).find(fmt::format(" {} ", word)) != std::string::npos;
}

/// Reads the variable as Mesa does: anything but an explicit no counts as yes.
bool software_only() {
  const char* value = std::getenv("LIBGL_ALWAYS_SOFTWARE");
  const std::string_view text = value ? value : "";
  return !(text.empty() || text == "0" || text == "false" || text == "no" || text == "n");
}

/// A display that may or may not work.
struct Candidate {
  std::string name;
  EGLenum platform = 0;  ///< 0: the default display.
  void* native = nullptr;
};

/// Returns the devices, graphics processors before software rasterisers.
std::vector<Candidate> device_candidates() {
  const Egl& e = egl();
  if (!e.QueryDevices || !e.QueryDeviceString || !e.GetPlatformDisplay) return {};
  std::array<EGLDeviceEXT, 32> devices;
  EGLint count = 0;
  if (!e.QueryDevices(static_cast<EGLint>(devices.size()), devices.data(), &count)) return {};
  std::vector<Candidate> processors, rasterisers;
  for (EGLint i = 0; i < count; ++i) {
    EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
    const char* extensions = e.QueryDeviceString(device, EGL_EXTENSIONS);
    const bool software = has_word(extensions, "EGL_MESA_device_software");
    (software ? rasterisers : processors)
        .push_back({fmt::format("{} {}", software ? "software rasteriser" : "device", i),
                    EGL_PLATFORM_DEVICE_EXT, device});
  }
  if (software_only()) return rasterisers;
  processors.insert(processors.end(), rasterisers.begin(), rasterisers.end());
  return processors;
}

std::vector<Candidate> candidates() {
  std::vector<Candidate> all = device_candidates();
  const char* extensions = egl().QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (egl().GetPlatformDisplay && has_word(extensions, "EGL_MESA_platform_surfaceless"))
    all.push_back({"Mesa without a surface", EGL_PLATFORM_SURFACELESS_MESA, nullptr});
  all.push_back({"the default display", 0, nullptr});
  return all;
}

struct DisplayAndContext {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

EGLContext create_context(EGLDisplay display) {
  constexpr std::array<EGLint, 5> kPixels = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE,
                                             EGL_OPENGL_BIT, EGL_NONE};
  constexpr std::array<EGLint, 7> kVersion = {EGL_CONTEXT_MAJOR_VERSION,
                                              3,
                                              EGL_CONTEXT_MINOR_VERSION,
                                              3,
                                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                              EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!egl().ChooseConfig(display, kPixels.data(), &config, 1, &count)) throw Error(last_error());
  if (count == 0) throw Error("it has no pixel format for OpenGL");
  EGLContext context = egl().CreateContext(display, config, EGL_NO_CONTEXT, kVersion.data());
  if (context == EGL_NO_CONTEXT) throw Error(last_error());
  return context;
}

void make_current_or_throw(const DisplayAndContext& c) {
  if (!egl().BindAPI(EGL_OPENGL_API)) throw Error("it has no OpenGL");
  if (!egl().MakeCurrent(c.display, EGL_NO_SURFACE, EGL_NO_SURFACE, c.context))
    throw Error(last_error());
}

/// Opens a candidate. Its display is never terminated, since all contexts on the device share it.
DisplayAndContext open(const Candidate& candidate) {
  DisplayAndContext c;
  c.display = candidate.platform
                  ? egl().GetPlatformDisplay(candidate.platform, candidate.native, nullptr)
                  : egl().GetDisplay(EGL_DEFAULT_DISPLAY);
  if (c.display == EGL_NO_DISPLAY) throw Error(last_error());
  if (!egl().Initialize(c.display, nullptr, nullptr)) throw Error(last_error());
  if (!egl().BindAPI(EGL_OPENGL_API)) throw Error("it has no OpenGL");
  c.context = create_context(c.display);
  try {
    make_current_or_throw(c);
  } catch (const Error&) {
    egl().DestroyContext(c.display, c.context);
    throw;
  }
  return c;
}

DisplayAndContext open_first() {
  std::string reasons;
  for (const Candidate& candidate : candidates()) {
    try {
      return open(candidate);
    } catch (const Error& error) {
      reasons += fmt::format("\n  {}: {}", candidate.name, error.what());
    }
  }
  throw Error(fmt::format("no graphics device can draw pictures; {}{}", kAdvice, reasons));
}

std::string text_of(const GlFunctions& gl, GLenum name) {
  const GLubyte* text = gl.GetString(name);
  return text ? reinterpret_cast<const char*>(text) : "unknown";
}

}  // namespace

EglContext::EglContext() {
  const DisplayAndContext c = open_first();
  display_ = c.display;
  context_ = c.context;
  gl_ = load_gl_functions(egl().GetProcAddress);
  device_ = fmt::format("{}, OpenGL {}", text_of(gl_, GL_RENDERER), text_of(gl_, GL_VERSION));
}

EglContext::~EglContext() {
  if (egl().GetCurrentContext() == context_)
    egl().MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  egl().DestroyContext(display_, context_);
}

void EglContext::make_current() const {
  try {
    make_current_or_throw({display_, context_});
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", device_, error.what()));
  }
}

}  // namespace render
