#include "hydro/loads/kernel/water_samples.h"

#include "hydro/loads/kernel/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hydro/loads/kernel/water_samples.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

#include "hydro/loads/kernel/local_sea-inl.h"
#include "hydro/loads/kernel/sea_table_sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hydro::kernel::HWY_NAMESPACE {

/// Calls at_places(r, put) for places in lanes; put(row, value) takes a row of the samples there.
template <class AtPlaces>
HWY_INLINE void for_places(const Eigen::Matrix3Xd& r, double* samples, int rows,
                           AtPlaces&& at_places) {
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d)), count = static_cast<int>(r.cols());
  alignas(64) double lane[3][kMostLanes];
  for (int first = 0; first < count; first += lanes) {
    const int some = std::min(lanes, count - first);
    for (int i = 0; i < lanes; ++i)
      for (int axis = 0; axis < 3; ++axis) lane[axis][i] = r(axis, first + std::min(i, some - 1));
    const V3 place = {hn::Load(d, lane[0]), hn::Load(d, lane[1]), hn::Load(d, lane[2])};
    at_places(place, [&](int row, V value) HWY_ATTR {
      hn::Store(value, d, lane[0]);
      for (int i = 0; i < some; ++i) samples[rows * (first + i) + row] = lane[0][i];
    });
  }
}

template <Ask kAsk>
HWY_INLINE void set_table_over(const Node& box, const LoadInputs& in, LocalSea& sea) {
  if (!in.surface->table.pays || !plan_table<kAsk>(box, in, sea.wide)) return;
  set_table<kAsk>(box, in, sea.wide);
  sea.table = &sea.wide;
}

void elevation_here(const LoadInputs& in, const Node& box, const Eigen::Matrix3Xd& r,
                    double* samples) {
  LocalSea sea(in);
  set_table_over<Ask::elevation>(box, in, sea);
  for_places(r, samples, 1,
             [&](const V3& place, auto&& put) HWY_ATTR { put(0, rise_at(in, sea, place)); });
}

void velocity_here(const LoadInputs& in, const Node& box, const Eigen::Matrix3Xd& r,
                   double* samples) {
  LocalSea sea(in);
  set_table_over<Ask::velocity>(box, in, sea);
  for_places(r, samples, 3, [&](const V3& place, auto&& put) HWY_ATTR {
    const V rise = rise_at(in, sea, place), depth = depth_below(in, rise, place);
    const Water water = water_at<Ask::velocity>(in, place, depth, rise, sea);
    put(0, water.u.x);
    put(1, water.u.y);
    put(2, water.u.z);
  });
}

}  // namespace hydro::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hydro::kernel {

HWY_EXPORT(elevation_here);
HWY_EXPORT(velocity_here);

Eigen::VectorXd sample_elevation(const LoadInputs& in, const Node& box, const Eigen::Matrix3Xd& r) {
  Eigen::VectorXd samples(r.cols());
  HWY_DYNAMIC_DISPATCH(elevation_here)(in, box, r, samples.data());
  return samples;
}

Eigen::Matrix3Xd sample_velocity(const LoadInputs& in, const Node& box, const Eigen::Matrix3Xd& r) {
  Eigen::Matrix3Xd samples(3, r.cols());
  HWY_DYNAMIC_DISPATCH(velocity_here)(in, box, r, samples.data());
  return samples;
}

}  // namespace hydro::kernel
#endif
