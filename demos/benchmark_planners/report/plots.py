"""The plots, as matplotlib figures without a display."""
import math

import matplotlib
matplotlib.use("Agg")
# pylint: disable=wrong-import-position
from matplotlib import pyplot
from matplotlib.ticker import FixedLocator, FuncFormatter, NullFormatter, NullLocator

from database import PERCENTS
from histories import excess_over_time, logarithmic_times, solved_over_time
from quantiles import NEVER, quartiles
from style import looks
from summary import display_name

FLOOR_PERCENT = 0.01  # less is drawn as this
FIRST_MOMENT = 1e-4   # seconds
MOMENTS = 200
GREY = "#999999"

pyplot.rcParams.update({
    "font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True, "grid.color": "#e4e4e4",
    "grid.linewidth": 0.6, "axes.axisbelow": True, "axes.titlesize": 9, "axes.titlelocation": "left",
    "legend.frameon": False, "svg.hashsalt": "seahex", "figure.constrained_layout.use": True})


def plain_seconds(value, _=None):
    """0.001 s as 1 ms: people think in these."""
    return f"{value:g} s" if value >= 1 else f"{1000 * value:g} ms"


def seconds_axis(axis, first, last):
    axis.set_xscale("log")
    axis.set_xlim(first, last)
    axis.xaxis.set_major_formatter(FuncFormatter(plain_seconds))
    axis.xaxis.set_minor_formatter(NullFormatter())
    axis.xaxis.grid(True, which="major")


def percent_axis(axis):
    """Percent above the best known, logarithmic; its lowest mark stands for all that is less."""
    axis.set_yscale("log")
    axis.set_ylim(FLOOR_PERCENT * 0.8, 100)
    axis.yaxis.set_major_locator(FixedLocator([0.01, 0.1, 1, 10, 100]))
    axis.yaxis.set_minor_locator(NullLocator())
    axis.yaxis.set_major_formatter(FuncFormatter(lambda v, _: f"{v:g}" if v > FLOOR_PERCENT else f"≤ {v:g}"))


def drawable(values):
    """For a logarithmic axis: raised to the floor; what was never reached leaves the axis at its top."""
    return [1e6 if value == NEVER else max(value, FLOOR_PERCENT) for value in values]


class Curves:
    """Cost over time of every planner."""

    def __init__(self, runs, planners, limit):
        self.planners = planners
        self.limit = limit
        self.times = logarithmic_times(FIRST_MOMENT, limit, MOMENTS)
        self.looks = looks(planners)
        self.excess, self.solved = {}, {}
        for planner in planners:
            own = [(run.history, run.best_known) for run in runs if run.planner == planner]
            self.excess[planner] = excess_over_time(own, self.times) if own else []
            self.solved[planner] = solved_over_time([history for history, _ in own], self.times) if own else []

    def median(self, axis, planner, **changes):
        look = self.looks[planner]
        if not self.excess[planner]:
            return
        style = {"color": look.colour, "linestyle": look.dashes, "linewidth": look.width,
                 "drawstyle": "steps-post", "label": display_name(planner), **changes}
        axis.plot(self.times, drawable(q.median for q in self.excess[planner]), **style)

    def band(self, axis, planner):
        if self.excess[planner]:
            axis.fill_between(self.times, drawable(q.low for q in self.excess[planner]),
                              drawable(q.high for q in self.excess[planner]), color=self.looks[planner].colour,
                              alpha=0.22, linewidth=0, step="post")


def cost_over_time(curves):
    """All medians, and how many runs have a solution."""
    figure, (axis, lower) = pyplot.subplots(2, 1, figsize=(9, 6.2), sharex=True, height_ratios=[3, 1])
    for planner in curves.planners:
        curves.median(axis, planner)
        look = curves.looks[planner]
        if curves.solved[planner]:
            lower.plot(curves.times, [100 * share for share in curves.solved[planner]], color=look.colour,
                       linestyle=look.dashes, linewidth=look.width, drawstyle="steps-post")
    percent_axis(axis)
    seconds_axis(lower, FIRST_MOMENT, curves.limit)
    axis.set_title("Length of the best path so far, median over runs and pairs")
    axis.set_ylabel("% above the best known")
    lower.set_ylabel("% solved")
    lower.set_ylim(-3, 103)
    lower.set_xlabel("time")
    axis.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), handlelength=3.2)
    return figure


def cost_over_time_each(curves):
    """A panel a planner: median and quartiles, the others' medians behind."""
    columns = 5
    count = len(curves.planners)
    rows = math.ceil(count / columns)
    figure, axes = pyplot.subplots(rows, columns, figsize=(11, 2.1 * rows + 0.4), sharex=True, sharey=True,
                                   squeeze=False)
    for axis, planner in zip(axes.flat, curves.planners):
        for other in curves.planners:
            if other != planner:
                curves.median(axis, other, color="#d0d0d0", linestyle="-", linewidth=0.7)
        curves.band(axis, planner)
        curves.median(axis, planner, linestyle="-", linewidth=2)
        axis.set_title(display_name(planner))
        percent_axis(axis)
        seconds_axis(axis, FIRST_MOMENT, curves.limit)
        axis.xaxis.set_major_locator(FixedLocator([1e-4, 1e-2, 1]))
    for axis in axes.flat[count:]:
        axis.set_visible(False)
    for axis in axes.flat[max(0, count - columns):count]:
        axis.tick_params(labelbottom=True)
    figure.supylabel("% above the best known", fontsize=9)
    return figure


