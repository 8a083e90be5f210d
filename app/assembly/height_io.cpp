#include "app/assembly/height_io.h"

#include <png.h>

#include <cmath>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/scene/diagnostics.h"
#include "app/scene/table_line.h"

namespace assembly {
namespace {

using scene::TableLine;

namespace fs = std::filesystem;

/// Largest number of pixels; it guards against a wrong header. 100 million heights fill 0.8 GB.
constexpr double kMostPixels = 1e8;

Eigen::MatrixXd read_table(const fs::path& file, std::istream& in) {
  std::vector<double> heights;
  std::size_t columns = 0, rows = 0;
  std::string text;
  for (int number = 1; std::getline(in, text); ++number) {
    const bool marked = number == 1 && text.starts_with("\xEF\xBB\xBF");  // byte order mark
    TableLine line(file, number, std::string_view(text).substr(marked ? 3 : 0),
                   "a finite number [m]");
    const std::vector<double> row = line.values();
    if (row.empty()) continue;
    if (rows++ == 0) columns = row.size();
    if (row.size() != columns)
      line.fail("the row has " + std::to_string(row.size()) + " numbers, expected " +
                std::to_string(columns) + " as in the first row");
    heights.insert(heights.end(), row.begin(), row.end());
  }
  if (in.bad()) throw scene::InputError(file, "the file cannot be read");
  if (rows == 0)
    throw scene::InputError(file, "the file holds no heights, expected rows of numbers");
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(heights.data(), static_cast<Eigen::Index>(rows),
                                    static_cast<Eigen::Index>(columns));
}

/// An open picture and the structures of libpng; frees both.
struct PngReader {
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream{nullptr, std::fclose};
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string error;

  PngReader() = default;
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
};

[[noreturn]] void on_png_error(png_structp png, png_const_charp message) {
  static_cast<PngReader*>(png_get_error_ptr(png))->error = message;
  png_longjmp(png, 1);
}

void on_png_warning(png_structp, png_const_charp) {}

/// Reads the picture up to its pixels. Returns false and sets `error` if libpng fails. It leaves by
/// longjmp, so this function and the next hold no object that needs destruction.
bool read_png_header(PngReader& reader) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_init_io(reader.png, reader.stream.get());
  png_read_info(reader.png, reader.info);
  return true;
}

bool read_png_rows(PngReader& reader, png_bytepp rows) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_read_image(reader.png, rows);
  png_read_end(reader.png, nullptr);
  return true;
}

void open_png(const fs::path& file, PngReader& reader) {
  reader.stream.reset(std::fopen(file.c_str(), "rb"));
  reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader, on_png_error, on_png_warning);
  if (reader.png) reader.info = png_create_info_struct(reader.png);
  if (!reader.stream || !reader.info) throw scene::InputError(file, "the picture cannot be opened");
  if (!read_png_header(reader)) throw scene::InputError(file, "not a sound PNG: " + reader.error);
  if (png_get_color_type(reader.png, reader.info) != PNG_COLOR_TYPE_GRAY)
    throw scene::InputError(file, "the picture has colours or transparency, expected grey only");
  const double pixels = static_cast<double>(png_get_image_width(reader.png, reader.info)) *
                        png_get_image_height(reader.png, reader.info);
  if (pixels > kMostPixels)
    throw scene::InputError(file, "the picture has more than 100 million pixels");
}

Eigen::MatrixXd read_picture(const fs::path& file, const std::array<double, 2>& range) {
  PngReader reader;
  open_png(file, reader);
  const bool wide = png_get_bit_depth(reader.png, reader.info) == 16;
  if (!wide) png_set_expand_gray_1_2_4_to_8(reader.png);
  png_set_interlace_handling(reader.png);
  const std::size_t width = png_get_image_width(reader.png, reader.info);
  const std::size_t height = png_get_image_height(reader.png, reader.info);
  const std::size_t stride = width * (wide ? 2 : 1);
  std::vector<std::uint8_t> bytes(stride * height);
  std::vector<png_bytep> rows;
  for (std::size_t i = 0; i < height; ++i) rows.push_back(bytes.data() + i * stride);
  if (!read_png_rows(reader, rows.data()))
    throw scene::InputError(file, "not a sound PNG: " + reader.error);

  Eigen::MatrixXd heights(height, width);
  for (std::size_t i = 0; i < height; ++i) {
    for (std::size_t j = 0; j < width; ++j) {
      // PNG stores the high byte first.
      const int grey = wide ? rows[i][2 * j] * 256 + rows[i][2 * j + 1] : rows[i][j];
      const double share = grey / (wide ? 65535.0 : 255.0);
      heights(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          (1 - share) * range[0] + share * range[1];
    }
  }
  return heights;
}

bool starts_as_png(std::istream& in) {
  std::array<char, 8> head = {};
  in.read(head.data(), head.size());
  const bool png = std::string_view(head.data(), head.size()) == "\x89PNG\r\n\x1A\n";
  in.clear();
  in.seekg(0);
  return png;
}

}  // namespace

Eigen::MatrixXd read_heights(const fs::path& file,
                             const std::optional<std::array<double, 2>>& range) {
  std::error_code error;
  if (!fs::exists(file, error)) throw scene::InputError(file, "there is no such file");
  if (fs::is_directory(file, error)) throw scene::InputError(file, "is a folder, expected a file");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw scene::InputError(file, "the file cannot be opened");
  const bool picture = starts_as_png(in);
  if (picture && !range)
    throw scene::InputError(
        file, "a picture needs `range: [lo, hi]`, the heights of black and white [m]");
  if (!picture && range)
    throw scene::InputError(file, "`range` belongs to a PNG picture, but this is not one");
  return picture ? read_picture(file, *range) : read_table(file, in);
}

}  // namespace assembly
