"""Gymnasium's spaces and base classes, or as much of them as the environments need without it."""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import Any, Dict, Optional, Tuple

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]

__all__ = ["HAS_GYMNASIUM", "AutoresetMode", "Box", "EnvBase", "VectorEnvBase", "batched"]

try:
    from gymnasium import Env as EnvBase
    from gymnasium.spaces import Box
    from gymnasium.vector import AutoresetMode
    from gymnasium.vector import VectorEnv as VectorEnvBase
    from gymnasium.vector.utils import batch_space as batched

    HAS_GYMNASIUM = True
except ImportError:
    HAS_GYMNASIUM = False

    class AutoresetMode(enum.Enum):  # type: ignore[no-redef]
        """When an environment whose episode has ended begins the next one."""

        NEXT_STEP = "NextStep"
        SAME_STEP = "SameStep"
        DISABLED = "Disabled"

    @dataclass
    class Box:  # type: ignore[no-redef]
        """Arrays between two bounds."""

        low: FloatArray
        high: FloatArray
        dtype: type = np.float64

        @property
        def shape(self) -> Tuple[int, ...]:
            return self.low.shape

        def contains(self, value: FloatArray) -> bool:
            return value.shape == self.shape and bool(np.all((value >= self.low) & (value <= self.high)))

        def sample(self) -> FloatArray:
            drawn: FloatArray = np.random.default_rng().uniform(self.low, self.high)
            return drawn

    class EnvBase:  # type: ignore[no-redef]
        """The random numbers of an environment."""

        def __init__(self) -> None:
            self.np_random: np.random.Generator = np.random.default_rng()

        def reset(self, *, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None) -> None:
            """Begin the random numbers anew where there is a seed."""
            if seed is not None:
                self.np_random = np.random.default_rng(seed)

    class VectorEnvBase:  # type: ignore[no-redef]
        pass

    def batched(space: Box, n: int) -> Box:
        return Box(np.tile(space.low, (n, 1)), np.tile(space.high, (n, 1)))
