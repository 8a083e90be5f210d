"""Unit quaternions w, x, y, z (body to world), one a row of an array (…, 4)."""

from __future__ import annotations

import numpy as np


def product(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Of quaternions: first q, then p."""
    pw, pv, qw, qv = p[..., :1], p[..., 1:], q[..., :1], q[..., 1:]
    scalar = pw * qw - np.sum(pv * qv, axis=-1, keepdims=True)
    return np.concatenate([scalar, pw * qv + qw * pv + np.cross(pv, qv)], axis=-1)


def conjugate(q: np.ndarray) -> np.ndarray:
    return q * np.array([1.0, -1.0, -1.0, -1.0])


def rotation_vector(q: np.ndarray) -> np.ndarray:
    """Axis times angle [rad], the angle at most a half turn."""
    q = np.where(q[..., :1] < 0, -q, q)
    sine = np.linalg.norm(q[..., 1:], axis=-1, keepdims=True)
    half = np.arctan2(sine, q[..., :1])
    factor = np.divide(2 * half, sine, out=np.full_like(sine, 2.0), where=sine > 0)
    return factor * q[..., 1:]


def from_rotation_vector(r: np.ndarray) -> np.ndarray:
    half = np.linalg.norm(r, axis=-1, keepdims=True) / 2
    return np.concatenate([np.cos(half), np.sinc(half / np.pi) * r / 2], axis=-1)


def rotated(q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Vectors of the body in the world."""
    w, u = q[..., :1], q[..., 1:]
    t = 2 * np.cross(u, v)
    return v + w * t + np.cross(u, t)
