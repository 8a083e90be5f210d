#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "app/export/glb.h"

/// @file
/// Moving parts of an exported scene: nodes that are displaced and turned, and surfaces that change
/// their shape.

namespace app {

/// The poses of a node over time. Neighbouring quaternions have the same sign, so that the turn
/// between them is the shorter one.
class PoseTrack {
 public:
  void add(const Eigen::Isometry3d& X_W);
  /// Writes the first pose into a node.
  void put_first(nlohmann::ordered_json& node) const;
  /// Adds the channels of a node to an animation, none of what stays.
  /// @param times   Accessor of the times of the poses.
  void animate(Glb& glb, nlohmann::ordered_json& animation, std::size_t node,
               std::size_t times) const;

 private:
  std::vector<Eigen::Vector3f> places_;
  std::vector<Eigen::Vector4f> turns_;  ///< Quaternions x, y, z, w.
};

/// A surface whose vertices move between samples, as morph targets.
class SampledSurface {
 public:
  SampledSurface(std::string name, Eigen::Matrix3Xi triangles)
      : name_(std::move(name)), triangles_(std::move(triangles)) {}

  /// Adds the vertices at the next sample, in W [m].
  void add(const Eigen::Matrix3Xd& vertices_W);
  /// Adds the surface and its animation. Without a change of shape it is a mesh that stands still.
  /// @param times   Accessor of the times of the samples. @return its node
  std::size_t write(Glb& glb, nlohmann::ordered_json& animation, std::size_t material,
                    std::size_t times) const;

 private:
  bool still() const;

  std::string name_;
  Eigen::Matrix3Xi triangles_;
  std::vector<Eigen::Matrix3Xf> samples_;
};

/// Adds a channel to an animation.
/// @param path   `translation`, `rotation` or `weights`.
void add_channel(nlohmann::ordered_json& animation, std::size_t node, const char* path,
                 std::size_t times, std::size_t values);

}  // namespace app
