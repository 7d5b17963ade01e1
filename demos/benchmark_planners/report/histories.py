"""How the cost of a run's best solution falls over time: lists of (seconds, cost) in the order of time, each row a
better solution than the one before."""
import bisect
import math

from quantiles import NEVER, quartiles


def cost_at(history, seconds):
    """The best cost by then; infinite before the first solution."""
    rows = bisect.bisect_right(history, (seconds, math.inf))
    return history[rows - 1][1] if rows else NEVER


def time_to(history, cost):
    """When the cost was first at most this; infinite if never."""
    return next((seconds for seconds, reached in history if reached <= cost), NEVER)


def time_to_within(history, best, percent, tolerance=1e-6):
    """When the cost was first within some percent of the best, rounding aside."""
    return time_to(history, best * (1 + percent / 100 + tolerance))


def logarithmic_times(first, last, count):
    """So many moments from the first to the last, evenly spaced on a logarithmic axis."""
    ratio = last / first
    return [first * ratio**(i / (count - 1)) for i in range(count)]


def excess_percent(cost, best):
    """By how much a cost exceeds the best, in percent; never below 0."""
    return NEVER if cost == NEVER else max(0.0, 100 * (cost / best - 1))


def excess_over_time(histories_and_bests, times):
    """Quartiles over runs of the excess at each moment."""
    return [quartiles(excess_percent(cost_at(history, t), best) for history, best in histories_and_bests)
            for t in times]


def solved_over_time(histories, times):
    """Share of the runs that have a solution at each moment."""
    return [sum(1 for history in histories if history and history[0][0] <= t) / len(histories) for t in times]
