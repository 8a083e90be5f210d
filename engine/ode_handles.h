#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>

/// @file
/// The Open Dynamics Engine (ODE) at arm's length: its library session, what it reports, handles
/// that free its objects, and the layout of its matrices. No ODE header is included here.

struct dxWorld;
struct dxSpace;
struct dxBody;
struct dxGeom;
struct dxJoint;
struct dxJointGroup;
struct dxTriMeshData;
struct dxThreadingImplementation;

namespace engine {

/// What ODE says when it stops: an error or an assertion of its own.
class OdeFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Makes ODE ready for use by the calling thread; cheap when it is already.
///
/// The library is opened once per process and closed at its end. From then on its errors and
/// assertions, which by default end the process, throw OdeFault out of the call that met them. That
/// call is left half done: its world can only be destroyed, and the library is not closed any more.
void open_ode();

/// Takes the last warning that ODE gave on this thread; empty if there was none since the last
/// call. ODE warns when its constraint solver gives up on a step, whose result is then not to be
/// used.
std::string take_ode_warning();

struct WorldDeleter {
  void operator()(dxWorld* world) const;
};
struct SpaceDeleter {
  void operator()(dxSpace* space) const;
};
struct JointGroupDeleter {
  void operator()(dxJointGroup* group) const;
};
struct ThreadingDeleter {
  void operator()(dxThreadingImplementation* threading) const;
};
struct TriMeshDataDeleter {
  void operator()(dxTriMeshData* data) const;
};

/// Frees its bodies and the joints that are in no group.
using WorldHandle = std::unique_ptr<dxWorld, WorldDeleter>;
/// Frees its geometries.
using SpaceHandle = std::unique_ptr<dxSpace, SpaceDeleter>;
/// Frees its joints; must go before their world.
using JointGroupHandle = std::unique_ptr<dxJointGroup, JointGroupDeleter>;
/// Must go after the worlds that use it.
using ThreadingHandle = std::unique_ptr<dxThreadingImplementation, ThreadingDeleter>;
using TriMeshDataHandle = std::unique_ptr<dxTriMeshData, TriMeshDataDeleter>;

/// ODE's dMatrix3: 3 rows of 4, the last of each row unused.
std::array<double, 12> to_ode(const Eigen::Matrix3d& matrix);
/// ODE's dQuaternion: w, x, y, z.
std::array<double, 4> to_ode(const Eigen::Quaterniond& quaternion);

/// From ODE's dVector3 (its first three numbers).
Eigen::Vector3d vector_from_ode(const double* vector);
/// From ODE's dQuaternion (4 numbers).
Eigen::Quaterniond quaternion_from_ode(const double* quaternion);

}  // namespace engine
