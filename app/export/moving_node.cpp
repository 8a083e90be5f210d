#include "app/export/moving_node.h"

#include <algorithm>

namespace app {
namespace {

using Json = nlohmann::ordered_json;

/// True if all are equal.
template <class Values>
bool constant(const Values& values) {
  return std::ranges::all_of(values, [&](const auto& value) { return value == values.front(); });
}

template <class Vector>
Eigen::MatrixXf columns_of(const std::vector<Vector>& vectors) {
  Eigen::MatrixXf columns(Vector::RowsAtCompileTime, static_cast<Eigen::Index>(vectors.size()));
  for (std::size_t i = 0; i < vectors.size(); ++i)
    columns.col(static_cast<Eigen::Index>(i)) = vectors[i];
  return columns;
}

template <class Vector>
Json list_of(const Vector& vector) {
  Json list = Json::array();
  for (const float number : vector) list.push_back(number);
  return list;
}

}  // namespace

void add_channel(Json& animation, std::size_t node, const char* path, std::size_t times,
                 std::size_t values) {
  const std::size_t sampler = animation["samplers"].size();
  animation["samplers"].push_back(
      {{"input", times}, {"interpolation", "LINEAR"}, {"output", values}});
  animation["channels"].push_back(
      {{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}});
}

void PoseTrack::add(const Eigen::Isometry3d& X_W) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(X_W.linear()).normalized();
  Eigen::Vector4f turn = q.coeffs().cast<float>();
  if (!turns_.empty() && turn.dot(turns_.back()) < 0) turn = -turn;
  places_.push_back(X_W.translation().cast<float>());
  turns_.push_back(turn);
}

void PoseTrack::put_first(Json& node) const {
  node["translation"] = list_of(places_.front());
  node["rotation"] = list_of(turns_.front());
}

void PoseTrack::animate(Glb& glb, Json& animation, std::size_t node, std::size_t times) const {
  if (!constant(places_))
    add_channel(animation, node, "translation", times,
                glb.add(columns_of(places_), Glb::Use::animation));
  if (!constant(turns_))
    add_channel(animation, node, "rotation", times,
                glb.add(columns_of(turns_), Glb::Use::animation));
}

void SampledSurface::add(const Eigen::Matrix3Xd& vertices_W) {
  samples_.push_back(vertices_W.cast<float>());
}

bool SampledSurface::still() const { return constant(samples_); }

std::size_t SampledSurface::write(Glb& glb, Json& animation, std::size_t material,
                                  std::size_t times) const {
  Json primitive = {{"attributes", {{"POSITION", glb.add(samples_.front(), Glb::Use::vertices)}}},
                    {"indices", glb.add(triangles_)},
                    {"material", material}};
  Json mesh = {{"name", name_}};
  const auto count = static_cast<Eigen::Index>(samples_.size());
  if (!still()) {
    // The first sample is the mesh itself, so that a reader without morph targets shows it.
    primitive["targets"] = Json::array();
    for (std::size_t i = 1; i < samples_.size(); ++i)
      primitive["targets"].push_back(
          {{"POSITION", glb.add(samples_[i] - samples_.front(), Glb::Use::vertices)}});
    mesh["weights"] = std::vector<float>(samples_.size() - 1, 0.0F);
  }
  mesh["primitives"] = Json::array({std::move(primitive)});
  const std::size_t node =
      glb.append("nodes", {{"name", name_}, {"mesh", glb.append("meshes", std::move(mesh))}});
  if (still()) return node;
  // At each sample its own weight is 1 and the others are 0.
  Eigen::MatrixXf weights = Eigen::MatrixXf::Zero(count - 1, count);
  weights.rightCols(count - 1).setIdentity();
  add_channel(
      animation, node, "weights", times,
      glb.add(Eigen::Map<Eigen::MatrixXf>(weights.data(), 1, weights.size()), Glb::Use::animation));
  return node;
}

}  // namespace app
