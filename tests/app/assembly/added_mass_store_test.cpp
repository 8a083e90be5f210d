#include "app/assembly/added_mass_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <chrono>
#include <fstream>
#include <set>
#include <thread>

#include "app/base/checked_file.h"
#include "hydro/added_mass/surface_added_mass.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/files.h"
#include "tests/support/random_pose.h"

namespace {

namespace fs = std::filesystem;
using assembly::AddedMassStore;
using hydro::AddedMassOptions;
using hydro::AddedMassSolution;
using hydro::TriMesh;
using testing::HasSubstr;
using testing::IsEmpty;

/// Keeps the warnings that it is told.
struct Warnings : app::Reporter {
  std::string text;  ///< A line each.
  void warning(const std::string& message) override { text += message + '\n'; }
};

class StoreOfAddedMass : public testing::Test {
 protected:
  StoreOfAddedMass() : folder(fs::path(testing::TempDir()) / ("plimsoll_store_" + name())) {
    fs::remove_all(folder);
  }
  ~StoreOfAddedMass() override { fs::remove_all(folder); }

  static std::string name() {
    return testing::UnitTest::GetInstance()->current_test_info()->name();
  }

  /// What is found by a process that knows nothing yet.
  std::optional<assembly::StoredAddedMass> found() {
    return AddedMassStore(folder).find(mesh, {}, warnings);
  }

  /// Numbers that no solver need have found.
  static AddedMassSolution some_solution(const TriMesh& mesh) {
    support::Random random(1);
    AddedMassSolution solution;
    for (double& entry : solution.matrix.reshaped()) entry = random.uniform(-1, 1);
    solution.symmetry_error = 1e-5;
    solution.error_estimate = 1e-3;
    solution.panels = 1234;
    solution.unknowns = 567;
    solution.seconds = 1.25;
    solution.bytes = 8e6;
    solution.potentials.resize(static_cast<std::size_t>(mesh.face_count()));
    for (hydro::CornerPotentials& psi : solution.potentials)
      for (double& entry : psi.reshaped()) entry = random.uniform(-1, 1);
    return solution;
  }

  fs::path file() const { return AddedMassStore(folder).file_of(mesh, {}); }
  std::string bytes() const { return support::bytes_in(file()); }
  void write(const std::string& text) const { std::ofstream(file(), std::ios::binary) << text; }
  std::vector<std::string> files() const { return support::files_in(folder); }

