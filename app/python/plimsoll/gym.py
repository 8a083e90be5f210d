"""A batch of simulations as a vector environment of Gymnasium (1.0 or later).

Without Gymnasium installed the class works by itself, with the spaces of this file.
"""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import Any, Callable, Dict, Optional, Tuple

import numpy as np
import numpy.typing as npt

from plimsoll._core import Batch

FloatArray = npt.NDArray[np.float64]
BoolArray = npt.NDArray[np.bool_]

try:
    from gymnasium.spaces import Box
    from gymnasium.vector import AutoresetMode
    from gymnasium.vector import VectorEnv as _Base
    from gymnasium.vector.utils import batch_space as _batched

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

    class _Base:  # type: ignore[no-redef]
        pass

    def _batched(space: Box, n: int) -> Box:
        return Box(np.tile(space.low, (n, 1)), np.tile(space.high, (n, 1)))


class VectorEnv(_Base):  # type: ignore[misc]
    """Environments that share a batch: one for each of its n simulations.

    observe(batch)           what a controller sees, (n, observations)
    reward(batch, actions)   after the steps of an action, (n,)
    done(batch)              mask of the episodes that have reached their end, (n,); by default none
    act(batch, actions)      hands the actions over; by default to `batch.control`
    begin(batch, which, rng) changes the states at which the episodes `which` begin; by default none
    low, high                bounds of an action, (actions,)
    steps                    steps of the simulation in a step of the environment
    duration                 time after which an episode is truncated [s]
    autoreset                when the next episode begins: "NextStep", "SameStep", or "Disabled",
                             where reset(options={"reset_mask": mask}) begins it

    An episode whose simulation fails is terminated; `info["error"]` has the reason.
    """

    def __init__(
        self,
        batch: Batch,
        observe: Callable[[Batch], FloatArray],
        reward: Callable[[Batch, FloatArray], FloatArray],
        *,
        low: npt.ArrayLike,
        high: npt.ArrayLike,
        done: Optional[Callable[[Batch], BoolArray]] = None,
        act: Optional[Callable[[Batch, FloatArray], None]] = None,
        begin: Optional[Callable[[Batch, npt.NDArray[np.int64], np.random.Generator], None]] = None,
        steps: int = 1,
        duration: float = np.inf,
        autoreset: str = "NextStep",
    ) -> None:
        self.batch = batch
        self.num_envs = len(batch)
        self.metadata: Dict[str, Any] = {"autoreset_mode": AutoresetMode(autoreset)}
        self.render_mode: Optional[str] = None
        self._observe, self._reward, self._done, self._begin = observe, reward, done, begin
        self._act = act or _to_controls
        self._steps, self._duration = steps, duration
        self._over = np.zeros(self.num_envs, dtype=bool)
        self._rng = np.random.default_rng()
        bounds = np.atleast_1d(np.asarray(low, dtype=float)), np.atleast_1d(np.asarray(high, dtype=float))
        self.single_action_space = Box(*bounds, dtype=np.float64)
        seen = np.full(self._seen().shape[1:], np.inf)
        self.single_observation_space = Box(-seen, seen, dtype=np.float64)
        self.action_space = _batched(self.single_action_space, self.num_envs)
        self.observation_space = _batched(self.single_observation_space, self.num_envs)

    def reset(
        self, *, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None
    ) -> Tuple[FloatArray, Dict[str, Any]]:
        """Begin new episodes: all, or those of `options["reset_mask"]`."""
        if seed is not None:
            self._rng = np.random.default_rng(seed)
        mask = (options or {}).get("reset_mask")
        self._restart(np.arange(self.num_envs) if mask is None else np.flatnonzero(mask))
        return self._seen(), {}

    def step(
        self, actions: FloatArray
    ) -> Tuple[FloatArray, FloatArray, BoolArray, BoolArray, Dict[str, Any]]:
        """Take a step of each environment; see Gymnasium."""
        actions = np.asarray(actions, dtype=float).reshape(self.num_envs, -1)
        mode = self.metadata["autoreset_mode"]
        stepped = ~self._over
        if mode is AutoresetMode.NEXT_STEP and self._over.any():
            self._restart(np.flatnonzero(self._over))
        self._act(self.batch, actions)
        self.batch.step(self._steps, which=stepped)
        info: Dict[str, Any] = {}
        failed = np.zeros(self.num_envs, dtype=bool)
        errors = self.batch.errors
        if errors:
            failed[list(errors)] = True
            info["error"] = [errors.get(i, "") for i in range(self.num_envs)]
        reward = np.where(stepped, self._reward(self.batch, actions), 0.0)
        terminated = stepped & (failed if self._done is None else failed | self._done(self.batch))
        truncated = stepped & ~terminated & (self.batch.time >= self._duration - 1e-9)
        self._over = np.where(stepped, terminated | truncated, mode is AutoresetMode.DISABLED)
        seen = self._seen()
        if mode is AutoresetMode.SAME_STEP and self._over.any():
            info["final_obs"], info["_final_obs"] = seen, self._over.copy()
            self._restart(np.flatnonzero(self._over))
            seen = self._seen()
        return seen, reward, terminated, truncated, info

    def close(self, **kwargs: Any) -> None:
        """Do nothing: the batch goes when nobody keeps it."""

    def _seen(self) -> FloatArray:
        return np.array(self._observe(self.batch), dtype=float).reshape(self.num_envs, -1)

    def _restart(self, which: npt.NDArray[np.int64]) -> None:
        self.batch.reset(which)
        if self._begin is not None:
            self._begin(self.batch, which, self._rng)
        self._over[which] = False


def _to_controls(batch: Batch, actions: FloatArray) -> None:
    batch.control[:] = actions
