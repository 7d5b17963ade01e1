#!/usr/bin/env python3
"""Tests of the scripts in this folder: python3 report_test.py [-v]."""
import json
import math
import os
import random
import re
import sqlite3
import statistics
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from campaign import read_campaign
from database import make_database
from failure import REPORT, USAGE, Failure
from histories import (cost_at, excess_over_time, excess_percent, logarithmic_times, solved_over_time, time_to_within)
from quantiles import NEVER, Quartiles, quantile, quartiles
from reports import text_report
from runs import read_runs, starved
from style import looks
from summary import cells, json_row, number, summarise, text_table

SEED = int(os.environ.get("SEAHEX_TEST_SEED", random.SystemRandom().randrange(10**6)))


class QuantileTest(unittest.TestCase):
    def test_equals_the_standard_librarys_where_all_is_finite(self):
        dice = random.Random(SEED)
        for _ in range(200):
            values = [dice.uniform(-5, 5) for _ in range(dice.randint(2, 40))]
            wanted = statistics.quantiles(values, n=4, method="inclusive")
            for share, quarter in zip((0.25, 0.5, 0.75), wanted):
                self.assertAlmostEqual(quantile(values, share), quarter, msg=f"seed {SEED}: {values}")

    def test_what_was_never_reached_sorts_last_and_is_never_averaged(self):
        self.assertEqual(quantile([NEVER, 1, 2], 0.5), 2)
        self.assertEqual(quantile([1, NEVER], 0.5), NEVER)  # half of the runs did not get there
        self.assertEqual(quantile([1, 2, NEVER, NEVER], 0.5), NEVER)
        self.assertEqual(quantile([NEVER, NEVER], 0.25), NEVER)
        self.assertEqual(quartiles([1, 2, 3, NEVER, NEVER]), Quartiles(2, 3, NEVER))

    def test_one_value_and_none(self):
        self.assertEqual(quartiles([7]), Quartiles(7, 7, 7))
        self.assertTrue(math.isnan(quantile([], 0.5)))

    def test_replacing_a_value_by_never_lowers_no_quantile(self):
        dice = random.Random(SEED)
        for _ in range(100):
            values = [dice.uniform(0, 1) for _ in range(dice.randint(1, 20))]
            worse = values[1:] + [NEVER]
            for share in (0.25, 0.5, 0.75):
                self.assertLessEqual(quantile(values, share), quantile(worse, share), msg=f"seed {SEED}")


class HistoryTest(unittest.TestCase):
    history = [(0.1, 120.0), (0.5, 105.0), (2.0, 100.0)]

    def test_cost_is_a_step_function(self):
        self.assertEqual(cost_at([], 1), NEVER)
        self.assertEqual(cost_at(self.history, 0.0999), NEVER)
        for seconds, cost in ((0.1, 120), (0.49, 120), (0.5, 105), (1.99, 105), (2, 100), (9, 100)):
            self.assertEqual(cost_at(self.history, seconds), cost)

    def test_time_to_within_a_share_of_the_best(self):
        self.assertEqual(time_to_within(self.history, 100, 25), 0.1)
        self.assertEqual(time_to_within(self.history, 100, 5), 0.5)  # 105 is within 5 % of 100, rounding or not
        self.assertEqual(time_to_within(self.history, 100, 1), 2.0)
        self.assertEqual(time_to_within(self.history, 100, 0), 2.0)
        self.assertEqual(time_to_within(self.history, 99.99995, 0), 2.0)  # to a millionth
        self.assertEqual(time_to_within(self.history, 99.9, 0), NEVER)
        self.assertEqual(time_to_within([], 100, 5), NEVER)

    def test_time_to_within_is_when_the_cost_curve_gets_there(self):
        dice = random.Random(SEED)
        for _ in range(100):
            times = sorted(dice.uniform(0, 1) for _ in range(dice.randint(1, 12)))
            costs = sorted((dice.uniform(100, 140) for _ in times), reverse=True)
            history = list(zip(times, costs))
            reached = time_to_within(history, 100, 10)
            later = [t for t in [*times, 2.0] if cost_at(history, t) <= 110 * (1 + 1e-6)]
            self.assertEqual(reached, min(later, default=NEVER), msg=f"seed {SEED}")

    def test_excess_is_never_negative(self):
        self.assertAlmostEqual(excess_percent(103, 100), 3)
        self.assertEqual(excess_percent(99.9999999, 100), 0)
        self.assertEqual(excess_percent(NEVER, 100), NEVER)

    def test_curves_count_unsolved_runs(self):
        both = [(self.history, 100.0), ([], 100.0)]
        early, late = excess_over_time(both, [0.01, 3])
        self.assertEqual(early, Quartiles(NEVER, NEVER, NEVER))
        self.assertEqual(late.low, NEVER)  # between 0 % and never there is no middle
        three = [(self.history, 100.0)] * 2 + [([], 100.0)]
        self.assertEqual(excess_over_time(three, [3])[0].median, 0)
        self.assertEqual(solved_over_time([self.history, []], [0.05, 0.1, 5]), [0, 0.5, 0.5])

    def test_moments_are_evenly_spaced_on_a_logarithmic_axis(self):
        times = logarithmic_times(1e-3, 10, 5)
        for got, wanted in zip(times, (1e-3, 1e-2, 1e-1, 1, 10)):
            self.assertAlmostEqual(got, wanted)


