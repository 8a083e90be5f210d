"""Scenes as environments of Gymnasium (1.0 or later): one, and a batch of them.

Without Gymnasium installed the classes work by themselves, with spaces of their own.
"""

from __future__ import annotations

from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from plimsoll._core import Batch, Scene, Simulation, SimulationError
from plimsoll._spaces import HAS_GYMNASIUM, AutoresetMode, Box, EnvBase, VectorEnvBase, batched

__all__ = ["HAS_GYMNASIUM", "AutoresetMode", "Box", "Env", "VectorEnv"]

FloatArray = npt.NDArray[np.float64]
BoolArray = npt.NDArray[np.bool_]
#: Names of set points, or their bounds by name.
Actions = Union[Sequence[str], Mapping[str, Tuple[float, float]]]
#: Bounds of keys, or functions that draw their values.
Vary = Mapping[str, Union[Tuple[float, float], Callable[[np.random.Generator], Any]]]


class Env(EnvBase):  # type: ignore[misc]
    """An environment: a simulation that actions drive.

    scene               a Scene, a path or a dict
    actions             set points that an action sets, in the units of their names: names, whose
                        bounds are low and high, or {name: (lowest, highest)}
    observations        what a controller sees, of Simulation.observables, in the units of the names
    reward(sim, action) after the steps of an action; by default 0
    done(sim)           whether the episode has reached its end; by default never
    vary                keys of the scene that each episode draws anew: {key: (lowest, highest)}, of
                        whole numbers a whole number, or {key: function of a numpy.random.Generator}
    steps               steps of the simulation in a step of the environment
    duration            time after which an episode is truncated [s]; by default the scene's
    seed                where the random numbers of `vary` begin, as that of reset()
    threads             how many compute
    camera, size        of the pictures with render_mode="rgb_array", as in Simulation.render

    An episode whose simulation fails is terminated; `info["error"]` has the reason.
    `simulation` is that of the present episode.
    """

    def __init__(
        self,
        scene: Any,
        actions: Actions,
        observations: Sequence[str],
        *,
        reward: Optional[Callable[[Simulation, FloatArray], float]] = None,
        done: Optional[Callable[[Simulation], bool]] = None,
        low: Optional[npt.ArrayLike] = None,
        high: Optional[npt.ArrayLike] = None,
        vary: Optional[Vary] = None,
        steps: int = 1,
        duration: Optional[float] = None,
        seed: Optional[int] = None,
        threads: int = 1,
        render_mode: Optional[str] = None,
        camera: Union[None, str, Mapping[str, Any]] = None,
        size: Optional[Tuple[int, int]] = None,
    ) -> None:
        super().__init__()
        if render_mode not in (None, "rgb_array"):
            raise ValueError(f"render_mode: found {render_mode!r}, expected None or 'rgb_array'")
        self._scene = scene if isinstance(scene, Scene) else Scene(scene)
        self._threads, self._reward, self._done, self._vary = threads, reward, done, dict(vary or {})
        self._steps, self._camera, self._size = steps, camera, size
        self._duration = self._scene.duration if duration is None else duration
        self._actions, self._observations = list(actions), list(observations)
        self.action_space = _space_of(actions, low, high)
        self.render_mode = render_mode
        self.metadata = {
            "render_modes": ["rgb_array"],
            "render_fps": 1 / (steps * self._scene.step),
        }
        self.simulation = Simulation(self._scene, threads=threads, forces=False)
        for name in self._actions:
            self.simulation.control[name]  # An unknown name is a KeyError now.
        seen = np.full(self._seen().shape, np.inf)
        self.observation_space = Box(-seen, seen, dtype=np.float64)
        super().reset(seed=seed)

    def reset(
        self, *, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None
    ) -> Tuple[FloatArray, Dict[str, Any]]:
        """Begin a new episode."""
        super().reset(seed=seed)
        if self._vary:
            drawn = Scene(self._scene, set=_drawn(self._vary, self.np_random))
            self.simulation = Simulation(drawn, threads=self._threads, forces=False)
        else:
            self.simulation.reset()
        return self._seen(), {}

    def step(self, action: FloatArray) -> Tuple[FloatArray, float, bool, bool, Dict[str, Any]]:
        """Take a step; see Gymnasium."""
        action = np.asarray(action, dtype=float)
        if action.shape != self.action_space.shape or np.isnan(action).any():
            raise ValueError(f"an action is {len(self._actions)} numbers, found {action}")
        for name, value in zip(self._actions, action):
            self.simulation.control[name] = float(value)
        info: Dict[str, Any] = {}
        try:
            self.simulation.step(self._steps)
        except SimulationError as error:
            info["error"] = str(error)
        reward = 0.0 if self._reward is None else float(self._reward(self.simulation, action))
        over = "error" in info or (self._done is not None and bool(self._done(self.simulation)))
        late = self.simulation.time >= self._duration - 1e-9
        return self._seen(), reward, over, bool(late and not over), info

    def render(self) -> Optional[npt.NDArray[np.uint8]]:
        """Return a picture without text, (height, width, 3), with render_mode="rgb_array"."""
        if self.render_mode is None:
            return None
        return self.simulation.render(camera=self._camera, size=self._size, overlay=False)

    def close(self) -> None:
        """Do nothing: the simulation goes when nobody keeps it."""

    def _seen(self) -> FloatArray:
        return self.simulation.observe(self._observations)


