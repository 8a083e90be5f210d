"""Every case, in the order of the report."""

from . import (added_mass, balance, bluff, calibrated, cost, drag, frames, friction, immersion,
               motion, spin, stability, towing, tilt, waves, wind)

kCases = [
    *immersion.kCases, *tilt.kCases, *drag.kCases, *bluff.kCases, *calibrated.kCases,
    *friction.kCases, *spin.kCases, *towing.kCases, *added_mass.kCases,
    *balance.kCases, *stability.kCases, *motion.kCases, *frames.kCases, *waves.kCases,
    *wind.kCases, *cost.kCases,
]
