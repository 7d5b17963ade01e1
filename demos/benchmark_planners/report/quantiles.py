"""Quantiles of measurements some of which were never reached: a run without an answer counts as infinite."""
import math
from dataclasses import dataclass

NEVER = math.inf


def quantile(values, share):
    """The quantile by linear interpolation between order statistics (type 7 of Hyndman and Fan); infinite as soon as
    an infinite value takes part."""
    ordered = sorted(values)
    if not ordered:
        return math.nan
    position = share * (len(ordered) - 1)
    below = math.floor(position)
    part = position - below
    if part == 0 or ordered[below] == NEVER:
        return ordered[below]
    above = ordered[below + 1]
    return NEVER if above == NEVER else ordered[below] + part * (above - ordered[below])


@dataclass(frozen=True)
class Quartiles:
    """Lower quartile, median and upper quartile."""
    low: float
    median: float
    high: float


def quartiles(values):
    values = list(values)
    return Quartiles(quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75))
