#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>

/// @file
/// The Open Dynamics Engine (ODE): its library session and faults, handles that own its objects,
/// and the layout of its vectors and matrices. No ODE header is included here.

struct dxWorld;
struct dxSpace;
struct dxBody;
struct dxGeom;
struct dxJoint;
struct dxJointGroup;
struct dxTriMeshData;

namespace engine {

/// An error of ODE, or a failed assertion in it.
class OdeFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Makes ODE ready for use by the calling thread; cheap if it is ready already.
///
/// The library is opened once per process and closed at its end. Its errors and assertions, which
/// by default end the process, throw OdeFault out of the call that met them. The interrupted call
/// leaves a world that can only be destroyed, and the library is never closed.
void open_ode();

/// Takes the last warning of ODE on this thread; empty if there was none since the last call. ODE
/// warns when its constraint solver gives up on a step, whose result is then invalid.
std::string take_ode_warning();

/// A joint's feedback, ODE's dJointFeedback: force and torque on its first and second body.
struct OdeFeedback {
  double f1[4], t1[4], f2[4], t2[4];
};

struct OdeDeleter {
  void operator()(dxWorld* world) const;
  void operator()(dxSpace* space) const;
  void operator()(dxJointGroup* group) const;
  void operator()(dxTriMeshData* data) const;
};

/// Frees its bodies and the joints that are in no group.
using WorldHandle = std::unique_ptr<dxWorld, OdeDeleter>;
/// Frees its geometries.
using SpaceHandle = std::unique_ptr<dxSpace, OdeDeleter>;
/// Frees its joints; it must be destroyed before their world.
using JointGroupHandle = std::unique_ptr<dxJointGroup, OdeDeleter>;
using TriMeshDataHandle = std::unique_ptr<dxTriMeshData, OdeDeleter>;

/// ODE's dMatrix3: 3 rows of 4, the last of each row unused.
std::array<double, 12> to_ode(const Eigen::Matrix3d& matrix);
/// ODE's dQuaternion: w, x, y, z.
std::array<double, 4> to_ode(const Eigen::Quaterniond& quaternion);

/// From ODE's dVector3 (its first three numbers).
Eigen::Vector3d vector_from_ode(const double* vector);
/// From ODE's dQuaternion (4 numbers).
Eigen::Quaterniond quaternion_from_ode(const double* quaternion);

}  // namespace engine
