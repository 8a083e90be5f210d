#include "app/pictures/video.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cctype>
#include <string_view>

#include "app/base/output_error.h"

namespace app {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// Colour space that players assume for high-definition video without a statement of its own.
const Words kColors = {"-colorspace", "bt709", "-color_primaries", "bt709",
                       "-color_trc",  "bt709", "-color_range",     "tv"};
const char* const kToVideoColors = "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p";

/// Each picture gets its own palette: a common one would need all pictures at once.
const char* const kPalettes =
    "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1";

struct VideoFormat {
  std::string ending;
  std::string filters;
  bool even;         ///< True: width and height must be even.
  Words encoder;     ///< Options for ffmpeg.
  Words file_forms;  ///< Options that apply only to output into a file.
};

const std::vector<VideoFormat>& formats() {
  static const std::vector<VideoFormat> kFormats = {
      {".mp4",
       kToVideoColors,
       true,
       {"-c:v", "libx264", "-preset", "medium", "-crf", "18"},
       {"-f", "mp4", "-movflags", "+faststart"}},
      {".webm",
       kToVideoColors,
       false,
       {"-c:v", "libvpx-vp9", "-crf", "28", "-b:v", "0", "-row-mt", "1", "-cpu-used", "4"},
       {"-f", "webm"}},
      {".gif", kPalettes, false, {"-c:v", "gif"}, {"-f", "gif"}}};
  return kFormats;
}

const VideoFormat& format_of(const fs::path& file) {
  const std::string ending = video_ending(file);
  const auto found = std::find_if(formats().begin(), formats().end(),
                                  [&](const VideoFormat& f) { return f.ending == ending; });
  assert(found != formats().end());
  return *found;
}

/// Repeats the last column and row of pictures of an odd size.
std::string evened(const VideoShape& shape) {
  const int right = shape.width % 2, bottom = shape.height % 2;
  if (right + bottom == 0) return "";
  return fmt::format("pad={}:{},fillborders=right={}:bottom={}:mode=smear,", shape.width + right,
                     shape.height + bottom, right, bottom);
}

void append(Words& words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
}

/// Returns the arguments of ffmpeg without the output.
Words encoding(const VideoFormat& format, const VideoShape& shape) {
  Words words = {"-hide_banner", "-loglevel", "error", "-nostdin"};
  append(words, {"-f", "rawvideo", "-pixel_format", "rgb24"});
  append(words, {"-video_size", fmt::format("{}x{}", shape.width, shape.height)});
  append(words, {"-framerate", std::to_string(shape.fps), "-i", "pipe:0"});
  append(words, {"-vf", (format.even ? evened(shape) : "") + format.filters});
  append(words, format.encoder);
  if (format.filters == kToVideoColors) append(words, kColors);
  append(words, {"-threads", std::to_string(shape.threads)});
  return words;
}

Words to_file(const VideoFormat& format, const VideoShape& shape, const std::string& file) {
  Words words = encoding(format, shape);
  append(words, format.file_forms);
  append(words, {"-y", "file:" + file});
  return words;
}

/// Returns the last line of the encoder's messages that gives a reason.
std::string reason(const PipedProgram& encoder) {
  Words lines = encoder.messages();
  while (lines.size() > 1 && lines.back().starts_with("Conversion failed")) lines.pop_back();
  return lines.empty() ? "it ended without a message" : lines.back();
}

}  // namespace

std::string video_ending(const fs::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

std::vector<std::string> video_endings() {
  std::vector<std::string> endings;
  for (const VideoFormat& format : formats()) endings.push_back(format.ending);
  return endings;
}

Video::Video(const fs::path& file, const VideoShape& shape)
    : file_(file),
      part_(file),
      encoder_(find_program("ffmpeg"), to_file(format_of(file), shape, part_.name())) {}

void Video::fail() {
  throw OutputError(fmt::format("{}: ffmpeg failed: {}", file_.string(), reason(encoder_)));
}

void Video::add(const render::Image& picture) {
  if (encoder_.write(picture.rgb)) return;
  encoder_.finish();
  fail();
}

void Video::finish() {
  if (!encoder_.finish()) fail();
  part_.rename();
}

std::string encoder_fault(const fs::path& file, const VideoShape& shape) {
  Words words = encoding(format_of(file), shape);
  append(words, {"-f", "null", "-"});
  PipedProgram encoder(find_program("ffmpeg"), words);
  const render::Image blank = render::filled_image(shape.width, shape.height, {});
  const bool taken = encoder.write(blank.rgb);
  return encoder.finish() && taken ? "" : reason(encoder);
}

}  // namespace app