  fs::path folder;
  Warnings warnings;
  TriMesh mesh = hydro::make_icosphere(1, 1);
  AddedMassSolution solution = some_solution(mesh);
};

TEST_F(StoreOfAddedMass, KeepsASolutionToTheLastBit) {
  EXPECT_FALSE(found());
  EXPECT_FALSE(AddedMassStore(folder).keep(mesh, {}, solution).from_store);
  const auto stored = found();
  ASSERT_TRUE(stored);
  EXPECT_TRUE(stored->from_store);
  const AddedMassSolution& s = *stored->solution;
  EXPECT_EQ(s.matrix, solution.matrix);
  EXPECT_EQ(s.potentials, solution.potentials);
  EXPECT_EQ(
      std::tuple(s.symmetry_error, s.error_estimate, s.panels, s.unknowns, s.seconds, s.bytes),
      std::tuple(1e-5, 1e-3, 1234, 567, 1.25, 8e6));
}

TEST_F(StoreOfAddedMass, TellsMeshesAndOptionsApart) {
  AddedMassStore(folder).keep(mesh, {}, solution);
  TriMesh moved = mesh;
  moved.vertices(2, 7) = std::nextafter(moved.vertices(2, 7), 2);
  TriMesh turned = mesh;
  turned.faces.col(3) = Eigen::Vector3i(mesh.faces(1, 3), mesh.faces(2, 3), mesh.faces(0, 3));
  for (const TriMesh& other : {moved, turned}) EXPECT_FALSE(AddedMassStore(folder).find(other, {}));
  for (const AddedMassOptions& other :
       {AddedMassOptions{.tolerance = 2e-3}, AddedMassOptions{.most_panels = 10},
        AddedMassOptions{.method = hydro::AddedMassMethod::constant}})
    EXPECT_FALSE(AddedMassStore(folder).find(mesh, other));
}

TEST_F(StoreOfAddedMass, SharesASolutionWithinAProcess) {
  AddedMassStore store(std::nullopt);
  EXPECT_FALSE(store.find(mesh, {}));
  const assembly::StoredAddedMass kept = store.keep(mesh, {}, solution);
  const auto again = store.find(mesh, {});
  ASSERT_TRUE(again);
  EXPECT_EQ(again->solution, kept.solution);
  EXPECT_FALSE(again->from_store);
  EXPECT_FALSE(fs::exists(folder));
}

TEST_F(StoreOfAddedMass, SaysWhatIsDamagedAndMakesItAnew) {
  AddedMassStore(folder).keep(mesh, {}, solution);
  const std::string whole = bytes();
  std::vector<std::string> wrong = {
      "",         "x", "plimsoll: 1\n", whole.substr(0, 100), whole.substr(0, whole.size() - 1),
      whole + "x"};
  for (const std::size_t at : {0ul, 9ul, 60ul, whole.size() / 2, whole.size() - 1}) {
    wrong.push_back(whole);
    wrong.back()[at] = static_cast<char>(wrong.back()[at] ^ 4);
  }
  for (const std::string& text : wrong) {
    write(text);
    warnings.text.clear();
    EXPECT_FALSE(found());
    EXPECT_THAT(warnings.text,
                testing::AllOf(testing::StartsWith("" + file().string() + " is "),
                               testing::EndsWith("; the added mass is computed anew\n")));
    AddedMassStore(folder).keep(mesh, {}, solution);
    EXPECT_EQ(bytes(), whole);
  }
}

TEST_F(StoreOfAddedMass, GathersTheNodesOfSeveralRuns) {
  const auto node = [](int attitude, int draught, double size) {
    return hydro::SurfaceNode{attitude, draught, size * hydro::Matrix6d::Identity()};
  };
  const AddedMassStore store(folder);
  EXPECT_THAT(store.find_nodes(mesh), IsEmpty());
  store.keep_nodes(mesh, {node(3, 1, 0.1), node(0, 18, 2)});
  AddedMassStore(folder).keep_nodes(mesh, {node(3, 2, 0.3), node(3, 1, 0.1)});
  const std::vector<hydro::SurfaceNode> found = store.find_nodes(mesh);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(std::tuple(found[0].attitude, found[0].draught, found[0].matrix(0, 0)),
            std::tuple(0, 18, 2));
  EXPECT_EQ(std::tuple(found[2].attitude, found[2].draught, found[2].matrix(5, 5)),
            std::tuple(3, 2, 0.3));
  EXPECT_THAT(store.find_nodes(hydro::make_icosphere(2, 1)), IsEmpty());

  fs::resize_file(store.nodes_file_of(mesh), fs::file_size(store.nodes_file_of(mesh)) - 1);
  EXPECT_THAT(store.find_nodes(mesh, warnings), IsEmpty());
  EXPECT_THAT(warnings.text, HasSubstr("is damaged: its checksum"));
}

TEST_F(StoreOfAddedMass, DoesNotTakeASoundFileOfAnotherMesh) {
  const TriMesh other = hydro::make_icosphere(2, 1);
  AddedMassStore(folder).keep(mesh, {}, solution);
  AddedMassStore(folder).keep(other, {}, solution);
  fs::copy_file(AddedMassStore(folder).file_of(other, {}), file(),
                fs::copy_options::overwrite_existing);
  warnings.text.clear();
  EXPECT_FALSE(found());
  EXPECT_THAT(warnings.text, HasSubstr("belongs to another mesh or method"));
}

TEST_F(StoreOfAddedMass, GoesOnWhereNothingCanBeWritten) {
  std::ofstream(folder) << "a file\n";
  for (const fs::path& where : {folder, folder / "below", fs::path("/proc/plimsoll")}) {
    AddedMassStore store(where);
    warnings.text.clear();
    EXPECT_FALSE(store.find(mesh, {}, warnings));
    EXPECT_EQ(store.keep(mesh, {}, solution, warnings).solution->matrix, solution.matrix);
    EXPECT_TRUE(store.find(mesh, {}));
    EXPECT_THAT(warnings.text, testing::StartsWith("the added mass is not kept for later runs: "));
  }
}

TEST_F(StoreOfAddedMass, SaysWhatStandsInItsWay) {
  fs::create_directories(file() / "full");
  warnings.text.clear();
  EXPECT_FALSE(found());
  AddedMassStore(folder).keep(mesh, {}, solution, warnings);
  EXPECT_THAT(warnings.text,
              testing::AllOf(HasSubstr("is no ordinary file"), HasSubstr("is not kept")));
  EXPECT_EQ(files().size(), 1);
}

/// A limit on the size of files stands for a full disk: writing fails half way.
TEST_F(StoreOfAddedMass, LeavesNothingOnAFullDisk) {
  fs::create_directories(folder);
  rlimit before;
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = ::signal(SIGXFSZ, SIG_IGN);
  warnings.text.clear();
  const rlimit small = {4096, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const assembly::StoredAddedMass kept = AddedMassStore(folder).keep(mesh, {}, solution, warnings);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  ::signal(SIGXFSZ, handler);
  EXPECT_THAT(warnings.text, HasSubstr("File too large"));
  EXPECT_EQ(kept.solution->matrix, solution.matrix);
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(StoreOfAddedMass, IsWholeForReadersWhileOthersWrite) {
  AddedMassStore(folder).keep(mesh, {}, solution);
  const auto write_often = [&] {
    Warnings own;
    for (int i = 0; i < 40; ++i) AddedMassStore(folder).keep(mesh, {}, solution, own);
    EXPECT_EQ(own.text, "");
  };
  std::thread one(write_often);
  std::thread two(write_often);
  int missing = 0;
  for (int i = 0; i < 200; ++i) missing += !found();
  one.join();
  two.join();
  EXPECT_EQ(missing, 0);
  EXPECT_EQ(warnings.text, "");
  EXPECT_EQ(files().size(), 1);
}

TEST_F(StoreOfAddedMass, RemovesOnlyWhatTheDeadLeftOfIt) {
  fs::create_directories(folder);
  for (const char* part : {"a.addedmass.part-1-0", "b.addedmass.part-mine", "c.part-1-0"})
    std::ofstream(folder / part) << "x";
  AddedMassStore(folder).keep(mesh, {}, solution);
  EXPECT_THAT(files(), testing::UnorderedElementsAre("b.addedmass.part-mine", "c.part-1-0",
                                                     file().filename().string()));
}

TEST_F(StoreOfAddedMass, Takes168BytesATriangle) {
  const TriMesh large = hydro::make_sphere(1, 50, 51);
  AddedMassStore store(folder);
  store.keep(large, {}, some_solution(large));
  // 144 of potentials, 12 of corners, and 24 for half a vertex each.
  EXPECT_NEAR(static_cast<double>(fs::file_size(store.file_of(large, {}))),
              168.0 * static_cast<double>(large.face_count()), 1000);
}

TEST(CacheFolder, IsTheFirstOfThoseThatAreNamed) {
  const char* const names[] = {"PLIMSOLL_CACHE", "XDG_CACHE_HOME", "HOME"};
  std::vector<std::optional<std::string>> before;
  for (const char* name : names) {
    const char* value = std::getenv(name);
    before.push_back(value ? std::optional<std::string>(value) : std::nullopt);
  }
  ::setenv("PLIMSOLL_CACHE", "here", 1);
  ::setenv("XDG_CACHE_HOME", "/xdg", 1);
  ::setenv("HOME", "/home/me", 1);
  EXPECT_EQ(assembly::cache_folder(), "here");
  ::setenv("PLIMSOLL_CACHE", "", 1);
  EXPECT_EQ(assembly::cache_folder(), "/xdg/plimsoll");
  ::setenv("XDG_CACHE_HOME", "relative", 1);
  EXPECT_EQ(assembly::cache_folder(), "/home/me/.cache/plimsoll");
  ::unsetenv("HOME");
  EXPECT_EQ(assembly::cache_folder(), std::nullopt);
  for (std::size_t i = 0; i < before.size(); ++i)
    before[i] ? ::setenv(names[i], before[i]->c_str(), 1) : ::unsetenv(names[i]);
}

TEST(HashOf, ChangesWithAnyByteWithTheLengthAndWithTheSignsOfNumbers) {
  const std::vector<double> numbers = {1.5, -2.25, 3};
  std::string bytes;
  app::append(bytes, numbers.data(), numbers.size());
  bytes += "end";
  std::set<std::uint64_t> hashes = {app::hash_of(bytes), app::hash_of(bytes + '\0')};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string other = bytes;
    other[i] = static_cast<char>(other[i] ^ 0x40);
    hashes.insert(app::hash_of(other));
  }
  std::string mirrored = bytes;
  for (const std::size_t sign : {7, 15}) mirrored[sign] = static_cast<char>(mirrored[sign] ^ 0x80);
  hashes.insert(app::hash_of(mirrored));
  EXPECT_EQ(hashes.size(), bytes.size() + 3);
}

}  // namespace
