"""The campaign's database: OMPL's tables (experiments, plannerConfigs, runs, progress), made by
ompl_benchmark_statistics, with columns of ours in `runs` and a table of crashes."""
import os
import shutil
import sqlite3
import subprocess

from failure import REPORT, Failure
from histories import excess_percent, time_to_within
from quantiles import NEVER

PERCENTS = (5, 1, 0)  # within how many percent of the best known cost
TOOL = "ompl_benchmark_statistics"


def make_database(campaign, path):
    """Merges the logs, adds the columns, and only then gives the database its name."""
    part = path.with_suffix(".part.db")
    part.unlink(missing_ok=True)
    import_logs([str(log) for pair in campaign.pairs for log in campaign.logs[pair]], part)
    connection = sqlite3.connect(part)
    with connection:
        add_costs(connection)
        add_crashes(connection, campaign.crashes)
    connection.close()
    os.replace(part, path)


def import_logs(logs, path):
    tool = shutil.which(TOOL)
    if tool is None:
        raise Failure(REPORT, f"{TOOL} is missing: install the Debian package ompl-demos; the logs stay, and --merge "
                              "makes database and page later")
    at_once = 200  # a command line has an end
    for first in range(0, len(logs), at_once):
        done = subprocess.run([tool, "-a", "-d", str(path), *logs[first:first + at_once]], capture_output=True,
                              text=True, check=False)
        if done.returncode != 0:
            raise Failure(REPORT, f"{TOOL} failed: {done.stderr.strip().splitlines()[-1:]}; the logs stay")


def histories(connection):
    """Of each run's id the rows (seconds, cost)."""
    found = {}
    for run, seconds, cost in connection.execute(
            "SELECT runid, time, best_cost FROM progress ORDER BY runid, time"):
        found.setdefault(run, []).append((seconds, cost))
    return found


def add_columns(connection, table, columns):
    """Adds what is not there; a log in which no run was solved lacks the columns of solutions."""
    present = {row[1] for row in connection.execute(f"PRAGMA table_info({table})")}
    for name in columns:
        if name not in present:
            connection.execute(f"ALTER TABLE {table} ADD {name} REAL")


def add_costs(connection):
    """In `runs`: best_known_cost of the run's pair over all planners and runs, excess_percent over it, and
    time_to_within_5_percent, ..._1_percent, ..._0_percent in seconds (NULL: never)."""
    add_columns(connection, "progress", ["best_cost"])
    add_columns(connection, "runs", ["valid", "unsafe", "length", "legs", "turns", "turn_angle", "least_clearance",
                                     "time_to_first_solution", "best_known_cost", "excess_percent",
                                     *(f"time_to_within_{p}_percent" for p in PERCENTS)])
    best = dict(connection.execute("SELECT experiments.pair, min(runs.length) FROM runs JOIN experiments "
                                   "ON experiments.id = runs.experimentid WHERE runs.valid GROUP BY experiments.pair"))
    history_of = histories(connection)
    rows = connection.execute("SELECT runs.id, experiments.pair, runs.length FROM runs JOIN experiments "
                              "ON experiments.id = runs.experimentid").fetchall()
    for run, pair, length in rows:
        if best.get(pair) is None:
            continue
        excess = NEVER if length is None else excess_percent(length, best[pair])
        times = [time_to_within(history_of.get(run, []), best[pair], percent) for percent in PERCENTS]
        names = ["best_known_cost", "excess_percent", *(f"time_to_within_{p}_percent" for p in PERCENTS)]
        values = [None if value == NEVER else value for value in (best[pair], excess, *times)]
        connection.execute(f"UPDATE runs SET {', '.join(name + ' = ?' for name in names)} WHERE id = ?",
                           (*values, run))


def add_crashes(connection, crashes):
    connection.execute("CREATE TABLE crashes (pair INTEGER, planner TEXT, how TEXT, said TEXT)")
    connection.executemany("INSERT INTO crashes VALUES (?, ?, ?, ?)",
                           [(c.pair, c.planner, c.how, c.said) for c in crashes])