class VectorEnv(VectorEnvBase):  # type: ignore[misc]
    """Environments that share a batch: one for each of its n simulations.

    batch                    a Batch, or a scene of which one of n simulations [1] is made
    observe(batch)           what a controller sees, (n, observations); by default the observations
    reward(batch, actions)   after the steps of an action, (n,); by default 0
    actions                  set points that an action sets, as in Env; by default all
    observations             what a controller sees, as in Env; of a Batch by default what it
                             observes
    done(batch)              mask of the episodes that have reached their end, (n,); by default none
    act(batch, actions)      hands the actions over; by default to the set points
    begin(batch, which, rng) changes the states at which the episodes `which` begin; by default none
    vary                     keys of the scene that each episode draws anew, as in Env
    low, high                bounds of an action, (actions,)
    steps                    steps of the simulation in a step of the environment
    duration                 time after which an episode is truncated [s]; by default the scene's,
                             of a Batch never
    autoreset                when the next episode begins: "NextStep", "SameStep", or "Disabled",
                             where reset(options={"reset_mask": mask}) begins it
    seed                     where the random numbers of `vary` and `begin` begin
    threads                  how many compute, 0 for all cores; that of a Batch is its own

    An episode whose simulation fails is terminated; `info["error"]` has the reason.
    """

    def __init__(
        self,
        batch: Any,
        observe: Optional[Callable[[Batch], FloatArray]] = None,
        reward: Optional[Callable[[Batch, FloatArray], FloatArray]] = None,
        *,
        n: Optional[int] = None,
        actions: Optional[Actions] = None,
        observations: Optional[Sequence[str]] = None,
        low: Optional[npt.ArrayLike] = None,
        high: Optional[npt.ArrayLike] = None,
        done: Optional[Callable[[Batch], BoolArray]] = None,
        act: Optional[Callable[[Batch, FloatArray], None]] = None,
        begin: Optional[Callable[[Batch, npt.NDArray[np.int64], np.random.Generator], None]] = None,
        vary: Optional[Vary] = None,
        steps: int = 1,
        duration: Optional[float] = None,
        autoreset: str = "NextStep",
        seed: Optional[int] = None,
        threads: Optional[int] = None,
    ) -> None:
        limit = np.inf
        if observe is not None and observations is not None:
            raise ValueError("give observations or observe(batch), not both")
        if not isinstance(batch, Batch):
            scene = batch if isinstance(batch, Scene) else Scene(batch)
            made = Batch(scene, n or 1, threads=threads or 0, observe=list(observations or ()))
            batch, limit = made, scene.duration
        elif n is not None or threads is not None:
            raise ValueError("n and threads are for a scene: a batch has its own")
        self.batch = batch
        self.num_envs = len(batch)
        self.metadata: Dict[str, Any] = {"autoreset_mode": AutoresetMode(autoreset)}
        self.render_mode: Optional[str] = None
        self._observe = observe or _by_name(batch, observations)
        self._reward, self._done, self._begin, self._vary = reward, done, begin, dict(vary or {})
        names = batch.set_points if actions is None else list(actions)
        space = _space_of(names if actions is None else actions, low, high, free=act is not None)
        self._act = act or _to_controls([batch.set_point(name) for name in names])
        self._steps, self._duration = steps, limit if duration is None else duration
        self._over = np.zeros(self.num_envs, dtype=bool)
        self._rng = np.random.default_rng(seed)
        self.single_action_space = space
        seen = np.full(self._seen().shape[1:], np.inf)
        self.single_observation_space = Box(-seen, seen, dtype=np.float64)
        self.action_space = batched(self.single_action_space, self.num_envs)
        self.observation_space = batched(self.single_observation_space, self.num_envs)

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
        actions = np.asarray(actions, dtype=float)
        if actions.shape != self.action_space.shape:
            raise ValueError(f"actions are {self.action_space.shape} numbers, found {actions.shape}")
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
        earned = np.zeros(self.num_envs) if self._reward is None else self._reward(self.batch, actions)
        reward = np.where(stepped, earned, 0.0)
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
        drawn = [_drawn(self._vary, self._rng) for _ in which]
        self.batch.reset(which, vary={key: [one[key] for one in drawn] for key in self._vary})
        if self._begin is not None:
            self._begin(self.batch, which, self._rng)
        self._over[which] = False


