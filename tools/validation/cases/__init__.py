"""Every case, in the order of the report."""

from . import (balance, cost, drag, frames, immersion, motion, spin, stability, towing, tilt,
               waves)

kCases = [
    *immersion.kCases, *tilt.kCases, *drag.kCases, *spin.kCases, *towing.kCases,
    *balance.kCases, *stability.kCases, *motion.kCases, *frames.kCases, *waves.kCases,
    *cost.kCases,
]
