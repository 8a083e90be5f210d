#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <vector>

#include "hydro/loads/kernel/panels.h"
#include "hydro/loads/kernel/shear.h"
#include "hydro/loads/refine.h"
#include "hydro/sea.h"
#include "hydro/spatial.h"

/// @file
/// The surface of a sea that is not flat, or whose current changes with depth, as the kernel reads
/// it: its elevation at one time is a function of the place on the body, in body axes about the
/// centre of mass.

namespace hydro::kernel {

/// Linear waves Σ amplitude·cos(k·r + phase). Waves of amplitude 0 make their number a multiple of
/// eight.
struct WaveField {
  static constexpr int kRoom = 128;

  /// The rows. Waves without Airy's kinematics have the first five.
  enum : int {
    kAmplitude = 0,  ///< [m]
    kVector = 1,     ///< k_x, k_y, k_z [rad/m].
    kPhase = 4,      ///< [rad]
    kNumber = 5,     ///< |k| [rad/m].
    kFlow = 6,       ///< k_x, k_y, k_z times g/σ [1/s].
    kUpward = 9,     ///< |k| times g/σ [1/s].
    kWeight = 10,    ///< 1/(1 + e^{−2kh}) [-].
    kEast = 11,      ///< k_x, k_y of the world [rad/m].
    kSpeed = 13,     ///< g/σ [m/s].
    kRows
  };

  std::array<double, kRows * kRoom> few;
  std::vector<double> many;  ///< Holds the rows where `few` is too small.
  const double* row[kRows] = {};
  int count = 0;
  bool airy = false;        ///< The water moves below the waves, and its pressure decays.
  bool deep = true;         ///< The waves feel no bottom.
  double water_depth = 0;   ///< Depth of the still water, where it is not deep [m].
  double height = 0;        ///< A bound of the elevation [m].
  double least_number = 0;  ///< The least k of a wave [rad/m].
  /// Bounds of the derivatives of order n from 1: Σ |amplitude| k^n, or kFarCrest standard
  /// deviations of the derivative where that is less [m^(1−n)].
  double bends[4] = {};
  double flow[4] = {};  ///< The same of the velocity, with |amplitude| g/σ.
};

/// A grid of heights. The elevation is bilinear between them; a place r lies at column
/// u = e_x·r + u_0 and row v = e_y·r + v_0.
struct GridField {
  const double* heights = nullptr;  ///< The heights, column by column [m].
  std::int64_t rows = 0, columns = 0;
  double e_x[3] = {}, e_y[3] = {};  ///< [1/m]
  double u0 = 0, v0 = 0;            ///< The column and row of the centre of mass.
  double cell = 1;                  ///< Distance of neighbouring lines [m].
  double bend = 0;                  ///< Largest second difference of neighbouring heights [m].
};

/// The most nodes along a side of a table of the sea (sea_table-inl.h).
inline constexpr int kMostTableNodes = 12;

/// The numbers that tell how many nodes a table of the sea needs.
struct TableLimits {
  /// By the number of nodes n, for sides of half length h along x, y and the depth: the root mean
  /// square of what the table misses of the head is error · h^n [m]. It is infinite for more nodes
  /// than any branch of the hull needs.
  double error[3][kMostTableNodes + 1] = {};
  double allowed = 0;  ///< Error that it may make [m].
  int most_nodes = 0;  ///< With more, the sum over all waves takes less time.
  bool pays = false;   ///< There are enough waves.
};

/// A sea as one hull feels it, prepared for its sums: what depends on neither pose nor time. It
/// refers to the sea and to itself, so it is neither copied nor moved.
class FeltSea {
 public:
  /// The numbers that split the hull's edges.
  struct Splits {
    BendLimits limits;   ///< Without those of the current.
    bool bends = false;  ///< The surface may bend over some edge of the hull.
    TableLimits table;
  };

  /// @param sea        It must outlive this, and not change.
  /// @param smallest   As for SurfaceSampler.
  /// @param error      As for SurfaceSampler. With it, waves that are too weak are left out.
  /// @param uses       Uses of the surfaces of this sea.
  FeltSea(const Sea& sea, double smallest, double longest_edge,
          const std::optional<HeadError>& error, std::initializer_list<SplitFor> uses);
  FeltSea(const FeltSea&) = delete;
  FeltSea& operator=(const FeltSea&) = delete;

  const Sea& all() const { return all_; }
  /// The sea without the waves that are left out.
  const Sea& felt() const { return felt_ ? *felt_ : all_; }
  const SurfaceBounds& bounds() const { return bounds_; }  ///< Bounds of all of the sea.
  const SurfaceBounds& felt_bounds() const { return felt_bounds_; }
  double smallest() const { return smallest_; }
  /// The waves that are felt, with their full amplitudes and without a place.
  const WaveField& waves() const { return waves_; }
  const Splits& splits(SplitFor what) const;
  /// True if another sea has the same water and waves.
  bool is_like(const Sea& sea) const;

 private:
  const Sea& all_;
  std::optional<Sea> felt_;
  double smallest_;
  SurfaceBounds bounds_, felt_bounds_;
  WaveField waves_;
  std::optional<Splits> for_surface_, for_head_;  ///< Splits of the uses.
};

/// The surface around a body. It refers to the sea and to itself, so it is neither copied nor
/// moved.
class WaterSurface {
 public:
  /// @param felt   It must outlive this.
  /// @param what   One of its uses. Without `current` the water has no shear.
  WaterSurface(const FeltSea& felt, const BodyState& state, double time, SplitFor what);
  WaterSurface(const WaterSurface&) = delete;
  WaterSurface& operator=(const WaterSurface&) = delete;

  WaveField waves;  ///< They have no component where the sea is a grid.
  GridField grid;
  Shear shear;
  double lowest = 0, highest = 0;  ///< Bounds of the elevation [m].
  double gravity = 0;              ///< [m/s^2]
  double hidden_depth = 0;  ///< Part of the true depth that `LoadInputs::below` leaves out [m].
  bool bends = false;       ///< It may bend over some edge of the hull.
  BendLimits limits;        ///< These tell which edge has to be.
  TableLimits table;
  double east[3] = {}, north[3] = {};  ///< The directions of x and y of the world, in body axes.

  bool is_grid() const { return grid.heights != nullptr; }
  /// True if the water has a motion of its own, by Airy waves or by a table of the current.
  bool is_airy() const { return waves.airy || shear.moves; }
  /// True if some edge of the hull may have to be split.
  bool splits() const { return bends || !limits.cuts.empty(); }
};

/// The error that the head may have over whole branches [m]: a part of a hull's volume over its
/// area, but no more than that part of the waves' height.
double allowed_wave_error(double part, double volume_over_area, const WaterSurface& surface);

/// Bounds of the elevation over a box of a body [m].
struct ElevationRange {
  double low, high;
};
/// Bounds of a grid's elevation over a box; where the box is large they are those of the whole sea.
ElevationRange grid_over(const WaterSurface& surface, const double* centre, const double* half);

}  // namespace hydro::kernel
