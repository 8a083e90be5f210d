#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/base/rig_readings.h"
#include "engine/base/rig_spec.h"
#include "hydro/sea.h"

/// @file
/// Lines, points and rods as MoorDyn v2 computes them: masses on springs in the water. Only
/// moordyn_library.cpp uses that library. A program built without it has moordyn_absent.cpp
/// instead, where the constructor throws MoorDynFault.

namespace engine {

/// Says why this program has no MoorDyn and how to get it; empty if it has.
std::string why_no_moordyn();

/// The version of the library, as `2.7.1`; empty without it.
std::string moordyn_version();

/// A failure of MoorDyn to read or compute something, in its words.
class MoorDynFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The surroundings of a system of MoorDyn. Its z counts from the still water.
struct MoorDynSurroundings {
  double gravity = 0;  ///< [m/s^2]
  const hydro::Sea* sea =
      nullptr;  ///< Null: the file gives water and bottom, its z are those of W.
};

/// A coupled point at an instant, in W.
struct PointMotion {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();     ///< [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< [m/s]
};

/// How lines hold an end against a sudden motion: no less than they do.
struct EndHold {
  double stiffness = 0;  ///< Sum of EA/l, l the length of a segment [N/m].
  double damping = 0;    ///< Sum of 2 √(EA m'), m' the mass per length, water included [kg/s].
};

/// A system of MoorDyn. All options of its file count but a few: gravity is that of the
/// surroundings, density and a finite depth are those of their sea, and MoorDyn writes no files.
/// With `1 WaveKin` the lines feel the waves and the current of the sea; otherwise what the file
/// says. Files that it names lie beside it.
///
/// Only coupled points may be coupled, no rods and bodies; lines must not be told to fail.
class MoorDynSystem {
 public:
  /// Reads a file, so that its points and lines are known.
  /// @param text   Content of the file.
  /// @throws MoorDynFault
  MoorDynSystem(const std::filesystem::path& file, const std::string& text,
                const MoorDynSurroundings& surroundings);
  ~MoorDynSystem();
  MoorDynSystem(const MoorDynSystem&) = delete;
  MoorDynSystem& operator=(const MoorDynSystem&) = delete;

  /// Warnings of MoorDyn from reading the file, a line each.
  const std::vector<std::string>& warnings() const;
  /// Places of the coupled points as the file has them [m].
  const std::vector<Eigen::Vector3d>& coupled_points() const;
  /// The lines in the order of the file.
  const std::vector<MoorDynSpec::Line>& lines() const;

  /// Finds the rest of all lines with the coupled points in these places, in W [m].
  /// @throws MoorDynFault
  void start(const std::vector<Eigen::Vector3d>& places);

  // After start().

  /// Moves the coupled points from a time on [s], smoothly: on cubics in time that have these
  /// motions at both ends of the time h [s]. @throws MoorDynFault
  void step(const std::vector<PointMotion>& from, const std::vector<PointMotion>& to, double time,
            double h);

  /// Forces on what the coupled points are fixed to, in W [N].
  std::vector<Eigen::Vector3d> forces() const;
  /// How each coupled point is held against a sudden motion.
  std::vector<EndHold> holds() const;
  /// The lines in the order of the file. The first end is end B, or end A where only that is at a
  /// coupled point; the tension and the force are those that it exerts on its point.
  std::vector<LineReading> readings() const;

  /// Everything that changes. The numbers are those of MoorDyn; it goes on from them as it went on
  /// before, as far as its own records do.
  std::vector<std::uint64_t> save() const;
  /// @param data   As that of save().
  void load(const std::vector<std::uint64_t>& data);

 private:
  struct Library;
  std::unique_ptr<Library> library_;
};

}  // namespace engine