UNSAFE = "unsafe"  # in place of a run's list: its path was not valid, and not safe


def log_of(pair, planners):
    """A log as ompl::tools::Benchmark writes it. A planner's runs: lists of (seconds, cost); none is unsolved."""
    lines = ["OMPL version ", f"Experiment pair-{pair:04}", "1 experiment properties", f"pair INTEGER = {pair}",
             "Running on nowhere", "Starting at 2020-01-01 00:00:00", "<<<|", "|>>>", "<<<|", "|>>>",
             "1 is the random seed", "2 seconds per run", "100 MB per run", "1 runs per planner",
             "1 seconds spent to collect the data", "1 enum type", "status|Unknown status|Exact solution",
             f"{len(planners)} planners"]
    columns = ["least clearance REAL", "legs INTEGER", "length REAL", "processor time REAL", "solve time REAL",
               "time to first solution REAL", "turn angle REAL", "turns INTEGER", "unsafe BOOLEAN", "valid BOOLEAN"]
    for name, runs in planners.items():
        lines += ["geometric_" + name, "0 common properties", f"{len(columns)} properties for each run", *columns,
                  f"{len(runs)} runs"]
        for run in runs:
            values = ["", "", "", 0.5, 1.0, "", "", "", "", ""]
            if run == UNSAFE:
                values[-2:] = [1, 0]
            elif run:
                values = [10, 3, run[-1][1], 1.0, 1.0, run[0][0], 90, 2, 0, 1]
            lines.append("".join(f"{value}; " for value in values))
        lines += ["2 progress properties for each run", "best cost REAL", "time REAL", f"{len(runs)} runs"]
        lines += ["".join(f"{cost},{seconds},;" for seconds, cost in run) if run != UNSAFE else "" for run in runs]
        lines.append(".")
    return "\n".join(lines) + "\n"


SETTINGS = {"ompl": "1.5.2", "seed": 1, "pairs": 2, "runs": 2, "time_s": 2.0, "least_distance": 0.3,
            "planners": ["HexAStar", "RRTstar", "AITstar"],
            "arena": {"charts": ["<small>"], "draught_m": 1.2, "ukc_m": 0.5, "margin_m": 0.0, "pitch_m": 20.0,
                      "columns": 10, "rows": 10, "blocked": 4, "fingerprint": "0"},
            "pair_list": [{"number": n, "start": [1.0, 2.0], "goal": [1.5, 2.5], "course_deg": 45.0,
                           "distance_m": 95.0} for n in (1, 2)]}


DIVES = {**SETTINGS, "planners": ["PrismAStar", "RRTstar"],
         "arena": {"seabed": "<deep>.nc", "columns": 10, "rows": 20, "spacing_m": [100.0, 90.5],
                   "greatest_depth_m": 2000.0, "clearance_m": 50.0, "ceiling_m": 10.0, "deepest_m": None,
                   "fingerprint": "0"},
         "pair_list": [{"number": 1, "start": [1.0, 2.0, 30.0], "goal": [1.5, 2.5, 700.0], "course_deg": 45.0,
                        "distance_m": 95.0, "seabed_in_the_way": True}]}


def write_dives(folder):
    """Results over a seabed: a pair, two runs of two planners, one of them unsafe."""
    folder.mkdir(exist_ok=True)
    (folder / "manifest.json").write_text(json.dumps(DIVES))
    run = [(0.5, 100.0)]
    (folder / "pair-0001.log").write_text(log_of(1, {"PrismAStar": [run, run], "RRTstar": [run, UNSAFE]}))
    (folder / "pair-0001.json").write_text(json.dumps({"pair": 1, "seconds": 1, "logs": ["pair-0001.log"],
                                                       "crashed": []}))


def write_folder(folder, pairs, settings=None):
    """Results of two planners and one that crashes; pair 2 is ten times as long as pair 1."""
    folder.mkdir(exist_ok=True)
    (folder / "manifest.json").write_text(json.dumps(settings or SETTINGS))
    for pair in pairs:
        scale = 1.0 if pair == 1 else 10.0
        first = [(0.5, 120.0 * scale), (1.0, 100.0 * scale)]
        (folder / f"pair-{pair:04}.log").write_text(log_of(pair, {
            "HexAStar": [first, first], "RRTstar": [[(0.1, 110.0 * scale), (1.5, 104.0 * scale)], []]}))
        (folder / f"pair-{pair:04}.json").write_text(json.dumps({
            "pair": pair, "seconds": 1, "logs": [f"pair-{pair:04}.log"],
            "crashed": [{"planner": "AITstar", "how": "Aborted", "said": "assertion <x>"}]}))


class CampaignTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()  # pylint: disable=consider-using-with
        self.addCleanup(self.temporary.cleanup)
        self.folder = Path(self.temporary.name)

    def results(self, *folders):
        campaign = read_campaign(folders)
        make_database(campaign, self.folder / "x.db")
        return campaign, read_runs(self.folder / "x.db", campaign)

    def test_every_run_is_counted_those_that_a_crash_took_too(self):
        write_folder(self.folder / "a", [1, 2])
        campaign, runs = self.results(self.folder / "a")
        hexagons, tree, crashed = (summarise(planner, runs) for planner in campaign.planners)
        self.assertEqual((hexagons.runs, hexagons.solved, hexagons.crashed), (4, 4, 0))
        self.assertEqual((tree.runs, tree.solved, tree.crashed), (4, 2, 0))
        self.assertEqual((crashed.runs, crashed.solved, crashed.crashed), (4, 0, 4))
        self.assertEqual(hexagons.excess_percent, Quartiles(0, 0, 0))
        self.assertEqual(tree.excess_percent.median, NEVER)
        self.assertAlmostEqual(tree.excess_percent.low, 4)
        self.assertEqual(crashed.first_solution.median, NEVER)
        self.assertEqual(hexagons.time_to_within[5].median, 1.0)
        self.assertAlmostEqual(tree.time_to_within[5].low, 1.5)
        self.assertEqual(tree.time_to_within[1].low, NEVER)
        self.assertEqual(len(starved(runs)), 2)  # the unsolved ones, which had half a core

    def test_database_has_our_columns(self):
        write_folder(self.folder / "a", [1, 2])
        self.results(self.folder / "a")
        connection = sqlite3.connect(self.folder / "x.db")
        rows = connection.execute(
            "SELECT pair, best_known_cost, excess_percent, time_to_within_5_percent, time_to_within_0_percent "
            "FROM runs JOIN experiments ON experiments.id = experimentid ORDER BY runs.id").fetchall()
        self.assertEqual(rows[0], (1, 100.0, 0.0, 1.0, 1.0))
        self.assertEqual(rows[3], (1, 100.0, None, None, None))  # unsolved
        self.assertEqual(rows[4][:2], (2, 1000.0))
        self.assertEqual(connection.execute("SELECT * FROM crashes").fetchall(),
                         [(1, "AITstar", "Aborted", "assertion <x>"), (2, "AITstar", "Aborted", "assertion <x>")])
        connection.close()

    def test_folders_merge_and_a_pair_counts_once(self):
        write_folder(self.folder / "a", [1])
        write_folder(self.folder / "b", [1, 2])
        campaign, runs = self.results(self.folder / "a", self.folder / "b")
        self.assertEqual(campaign.pairs, [1, 2])
        self.assertEqual([crash.pair for crash in campaign.crashes], [1, 2])
        self.assertEqual(sum(run.planner == "HexAStar" for run in runs), 4)

    def test_a_pair_without_its_log_is_not_done(self):
        write_folder(self.folder / "a", [1, 2])
        (self.folder / "a" / "pair-0002.log").unlink()
        self.assertEqual(read_campaign([self.folder / "a"]).pairs, [1])

    def test_folders_that_can_not_be_merged_are_refused(self):
        write_folder(self.folder / "a", [1])
        write_folder(self.folder / "b", [2], {**SETTINGS, "time_s": 3.0})
        write_folder(self.folder / "none", [])
        (self.folder / "empty").mkdir()
        for folders, words in ((["a", "b"], "time_s is 2.0 in one and 3.0"), (["empty"], "manifest.json"),
                               (["none"], "no job is done")):
            with self.assertRaisesRegex(Failure, words) as caught:
                read_campaign([self.folder / name for name in folders])
            self.assertEqual(caught.exception.code, USAGE)

    def test_a_missing_tool_is_named_and_leaves_no_half_database(self):
        write_folder(self.folder / "a", [1])
        with mock.patch.dict(os.environ, {"PATH": ""}), self.assertRaisesRegex(Failure, "ompl-demos") as caught:
            make_database(read_campaign([self.folder / "a"]), self.folder / "x.db")
        self.assertEqual(caught.exception.code, REPORT)
        self.assertFalse((self.folder / "x.db").exists())

    def test_table_and_json_say_what_was_never_reached(self):
        write_folder(self.folder / "a", [1, 2])
        campaign, runs = self.results(self.folder / "a")
        rows = [summarise(planner, runs) for planner in campaign.planners]
        table = text_table(rows).splitlines()
        self.assertEqual(len({len(line) for line in table}), 1)
        self.assertIn("RRT*", table[2])
        self.assertIn("never", table[2])
        self.assertEqual(cells(rows[2])[1:3], ["0", "never"])
        self.assertIsNone(json_row(rows[1])["time_to_within_1_percent_s"]["median"])
        json.dumps([json_row(row) for row in rows], allow_nan=False)

    def test_an_unsafe_dive_is_counted_loudly(self):
        write_dives(self.folder / "a")
        campaign, runs = self.results(self.folder / "a")
        prisms, tree = rows = [summarise(planner, runs) for planner in campaign.planners]
        self.assertEqual((prisms.runs, prisms.solved, prisms.invalid, prisms.unsafe), (2, 2, 0, 0))
        self.assertEqual((tree.runs, tree.solved, tree.invalid, tree.unsafe), (2, 1, 1, 1))
        self.assertEqual(json_row(tree, is_dive=True)["unsafe"], 1)
        text = text_report(campaign, runs, rows)
        self.assertIn("UNSAFE: 1 dive(s) of RRTstar", text)
        self.assertNotIn("of PrismAStar", text)
        self.assertRegex(text.splitlines()[0], r"solved %\s+unsafe\s+first ms")
        self.assertRegex(text.splitlines()[2], r"RRT\*\s+50\.0\s+1\s")

    def test_a_chart_has_no_column_of_unsafe_dives(self):
        write_folder(self.folder / "a", [1, 2])
        campaign, runs = self.results(self.folder / "a")
        rows = [summarise(planner, runs) for planner in campaign.planners]
        self.assertNotIn("unsafe", text_report(campaign, runs, rows).lower())
        self.assertNotIn("unsafe", json_row(rows[0]))

    def test_page_of_dives(self):
        try:
            from page import make_page  # pylint: disable=import-outside-toplevel
        except ImportError:
            self.skipTest("no matplotlib")
        write_dives(self.folder / "a")
        campaign, runs = self.results(self.folder / "a")
        page = make_page(campaign, runs, [summarise(planner, runs) for planner in campaign.planners], [])
        for words in ("<h1>Planners over the seabed &lt;deep&gt;.nc</h1>", "UNSAFE: 1 dive(s)",
                      "1.00000, 2.00000, 30 m", "50 m above the seabed", "in the way of the straight line of 1",
                      "<th>unsafe</th>"):
            self.assertIn(words, page)
        self.assertNotIn("no deeper than", page)

    def test_page_is_self_contained(self):
        try:
            from page import make_page  # pylint: disable=import-outside-toplevel
            from plots import make_figures  # pylint: disable=import-outside-toplevel
        except ImportError:
            self.skipTest("no matplotlib")
        write_folder(self.folder / "a", [1, 2])
        campaign, runs = self.results(self.folder / "a")
        rows = [summarise(planner, runs) for planner in campaign.planners]
        page = make_page(campaign, runs, rows, make_figures(runs, campaign.planners, 2.0))
        self.assertEqual(page.count("<figure>"), 4)
        for address in re.findall(r'(?:src|href)="([^"]*)"', page):
            self.assertTrue(address.startswith("data:"), address[:60])
        self.assertNotRegex(page, r"https?://|@import|<script|<link")
        self.assertIn("&lt;small&gt;", page)
        self.assertIn("assertion &lt;x&gt;", page)
        self.assertNotIn(str(self.folder), page)
        self.assertNotIn("nowhere", page)  # the host's name in the logs


class LookTest(unittest.TestCase):
    def test_no_two_planners_look_alike(self):
        planners = ["HexAStar", "HexAStar-1", "HexAStar-2", "HexAStar-3", "SquareAStar", "RRTConnect+simplify",
                    "RRTstar", "InformedRRTstar", "PRMstar", "LazyPRMstar", "FMT-1000", "FMT-10000", "BITstar",
                    "ABITstar", "AITstar", "SomethingElse"]
        dives = ["LayeredPlanner-greedy", "LayeredPlanner-exact", "AntColony", "PrismAStar", "PrismAStar-climb",
                 "RRTConnect+simplify", "RRTstar", "InformedRRTstar", "PRMstar", "BITstar"]
        for names in (planners, dives):
            found = looks(names)
            self.assertEqual(len({(look.colour, str(look.dashes)) for look in found.values()}), len(names))


class NumberTest(unittest.TestCase):
    def test_significant_digits(self):
        for value, text in ((0.0012345, "0.00123"), (1.2345, "1.23"), (123.4, "123"), (10657.2, "10657"), (0, "0"),
                            (NEVER, "never"), (math.nan, "-")):
            self.assertEqual(number(value), text)


if __name__ == "__main__":
    unittest.main()
