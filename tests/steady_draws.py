"""Draws of Hypothesis that depend on their seed alone.

By itself, Hypothesis also draws the constants of all imported modules of a project. Then a seed draws other devices
after each change of the compiler, and beside other tests.
"""

from __future__ import annotations

from typing import Any

from hypothesis import HealthCheck, Phase, settings
from hypothesis.internal.conjecture.providers import AVAILABLE_PROVIDERS, HypothesisProvider

BACKEND = "steady"


class SteadyProvider(HypothesisProvider):
    """Draws the ends of integers and their neighbours now and then, in place of constants."""

    def _maybe_draw_constant(self, choice_type: Any, constraints: Any, *, p: float = 0.05) -> Any:
        assert self._random is not None
        if choice_type != "integer" or self._random.random() > p:
            return None
        low, high = constraints["min_value"], constraints["max_value"]
        ends = [number for number in (low, high, 0, 1) if number is not None]
        ends += [end + step for end in ends for step in (-1, 1)]
        return self._random.choice(
            [end for end in ends if (low is None or low <= end) and (high is None or end <= high)] or [None]
        )


AVAILABLE_PROVIDERS[BACKEND] = "steady_draws.SteadyProvider"


def steady(examples: int, *phases: Phase) -> settings:
    """Settings that draw so many examples from a seed, each time the same ones."""
    return settings(
        max_examples=examples,
        database=None,
        deadline=None,
        backend=BACKEND,
        phases=phases,
        suppress_health_check=list(HealthCheck),
        derandomize=False,
        report_multiple_bugs=False,
    )
