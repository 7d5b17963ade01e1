"""The results table: a row a planner, for people and for machines."""
import math
from dataclasses import dataclass

from database import PERCENTS
from quantiles import NEVER, Quartiles, quartiles


@dataclass(frozen=True)
class Row:
    """Quartiles over all runs; of the path's own metrics over the runs that have one."""
    planner: str
    runs: int
    solved: int
    invalid: int
    unsafe: int
    crashed: int
    first_solution: Quartiles
    excess_percent: Quartiles
    turns: Quartiles
    turn_angle: Quartiles
    least_clearance: Quartiles
    legs: Quartiles
    time_to_within: dict

    @property
    def solved_percent(self):
        return 100 * self.solved / self.runs if self.runs else math.nan


def summarise(planner, runs):
    """The row of one planner."""
    own = [run for run in runs if run.planner == planner]
    with_path = [run for run in own if run.solved]

    def of_paths(metric):
        return quartiles(getattr(run, metric) for run in with_path)

    return Row(planner, len(own), len(with_path), sum(run.invalid for run in own), sum(run.unsafe for run in own),
               sum(run.crashed for run in own), quartiles(run.first_solution for run in own),
               quartiles(run.excess_percent for run in own),
               of_paths("turns"), of_paths("turn_angle"), of_paths("least_clearance"), of_paths("legs"),
               {percent: quartiles(run.time_to_within[percent] for run in own) for percent in PERCENTS})


def display_name(planner):
    """RRTstar as people write it: RRT*."""
    return planner.replace("star", "*")


def number(value, digits=3):
    """So many significant digits, plainly; a dash for what there is none of, "never" for what was not reached."""
    if math.isnan(value):
        return "-"
    if value == NEVER:
        return "never"
    if value == 0:
        return "0"
    decimals = max(0, digits - 1 - math.floor(math.log10(abs(value))))
    return f"{value:.{decimals}f}"


def percent(value):
    return number(value) if not math.isfinite(value) else f"{value:.2f}"


def clearance(value):
    """A chart without a blocking hazard has no least distance to one."""
    return "-" if value == NEVER else number(value)


HEADINGS = ["planner", "solved %", "first ms", "over best %: lower", "median", "upper", "turns", "angle deg",
            "clear m", *(f"to {p} % ms" for p in PERCENTS)]


def headings(is_dive=False):
    """Of dives with a column more, which ought to hold nothing but zeros."""
    return [*HEADINGS[:2], "unsafe", *HEADINGS[2:]] if is_dive else HEADINGS


def cells(row, is_dive=False):
    """A row's texts in the order of the headings: medians, and the quartiles of the length."""
    unsafe = [str(row.unsafe)] if is_dive else []
    return [display_name(row.planner), number(row.solved_percent), *unsafe, number(1000 * row.first_solution.median),
            percent(row.excess_percent.low), percent(row.excess_percent.median), percent(row.excess_percent.high),
            number(row.turns.median), number(row.turn_angle.median), clearance(row.least_clearance.median),
            *(number(1000 * row.time_to_within[p].median) for p in PERCENTS)]


def text_table(rows, is_dive=False):
    lines = [headings(is_dive), *(cells(row, is_dive) for row in rows)]
    widths = [max(len(line[i]) for line in lines) for i in range(len(lines[0]))]
    return "\n".join("  ".join([line[0].ljust(widths[0]), *(text.rjust(width)
                                                           for text, width in zip(line[1:], widths[1:]))])
                     for line in lines)


def json_number(value):
    """null for what there is none of or was not reached: JSON has no infinity."""
    return value if math.isfinite(value) else None


def json_quartiles(q):
    return {"lower": json_number(q.low), "median": json_number(q.median), "upper": json_number(q.high)}


def json_row(row, is_dive=False):
    return {"planner": row.planner, "runs": row.runs, "solved": row.solved, "invalid": row.invalid,
            **({"unsafe": row.unsafe} if is_dive else {}), "crashed": row.crashed,
            "first_solution_s": json_quartiles(row.first_solution),
            "excess_percent": json_quartiles(row.excess_percent), "turns": json_quartiles(row.turns),
            "turn_angle_deg": json_quartiles(row.turn_angle), "legs": json_quartiles(row.legs),
            "least_clearance_m": json_quartiles(row.least_clearance),
            **{f"time_to_within_{p}_percent_s": json_quartiles(q) for p, q in row.time_to_within.items()}}
