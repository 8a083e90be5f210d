"""Every case, in the order of the report."""

from . import (added_mass, balance, calibrated, cost, decay, drag, drag_tables, drift, frames,
               friction, immersion, motion, seakeeping, spin, stability, towing, tilt, under_way,
               wave_forces, wave_motions, waves, wind)

kCases = [
    *immersion.kCases, *tilt.kCases, *drag.kCases, *drag_tables.kCases, *drift.kCases,
    *calibrated.kCases, *friction.kCases, *spin.kCases, *towing.kCases, *added_mass.kCases,
    *balance.kCases, *stability.kCases, *motion.kCases, *frames.kCases, *waves.kCases,
    *wave_forces.kCases, *wave_motions.kCases, *seakeeping.kCases, *under_way.kCases,
    *decay.kCases, *wind.kCases, *cost.kCases,
]
