"""What VectorEnv says about its numbers: Gymnasium's classes where Gymnasium is installed, else ours of the same use.

VectorEnv needs of a space: low, high, shape, dtype, seed(), sample(), contains().
"""

import enum

import numpy

try:
    from gymnasium.spaces import Box
    from gymnasium.vector import AutoresetMode
    from gymnasium.vector import VectorEnv as VectorBase
except ImportError:

    class AutoresetMode(enum.Enum):
        """When a world whose episode is over begins the next one."""

        NEXT_STEP = "NextStep"
        SAME_STEP = "SameStep"
        DISABLED = "Disabled"

    class Box:
        """All arrays of a shape whose numbers lie between `low` and `high`."""

        def __init__(self, low, high, dtype=numpy.float64):
            self.low = numpy.asarray(low, dtype)
            self.high = numpy.asarray(high, dtype)
            self.shape = self.low.shape
            self.dtype = numpy.dtype(dtype)
            self.seed()

        def seed(self, seed=None):
            """Of sample()."""
            self._random = numpy.random.default_rng(seed)

        def sample(self):
            """Evenly spread where both bounds are finite, else normally around the finite one, or 0."""
            low, high = self.low, self.high
            finite = numpy.isfinite(low) & numpy.isfinite(high)
            even = self._random.uniform(numpy.where(finite, low, 0), numpy.where(finite, high, 1))
            tail = self._random.normal(size=self.shape)
            open_ended = numpy.where(numpy.isfinite(low), low + abs(tail), numpy.where(numpy.isfinite(high), high - abs(tail), tail))
            return numpy.where(finite, even, open_ended).astype(self.dtype)

        def contains(self, value):
            """Shape and bounds."""
            value = numpy.asarray(value)
            return value.shape == self.shape and bool(numpy.all((value >= self.low) & (value <= self.high)))

        __contains__ = contains

        def __repr__(self):
            return f"Box(shape={self.shape}, dtype={self.dtype})"

    class VectorBase:
        """Nothing is inherited without Gymnasium."""