def _space_of(
    actions: Actions, low: Optional[npt.ArrayLike], high: Optional[npt.ArrayLike], free: bool = False
) -> Box:
    """Return the space of actions, with bounds by name, or those of low and high for each.

    free: the actions are no set points, so low and high alone tell how many there are.
    """
    if isinstance(actions, Mapping):
        if low is not None or high is not None:
            raise ValueError("actions have bounds by name: low and high are for a list of names")
        bounds = np.array(list(actions.values()), dtype=float).reshape(-1, 2)
        return Box(bounds[:, 0], bounds[:, 1], dtype=np.float64)
    if low is None or high is None:
        raise ValueError("actions need bounds: {name: (lowest, highest)}, or low and high")
    ends = [np.atleast_1d(np.asarray(end, dtype=float)) for end in (low, high)]
    if not free:
        ends = [np.broadcast_to(end, (len(actions),)).copy() for end in ends]
    return Box(ends[0], ends[1], dtype=np.float64)


def _drawn(vary: Vary, rng: np.random.Generator) -> Dict[str, Any]:
    """Draw a value of each key."""
    values: Dict[str, Any] = {}
    for key, how in vary.items():
        if callable(how):
            values[key] = how(rng)
        elif all(isinstance(end, (int, np.integer)) for end in how):
            values[key] = int(rng.integers(int(how[0]), int(how[1]), endpoint=True))
        else:
            values[key] = float(rng.uniform(*how))
    return values


def _by_name(batch: Batch, observations: Optional[Sequence[str]]) -> Callable[[Batch], FloatArray]:
    """Return what hands over some of a batch's observations."""
    if not batch.observed:
        raise ValueError("there is nothing to observe: give observations, or observe(batch)")
    unknown = set(observations or ()) - set(batch.observed)
    if unknown:
        raise ValueError(f"the batch does not observe {', '.join(sorted(unknown))}: make it with observe=[…]")
    columns: List[int] = [batch.observed.index(name) for name in observations or batch.observed]
    return lambda batch: batch.observation[:, columns]


def _to_controls(columns: List[int]) -> Callable[[Batch, FloatArray], None]:
    def act(batch: Batch, actions: FloatArray) -> None:
        if np.isnan(actions).any():
            raise ValueError("an action is not a number")
        batch.control[:, columns] = actions

    return act
