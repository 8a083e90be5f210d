#pragma once

#include <cstddef>

/// @file
/// Eight numbers at a time.

// Sanitizers cannot follow the loader's choice between clones.
#if defined(__x86_64__) && !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
#define PLIMSOLL_VECTOR_CLONES \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define PLIMSOLL_VECTOR_CLONES
#endif

namespace hydro::bem {

inline constexpr std::size_t kLanes = 8;

/// The alignment of vectors depends on the target processor: structs that hold Lanes state this
/// one.
inline constexpr std::size_t kAligned = kLanes * sizeof(double);

/// Eight numbers, with arithmetic lane by lane. Where registers are narrower, GCC computes with
/// them many times as slowly as with the parts of `lanes-inl.h`.
using Lanes __attribute__((vector_size(kLanes * sizeof(double)))) = double;

}  // namespace hydro::bem
