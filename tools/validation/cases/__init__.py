"""Every case, in the order of the report."""

from . import (added_mass, balance, calibrated, cost, drag, drag_tables, frames, friction,
               immersion, motion, spin, stability, towing, tilt, waves)

kCases = [
    *immersion.kCases, *tilt.kCases, *drag.kCases, *drag_tables.kCases, *calibrated.kCases,
    *friction.kCases, *spin.kCases, *towing.kCases, *added_mass.kCases,
    *balance.kCases, *stability.kCases, *motion.kCases, *frames.kCases, *waves.kCases,
    *cost.kCases,
]
