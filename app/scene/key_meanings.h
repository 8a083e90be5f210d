#pragma once

#include <span>
#include <string_view>

namespace scene {

/// The meaning of a key.
struct Meaning {
  std::string_view path;
  std::string_view text;  ///< Markdown.
};

/// Meanings of the keys of bodies, but for those of rig_meanings(), and of `hydro`.
std::span<const Meaning> body_meanings();

/// Meanings of the keys of joints, lines, machines, controls and applied loads.
std::span<const Meaning> rig_meanings();

}  // namespace scene
