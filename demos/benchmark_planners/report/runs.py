"""The runs of a campaign as the statistics want them."""
import math
import sqlite3
from dataclasses import dataclass, field

from database import PERCENTS, histories
from quantiles import NEVER

PREFIX = "geometric_"  # OMPL's, before every planner's name


@dataclass
class Run:
    """One run; what it did not reach is infinite, what it has no path for is not a number."""
    planner: str
    pair: int
    solved: bool = False
    invalid: bool = False  # it had a path, and that path was not valid
    unsafe: bool = False   # a dive that did not keep the limits where it was looked at once more
    crashed: bool = False
    best_known: float = math.nan
    excess_percent: float = NEVER
    turns: float = math.nan
    turn_angle: float = math.nan
    least_clearance: float = math.nan
    legs: float = math.nan
    first_solution: float = NEVER
    time_to_within: dict = field(default_factory=lambda: {percent: NEVER for percent in PERCENTS})
    history: list = field(default_factory=list)
    processor_share: float = math.nan  # processor time over wall time, where there is enough of it to tell


def read_runs(path, campaign):
    """Every run that the campaign owes for its pairs: those in the database, and those that a crash took."""
    connection = sqlite3.connect(path)
    connection.row_factory = sqlite3.Row
    history_of = histories(connection)
    found = [run_of_row(row, history_of.get(row["id"], [])) for row in connection.execute(
        "SELECT runs.*, experiments.pair AS pair, plannerConfigs.name AS planner FROM runs "
        "JOIN experiments ON experiments.id = runs.experimentid "
        "JOIN plannerConfigs ON plannerConfigs.id = runs.plannerid ORDER BY runs.id")]
    connection.close()
    best = {run.pair: run.best_known for run in found}
    for crash in campaign.crashes:
        found += [Run(crash.planner, crash.pair, crashed=True, best_known=best.get(crash.pair, math.nan))
                  for _ in range(campaign.manifest["runs"])]
    return found


def starved(runs, least=0.9):
    """The runs that had less than this share of a core: something else was running, and their times are too long."""
    return [run for run in runs if run.processor_share < least]


def run_of_row(row, history):
    def number(column, missing):
        return missing if row[column] is None else float(row[column])

    run = Run(row["planner"][len(PREFIX):], row["pair"])
    run.best_known = number("best_known_cost", math.nan)
    if number("solve_time", 0.0) >= 0.01:
        run.processor_share = number("processor_time", math.nan) / number("solve_time", math.nan)
    run.invalid = row["valid"] is not None and not int(row["valid"])
    run.unsafe = row["unsafe"] is not None and bool(int(row["unsafe"]))
    run.solved = row["valid"] is not None and bool(int(row["valid"]))
    if run.solved:
        run.excess_percent = number("excess_percent", NEVER)
        run.turns = number("turns", math.nan)
        run.turn_angle = number("turn_angle", math.nan)
        run.least_clearance = number("least_clearance", NEVER)  # no hazard on the chart at all
        run.legs = number("legs", math.nan)
        run.first_solution = number("time_to_first_solution", NEVER)
        run.time_to_within = {p: number(f"time_to_within_{p}_percent", NEVER) for p in PERCENTS}
        run.history = history
    return run
