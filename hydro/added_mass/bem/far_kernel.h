#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "hydro/added_mass/bem/pair.h"

/// @file
/// One element against eight at a time: 1/r by points for distant pairs, and what any pair gives to
/// the equations. Compiled for each width of vector registers: operations on single numbers only,
/// in one order, so the results are the same for all of them.

// Sanitizers cannot follow the choice that the loader makes.
#if defined(__x86_64__) && !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
#define PLIMSOLL_VECTOR_CLONES \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define PLIMSOLL_VECTOR_CLONES
#endif

namespace hydro::bem {

inline constexpr std::size_t kLanes = 8;

/// A number for each of eight elements, with the usual operations lane by lane. How such vectors
/// are aligned depends on the processor compiled for, so what holds them says so itself.
inline constexpr std::size_t kAligned = kLanes * sizeof(double);
using Lanes __attribute__((vector_size(kLanes * sizeof(double)))) = double;

/// Eight elements; the last batch is filled up with copies. First index the point or corner, then
/// the axis.
struct alignas(kAligned) Batch {
  Lanes points_3[3][3];  ///< Of the rule of degree 2.
  Lanes points_6[6][3];  ///< Of the rule of degree 4.
  Lanes corners[3][3], curls[3][3];
  Lanes normal[3], centroid[3];
  Lanes area, radius;
};
std::vector<Batch> batches_of(const std::vector<Element>& elements);

/// As PairIntegrals for x on one element and y on those of a batch.
struct alignas(kAligned) LanePairs {
  Lanes hats[3][3];
  Lanes rise[3];
};

/// By 3 × 3 points if all of the batch are farther than kFar (pair.h), by 6 × 6 points else.
void pairs_by_points(const Element& a, const Batch& b, LanePairs& pairs);

/// Puts in one pair that was integrated in another way.
void set_lane(const PairIntegrals& exact, std::size_t lane, LanePairs& pairs);
Eigen::Matrix3d hats_of_lane(const LanePairs& pairs, std::size_t lane);

/// ∫∫ curl φ_k·curl φ_l / r for the functions of galerkin.h on a and on the elements of a batch.
struct alignas(kAligned) LaneCouplings {
  Lanes functions[6][6];
};
void couple(const Element& a, const Batch& b, const LanePairs& pairs, LaneCouplings& couplings);

/// Per hat i of an element, ∫∫ λ_i(x) y nᵀ/r row by row, and last ∫∫ λ_i(x) (n·x)/r, with y and n
/// of the others: summed over batches.
struct alignas(kAligned) LaneSwirls {
  Lanes hats[3][10];
};
void add_swirls(const Batch& b, const LanePairs& pairs, LaneSwirls& swirls);

/// Per hat i of an element T a matrix that gives ∫_T λ_i a dS = matrix · e / 4π for a rotation
/// about e: Σ_T' [(∫∫ λ_i y/r) n'ᵀ − ∫∫ λ_i (n'·x)/r], with x on T and y on T' (galerkin.h).
using Swirl = std::array<Eigen::Matrix3d, 3>;
Swirl summed(const LaneSwirls& swirls);

}  // namespace hydro::bem
