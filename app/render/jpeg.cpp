#include "app/render/jpeg.h"

#include <fmt/format.h>

#include <csetjmp>
#include <cstddef>
#include <cstdio>
// They need what is above.
#include <jerror.h>
#include <jpeglib.h>

namespace render {
namespace {

/// libjpeg's state while it decodes, and the fault with which it ends.
struct JpegReader {
  jpeg_decompress_struct info{};
  jpeg_error_mgr errors{};
  std::jmp_buf fault{};
  char message[JMSG_LENGTH_MAX] = {};

  JpegReader() = default;
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;
  ~JpegReader() { jpeg_destroy_decompress(&info); }
};

[[noreturn]] void leave_jpeg(j_common_ptr info) {
  auto& reader = *static_cast<JpegReader*>(info->client_data);
  info->err->format_message(info, reader.message);
  std::longjmp(reader.fault, 1);
}

/// An end before the last row is a warning of libjpeg, which fills the rest with grey.
void on_jpeg_message(j_common_ptr info, int level) {
  const int code = info->err->msg_code;
  if (level < 0 && (code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER)) leave_jpeg(info);
}

/// Reads up to the pixels. Returns false if libjpeg fails, which leaves by longjmp: this function
/// and the next hold no object that needs destruction.
bool read_jpeg_header(JpegReader& reader, std::string_view bytes) {
  reader.info.err = jpeg_std_error(&reader.errors);
  reader.info.client_data = &reader;
  reader.errors.error_exit = leave_jpeg;
  reader.errors.emit_message = on_jpeg_message;
  if (setjmp(reader.fault)) return false;
  jpeg_create_decompress(&reader.info);
  jpeg_mem_src(&reader.info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&reader.info, TRUE);
  reader.info.out_color_space = JCS_RGB;
  return true;
}

bool read_jpeg_rows(JpegReader& reader, std::uint8_t* rgb) {
  if (setjmp(reader.fault)) return false;
  jpeg_start_decompress(&reader.info);
  while (reader.info.output_scanline < reader.info.output_height) {
    JSAMPROW row = rgb + std::size_t{3} * reader.info.output_width * reader.info.output_scanline;
    jpeg_read_scanlines(&reader.info, &row, 1);
  }
  jpeg_finish_decompress(&reader.info);
  return true;
}

}  // namespace

Image decode_jpeg(std::string_view bytes, double most_pixels) {
  JpegReader reader;
  if (!read_jpeg_header(reader, bytes))
    throw Error(fmt::format("not a sound JPEG: {}", reader.message));
  require_pixels(reader.info.image_width, reader.info.image_height, most_pixels);
  Image image = filled_image(static_cast<int>(reader.info.image_width),
                             static_cast<int>(reader.info.image_height), {});
  if (!read_jpeg_rows(reader, image.rgb.data()))
    throw Error(fmt::format("not a sound JPEG: {}", reader.message));
  return image;
}

}  // namespace render
