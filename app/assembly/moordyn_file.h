#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>
#include <vector>

/// @file
/// Input files for MoorDyn v2: the sections LINE TYPES, POINTS and LINES.

namespace assembly {

/// A line of the file, with what its type says.
struct MoorDynLine {
  std::string id;                   ///< Its number in the file.
  int first = 0, second = 0;        ///< Indices of its points: AttachA and AttachB.
  double length = 0;                ///< Unstretched [m].
  int segments = 0;                 ///< Number of its segments.
  double diameter = 0;              ///< [m]
  double mass = 0;                  ///< Per length in air [kg/m].
  double stiffness = 0;             ///< EA [N].
  double drag = 0, drag_along = 0;  ///< Cd, CdAx [-].
  double added_mass = 0;            ///< Ca [-].
};

/// A point that holds the ends of lines.
struct MoorDynPoint {
  bool coupled = false;                          ///< On a body; otherwise in the world.
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< As the file has it [m].
};

struct MoorDynFile {
  std::vector<MoorDynPoint> points;
  std::vector<MoorDynLine> lines;
  std::vector<std::string> left_out;  ///< What the file asks for that is not computed.
};

/// What a file says that cannot be read or is not supported, with the number of its line.
class MoorDynFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads the text of a file.
/// @throws MoorDynFault for rods, bodies, free points and failures, and for what is no such file
MoorDynFile read_moordyn(const std::string& text);

}  // namespace assembly
