# find_package(plimsoll) gives plimsoll::hydro, the loads of the water; plimsoll::engine, bodies that
# move under them; plimsoll::scene, which reads scenes; and plimsoll::assembly, which makes of a scene
# what the engine takes.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
find_dependency(TBB)
find_dependency(fmt)
find_dependency(yaml-cpp)
find_dependency(assimp)
find_dependency(PNG)
find_dependency(PkgConfig)
pkg_check_modules(ODE QUIET IMPORTED_TARGET ode)
pkg_check_modules(HIGHWAY QUIET IMPORTED_TARGET libhwy)
if(NOT ODE_FOUND OR NOT HIGHWAY_FOUND)
  set(plimsoll_FOUND FALSE)
  set(plimsoll_NOT_FOUND_MESSAGE "libode-dev and libhwy-dev are needed")
  return()
endif()
include(${CMAKE_CURRENT_LIST_DIR}/plimsoll-targets.cmake)
