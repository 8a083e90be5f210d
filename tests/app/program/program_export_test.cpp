#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <assimp/Importer.hpp>
#include <cstdint>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/assembly/build.h"
#include "app/logs/read_log.h"
#include "app/scene/reader.h"
#include "hydro/sea.h"
#include "tests/app/program/program.h"

namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

const char* const kScene = R"(
plimsoll: 1
title: Boxes in waves
duration: 1
step: 0.02
water: {level: 0.5, surface: {waves: [{amplitude: 0.2, wavelength: 7, heading_deg: 30}]}}
hydro: {added_mass: none, radiation: none}
bodies:
  - {name: red, box: {size: [1, 0.8, 0.6]}, density: 500, position: [-1, 2, 0.7], color: [1, 0, 0],
     angular_velocity: [0.4, 0.3, 2]}
  - {name: blue, box: {size: [1, 0.8, 0.6]}, density: 500, position: [3, 0, 0.5], color: [0, 0, 1]}
  - {name: twin, box: {size: [1, 0.8, 0.6]}, density: 400, position: [6, 0, 0.5], color: [1, 0, 0]}
  - {name: pier, box: {size: [1, 1, 4]}, lock: all, density: 2000, position: [0, -4, 0]}
log: {every: 0.02}
render: {camera: {from: [5, -8, 3], to: [0, 0, 0], follow: red}}
)";

/// An exported run, and its file as assimp reads it.
class Export : public testing::Test {
 protected:
  void make(const std::vector<std::string>& options = {"--fps", "50"}) {
    const std::string scene = place.write("boxes.yaml", kScene);
    ASSERT_EQ(place.run({"run", scene, "--out", "run", "--no-render", "--quiet"}).code, 0);
    std::vector<std::string> words = {"export", "run", "out.glb"};
    words.insert(words.end(), options.begin(), options.end());
    const support::Outcome done = place.run(words);
    ASSERT_EQ(done.code, 0) << done.err;
    said = done.err;
    file = importer.ReadFile((place / "out.glb").string(), 0);
    ASSERT_NE(file, nullptr) << importer.GetErrorString();
  }

  const aiNodeAnim* channel(const std::string& node) const {
    for (unsigned i = 0; i < file->mAnimations[0]->mNumChannels; ++i)
      if (node == file->mAnimations[0]->mChannels[i]->mNodeName.C_Str())
        return file->mAnimations[0]->mChannels[i];
    return nullptr;
  }

  /// The JSON of the file.
  nlohmann::json document() const {
    const std::string bytes = place.read("out.glb");
    std::uint32_t length;
    std::memcpy(&length, bytes.data() + 12, sizeof length);
    return nlohmann::json::parse(bytes.substr(20, length));
  }

  support::Workplace place;
  Assimp::Importer importer;
  const aiScene* file = nullptr;
  std::string said;
};

TEST_F(Export, BodiesMoveAsTheLogSays) {
  make();
  const app::Trajectory log = app::read_trajectory(place / "run/trajectory.csv");
  const app::BodyTrack& track = log.tracks.at("red");
  const aiNodeAnim* red = channel("red");
  ASSERT_NE(red, nullptr);
  ASSERT_EQ(red->mNumPositionKeys, track.times.size());
  const double ticks = file->mAnimations[0]->mTicksPerSecond;
  for (unsigned i = 0; i < red->mNumPositionKeys; ++i) {
    EXPECT_NEAR(red->mPositionKeys[i].mTime / ticks, track.times[i], 1e-6);
    const aiVector3D& p = red->mPositionKeys[i].mValue;
    EXPECT_LT((Vector3d(p.x, p.y, p.z) - track.states[i].position).norm(), 1e-6) << i;
    const aiQuaternion& q = red->mRotationKeys[i].mValue;
    EXPECT_LT(Eigen::Quaterniond(q.w, q.x, q.y, q.z).angularDistance(track.states[i].orientation),
              1e-3)
        << i;  // The distance of floats is the root of their error.
  }
  // A held body has no animation, but stands in its place.
  EXPECT_EQ(channel("pier"), nullptr);
  const aiMatrix4x4& pier = file->mRootNode->FindNode("pier")->mTransformation;
  EXPECT_EQ(Vector3d(pier.a4, pier.b4, pier.c4), Vector3d(0, -4, 0));
}

TEST_F(Export, StandsUprightWhereYIsUp) {
  make();
  const aiNode* world = file->mRootNode->FindNode("world");
  ASSERT_NE(world, nullptr);
  const aiVector3D up = aiMatrix3x3(world->mTransformation) * aiVector3D(0, 0, 1);
  EXPECT_NEAR(up.y, 1, 1e-6);
}

