#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "app/render/png.h"
#include "tests/golden/pictures/difference.h"
#include "tests/golden/pictures/drawing.h"

namespace {

namespace fs = std::filesystem;
using golden::Difference;
using golden::KeptPicture;
using render::Image;

struct Options {
  std::string action = "check";
  std::vector<std::string> scenes;
  fs::path out = "out/golden_pictures";
};

constexpr int kSame = 0, kDifferent = 1, kFailed = 2;

std::vector<std::string> scenes_of(const std::vector<KeptPicture>& pictures) {
  std::vector<std::string> names;
  for (const KeptPicture& picture : pictures) names.push_back(picture.scene);
  return names;
}

std::vector<KeptPicture> chosen_pictures(const std::vector<std::string>& scenes) {
  const std::vector<KeptPicture>& all = golden::kept_pictures();
  if (scenes.empty()) return all;
  std::vector<KeptPicture> chosen;
  for (const std::string& scene : scenes) {
    const auto found = std::ranges::find(all, scene, &KeptPicture::scene);
    if (found == all.end())
      throw std::invalid_argument(fmt::format("no picture of {} is kept; kept are those of {}",
                                              scene, fmt::join(scenes_of(all), ", ")));
    chosen.push_back(*found);
  }
  return chosen;
}

std::string told(const Difference& d) {
  return fmt::format(
      "{:.3f} % of the pixels differ by more than {} of 255, at most by {}; mean {:.3f}",
      100 * d.marked, golden::kSlight, d.largest, d.mean);
}

/// Draws a picture anew and holds it against that kept. One that differs is left in the folder,
/// with the places where. @return true if it is the same within tolerance.
bool check(const KeptPicture& picture, const fs::path& out) {
  const Image kept = render::read_png(golden::kept_file(picture)), drawn = golden::draw(picture);
  const Difference found = golden::difference(kept, drawn);
  const bool same = found.within_tolerance();
  fmt::print("{}: {}: {}\n", picture.scene, same ? "the same within tolerance" : "NOT what it was",
             told(found));
  if (same) return true;
  fs::create_directories(out);
  render::write_png(drawn, out / (picture.scene + ".png"));
  render::write_png(golden::difference_image(kept, drawn),
                    out / (picture.scene + "_difference.png"));
  fmt::print(
      "  it and where it differs are in {}; if that is meant: tools/golden_pictures renew {}\n",
      out.string(), picture.scene);
  return false;
}

/// Replaces the picture kept, and prints by how much it changes.
void renew(const KeptPicture& picture) {
  const fs::path file = golden::kept_file(picture);
  const Image drawn = golden::draw(picture);
  std::string change = "new";
  if (fs::exists(file)) {
    const Image kept = render::read_png(file);
    change = kept.width == drawn.width && kept.height == drawn.height
                 ? told(golden::difference(kept, drawn))
                 : fmt::format("was of {} x {} pixels", kept.width, kept.height);
  }
  render::write_png(drawn, file);
  fmt::print("{}: {}\n", picture.scene, change);
}

int run(const Options& options) {
  const std::vector<KeptPicture> pictures = chosen_pictures(options.scenes);
  bool same = true;
  for (const KeptPicture& picture : pictures) {
    if (options.action == "renew")
      renew(picture);
    else if (options.action == "list")
      fmt::print("{}\n", picture.scene);
    else
      same = check(picture, options.out) && same;
  }
  return same ? kSame : kDifferent;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App program(
      "Pictures of scenes that are kept: draws them anew and compares, or replaces them "
      "and prints what changes.",
      "tools/golden_pictures");
  program.add_option("action", options.action, "check, renew or list [check]")
      ->check(CLI::IsMember({"check", "renew", "list"}).description(""))
      ->type_name("ACTION");
  program.add_option("scenes", options.scenes, "Names of scenes [all of which pictures are kept]")
      ->type_name("SCENE");
  program.add_option("--out", options.out, "Folder of pictures that differ [out/golden_pictures]")
      ->type_name("DIR");
  CLI11_PARSE(program, argc, argv);
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);  // Those kept are the software rasteriser's.
  try {
    return run(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "tools/golden_pictures: {}\n", error.what());
    return kFailed;
  }
}
