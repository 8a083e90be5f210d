#pragma once

/// @file
/// The vector units that the kernel is compiled for. It has to be included before Highway.

// A vector whose length is not known when compiling (SVE) cannot be a member of a struct; NEON's
// can. Some of the steps between the units of x86-64 are left out: they gain nothing here.
#ifndef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#endif