def boxes(axis, planners, values_of, colours, never=None):
    """Horizontal boxes: quartiles, whiskers to the last value within 1.5 box lengths, all values as dots. What was
    never reached lies at `never`, or is left out where that is None."""
    def drawn(value):
        return never if value == NEVER else value

    for place, planner in enumerate(planners):
        values = [value for value in values_of(planner)
                  if not math.isnan(value) and (never is not None or value != NEVER)]
        if not values:  # nothing to show
            continue
        q = quartiles(values)
        finite = [value for value in values if value != NEVER]
        reach = NEVER if NEVER in (q.low, q.high) else 1.5 * (q.high - q.low)
        lower = min((v for v in finite if v >= q.low - reach), default=drawn(q.low))
        upper = drawn(max(v for v in values if v <= q.high + reach))
        axis.bxp([{"med": drawn(q.median), "q1": drawn(q.low), "q3": drawn(q.high), "whislo": min(lower, drawn(q.low)),
                   "whishi": upper}], positions=[place], vert=False, widths=0.55, showfliers=False, patch_artist=True,
                 boxprops={"facecolor": colours[planner] + "55", "edgecolor": colours[planner]},
                 medianprops={"color": "black", "linewidth": 1.6}, whiskerprops={"color": colours[planner]},
                 capprops={"color": colours[planner]})
        axis.plot([drawn(value) for value in values], spread(place, len(values)), ".", color=colours[planner],
                  markersize=2.5, alpha=0.7)
    axis.set_yticks(range(len(planners)), [display_name(planner) for planner in planners])
    axis.set_ylim(len(planners) - 0.4, -0.6)
    axis.yaxis.grid(False)


def spread(place, count):
    """Heights around a box's middle line, so that dots at one value do not hide each other."""
    return [place + 0.36 * ((i * 0.618034) % 1 - 0.5) for i in range(count)]


def box_figure(planners, panels):
    """Panels side by side with one list of planners."""
    figure, axes = pyplot.subplots(1, len(panels), figsize=(11, 0.3 * len(planners) + 1.3), sharey=True, squeeze=False)
    colours = {planner: look.colour for planner, look in looks(planners).items()}
    for axis, (title, draw) in zip(axes[0], panels):
        draw(axis, colours)
        axis.set_title(title)
    return figure


def of_runs(runs, metric):
    return lambda planner: [metric(run) for run in runs if run.planner == planner]


def quality_figure(runs, planners):
    """Of the paths that the runs ended with."""
    def length(axis, colours):
        boxes(axis, planners, lambda p: drawable(of_runs(runs, lambda run: run.excess_percent)(p)), colours)
        axis.set_xscale("log")
        axis.set_xlim(FLOOR_PERCENT * 0.7, 200)
        axis.xaxis.set_major_locator(FixedLocator([0.01, 0.1, 1, 10, 100]))
        axis.xaxis.set_minor_locator(NullLocator())
        axis.xaxis.set_major_formatter(FuncFormatter(lambda v, _: f"{v:g}" if v > FLOOR_PERCENT else f"≤ {v:g}"))

    def of_path(name):
        def draw(axis, colours):
            boxes(axis, planners, of_runs(runs, lambda run: getattr(run, name)), colours)
            axis.set_xscale("symlog", linthresh=10)  # from 0, and ring 1 turns a hundred times as much as others
            axis.xaxis.set_major_formatter(FuncFormatter(lambda v, _: f"{v:g}"))
            axis.set_xlim(left=0)
        return draw

    return box_figure(planners, [("length, % above the best known", length), ("turns", of_path("turns")),
                                 ("sum of turn angles, degrees", of_path("turn_angle")),
                                 ("least clearance, m", of_path("least_clearance"))])


def speed_figure(runs, planners, limit):
    """Times on a logarithmic axis whose end says "never"."""
    never = limit * 4

    def times(metric):
        def draw(axis, colours):
            boxes(axis, planners, of_runs(runs, metric), colours, never)
            axis.set_xscale("log")
            axis.set_xlim(FIRST_MOMENT / 2, never * 1.8)
            axis.axvline(limit, color=GREY, linewidth=0.8, linestyle=":")
            axis.xaxis.set_major_locator(FixedLocator([1e-4, 1e-2, 1, never]))
            axis.xaxis.set_minor_locator(NullLocator())
            axis.xaxis.set_major_formatter(FuncFormatter(lambda v, _: "never" if v == never else plain_seconds(v)))
        return draw

    panels = [("time to the first path", times(lambda run: run.first_solution))]
    for p in PERCENTS:
        title = f"to within {p} % of the best known" if p else "to the best known"
        panels.append((title, times(lambda run, p=p: run.time_to_within[p])))
    return box_figure(planners, panels)


def make_figures(runs, planners, limit):
    """Of each figure its file name without ending, what it shows, and the figure."""
    curves = Curves(runs, planners, limit)
    return [
        ("cost_over_time", "Length of the best path so far over time: median over all runs and pairs, in percent above "
         "the best length known for the pair; a line begins where half of the runs have a path. Below, the share of "
         "runs that have one.", cost_over_time(curves)),
        ("cost_over_time_each", "The same a planner at a time, with the quartiles as a band. A band that leaves the "
         "panel at its top means that a quarter of the runs have no path yet.", cost_over_time_each(curves)),
        ("speed", "Times to the first path and to paths near the best known. A run that never got there lies at "
         "\"never\"; the dotted line is the time limit.", speed_figure(runs, planners, limit)),
        ("quality", "The paths that the runs ended with. Dots are runs; boxes are quartiles.",
         quality_figure(runs, planners)),
    ]