TEST_F(Export, WaterHasTheElevationOfTheSea) {
  make({"--fps", "50", "--water", "12"});
  const scene::Scene scene = scene::read(place / "boxes.yaml");
  const hydro::Sea sea = *assembly::build_without_added_mass(scene).spec.sea;
  const aiNode* node = file->mRootNode->FindNode("water");
  ASSERT_NE(node, nullptr);
  const aiMesh& water = *file->mMeshes[node->mMeshes[0]];
  ASSERT_EQ(water.mNumVertices, 13U * 13U);
  ASSERT_EQ(water.mNumAnimMeshes + 1, channel("red")->mNumPositionKeys);
  for (const unsigned sample : {0U, 7U, 30U}) {
    const double time = sample * 0.02;
    for (unsigned i = 0; i < water.mNumVertices; ++i) {
      const aiVector3D p =
          sample == 0 ? water.mVertices[i] : water.mAnimMeshes[sample - 1]->mVertices[i];
      const double expected = 0.5 + hydro::surface_elevation(sea, p.x, p.y, time);
      ASSERT_NEAR(p.z, expected, 2e-6) << sample << ": " << p.x << ", " << p.y;
    }
  }
}

TEST_F(Export, BodiesOfOneShapeAndColorShareAMesh) {
  make();
  const nlohmann::json file_json = document();
  EXPECT_EQ(file_json["asset"]["version"], "2.0");
  std::map<std::string, int> mesh_of;
  for (const nlohmann::json& node : file_json["nodes"])
    if (node.contains("mesh")) mesh_of[node["name"]] = node["mesh"];
  EXPECT_EQ(mesh_of.at("red"), mesh_of.at("twin"));
  EXPECT_NE(mesh_of.at("red"), mesh_of.at("blue"));  // Another colour.
  const auto& red = file_json["meshes"][mesh_of.at("red")]["primitives"][0];
  const auto color =
      file_json["materials"][red["material"].get<int>()]["pbrMetallicRoughness"]["baseColorFactor"];
  EXPECT_EQ(color, (nlohmann::json{1.0, 0.0, 0.0, 1.0}));
  EXPECT_EQ(file_json["cameras"].size(), 1U);
  EXPECT_THAT(said, HasSubstr("out.glb: "));
}

TEST_F(Export, EndsWithTheRunAtAnyRate) {
  make({"--fps", "1", "--water", "4"});
  const aiNodeAnim* red = channel("red");
  ASSERT_NE(red, nullptr);
  const app::Trajectory run = app::read_trajectory(place / "run/trajectory.csv");
  const app::BodyTrack& track = run.tracks.at("red");
  const aiVectorKey& last = red->mPositionKeys[red->mNumPositionKeys - 1];
  EXPECT_NEAR(last.mTime / file->mAnimations[0]->mTicksPerSecond, 1, 1e-6);
  const Vector3d p(last.mValue.x, last.mValue.y, last.mValue.z);
  EXPECT_LT((p - track.states.back().position).norm(), 1e-6);
  // The water ends there, too.
  const aiMesh& water = *file->mMeshes[file->mRootNode->FindNode("water")->mMeshes[0]];
  EXPECT_EQ(water.mNumAnimMeshes + 1, red->mNumPositionKeys);
}

TEST_F(Export, LeavesTheWaterOutWhereNoneIsWanted) {
  make({"--water", "0"});
  EXPECT_EQ(file->mRootNode->FindNode("water"), nullptr);
  EXPECT_NE(channel("red"), nullptr);
}

TEST_F(Export, TellsWhatIsWrong) {
  make();
  const auto fault = [&](const std::vector<std::string>& words) {
    const support::Outcome done = place.run(words);
    EXPECT_EQ(done.code, 2);
    return done.err;
  };
  EXPECT_THAT(fault({"export", "run", "out.obj"}),
              HasSubstr("out.obj: is of no format; expected .glb for a run, .fmu for a scene"));
  EXPECT_THAT(fault({"export", "nowhere", "out.glb"}), HasSubstr("nowhere"));
  EXPECT_THAT(fault({"export", "run", "out.glb", "--fps", "0"}), HasSubstr("--fps"));
  EXPECT_THAT(fault({"export", "run", "run/none/out.glb/x.glb", "--set", "water.levle=1"}),
              HasSubstr("levle"));
}

}  // namespace
