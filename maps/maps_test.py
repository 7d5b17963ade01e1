#!/usr/bin/env python3
"""Tests of the scripts in this folder: python3 maps_test.py [-v]."""
import contextlib
import io
import os
import random
import tempfile
import unittest

from osgeo import gdal

import make_maps
import verify_maps
from chart_plans import CHART_PLANS
from dangers import DANGER_KINDS, PlaceFinder, scattered_dangers, soundings
from grid import Window, multipolygon, polygon_from_rings, rectangle, to_grid, twice_area, twice_signed_area
from gshhg import BIN_UNITS, DEFAULT_FILE, ShorelineError, land_rings_of_bin
from reachability import WaterPicture
from s57_writer import CellHeader, CellWriteError, write_cell
from seabed import Band, Seabed, SeabedError, depth_label
from topology import AREA, INTERIOR, LINE, MAX_EDGE_POINTS, POINT, REVERSE, ChainNodeNetwork, ChartObject

gdal.UseExceptions()
FOLDER = os.path.dirname(os.path.abspath(__file__))
M = BIN_UNITS
SEA, LAND = 0, 1


def small_world():
    """A window of 0.1 degree with one square island in it."""
    window = Window.from_degrees(10.0, 10.1, 20.0, 20.1)
    island = rectangle(to_grid(10.04), to_grid(10.05), to_grid(20.04), to_grid(20.05))
    return window, island, Seabed(window, [polygon_from_rings([island])])


def small_cell_objects():
    window, island, seabed = small_world()
    finder = PlaceFinder(seabed, 1, [], to_grid(0.001))
    objects = [ChartObject("M_COVR", {"CATCOV": 1}, AREA, [window.ring()])]
    objects += [ChartObject(area.acronym, area.attributes, AREA, area.rings) for area in seabed.areas]
    objects.append(ChartObject("SLCONS", {"CATSLC": 1}, LINE, [(to_grid(10.045), to_grid(20.045)),
                                                               (to_grid(10.06), to_grid(20.06))]))
    kinds = [kind for kind in DANGER_KINDS if kind.shallowest_m < 10]
    objects += scattered_dangers(finder, 1, kinds) + soundings(seabed, 2, to_grid(0.01))
    return window, objects


def write_small_cell(folder, name="small.000"):
    window, objects = small_cell_objects()
    path = os.path.join(folder, name)
    write_cell(path, CellHeader(20_000, 5, "20260101", "test"), window, objects)
    return path


def cell_faults(path):
    return verify_maps.faults_of(verify_maps.Cell(path), None, None)


def records_of(data):
    """The ISO 8211 records of a file: each begins with its length in five digits."""
    records, start = [], 0
    while start < len(data):
        length = int(data[start:start + 5])
        records.append(data[start:start + length])
        start += length
    return records


class ShorelineWalkTest(unittest.TestCase):
    """Land lies on the left of a segment; corner levels are ordered SW, SE, NE, NW."""

    def total(self, segments, corners):
        return sum(twice_signed_area(ring) for ring in land_rings_of_bin(segments, corners))

    def test_bin_without_shoreline_is_all_land_or_all_sea(self):
        self.assertEqual(self.total([], [LAND] * 4), 2 * M * M)
        self.assertEqual(self.total([], [SEA] * 4), 0)
        self.assertEqual(self.total([], [2] * 4), 2 * M * M)  # inside a lake: the land is not cut out

    def test_one_segment_parts_the_bin(self):
        northwards = (0, 2, [(100, 0), (300, 7), (100, M)])
        southwards = (2, 0, [(100, M), (300, 7), (100, 0)])
        west = self.total([northwards], [LAND, SEA, SEA, LAND])
        east = self.total([southwards], [SEA, LAND, LAND, SEA])
        self.assertEqual(west + east, 2 * M * M)
        self.assertEqual(west, 2 * 100 * M + 200 * M)

    def test_cape_and_its_counterpart_fill_the_bin(self):
        cape = (3, 3, [(0, 500), (900, 700), (0, 1000)])
        bay = (3, 3, cape[2][::-1])
        self.assertEqual(self.total([cape], [SEA] * 4) + self.total([bay], [LAND] * 4), 2 * M * M)

    def test_two_segments_bound_one_strait(self):
        left_bank = (0, 2, [(100, 0), (100, M)])
        right_bank = (2, 0, [(300, M), (300, 0)])
        self.assertEqual(self.total([left_bank, right_bank], [LAND] * 4), 2 * M * (M - 200))

    def test_closed_island_stands_alone(self):
        island = (4, 4, [(10, 10), (20, 10), (20, 20), (10, 20), (10, 10)])
        self.assertEqual(self.total([island], [SEA] * 4), 200)

    def test_contradiction_with_a_corner_is_refused(self):
        with self.assertRaisesRegex(ShorelineError, "corners"):
            land_rings_of_bin([(0, 2, [(100, 0), (100, M)])], [SEA, LAND, LAND, SEA])
        with self.assertRaisesRegex(ShorelineError, "corners"):
            land_rings_of_bin([], [LAND, SEA, SEA, LAND])

    def test_segment_that_misses_its_side_is_refused(self):
        with self.assertRaisesRegex(ShorelineError, "side 2"):
            land_rings_of_bin([(0, 2, [(100, 0), (100, M - 1)])], [LAND, SEA, SEA, LAND])


class TopologyTest(unittest.TestCase):
    def ring_from(self, network, references):
        points = []
        for reference in references:
            chain = network.edges[reference.record_id - 1]
            points += (chain[::-1] if reference.orientation == REVERSE else chain)[:-1]
        return points

    def assert_same_ring(self, ring, points):
        """Equal up to the start, the direction and stops on straight borders."""
        self.assertEqual(abs(twice_signed_area(ring)), abs(twice_signed_area(points + points[:1])))
        self.assertLessEqual(set(ring), set(points))

    def test_neighbours_share_one_edge_in_opposite_directions(self):
        window = Window(0, 20, 0, 10)
        areas = [ChartObject("DEPARE", {"DRVAL1": 1}, AREA, [rectangle(0, 10, 0, 10)]),
                 ChartObject("DEPARE", {"DRVAL1": 2}, AREA, [rectangle(10, 20, 0, 10)])]
        network = ChainNodeNetwork(window, areas)
        shared = [place for place, users in enumerate(network.users) if len(users) == 2]
        self.assertEqual(len(shared), 1)
        self.assertEqual(set(network.edges[shared[0]]), {(10, 0), (10, 10)})
        orientations = {reference.orientation for references in network.references for reference in references
                        if reference.record_id == shared[0] + 1}
        self.assertEqual(len(orientations), 2)

    def test_hole_and_the_island_in_it_share_an_edge(self):
        window = Window(0, 10, 0, 10)
        island = rectangle(4, 6, 4, 6)
        network = ChainNodeNetwork(window, [ChartObject("DEPARE", {}, AREA, [window.ring(), island]),
                                            ChartObject("LNDARE", {}, AREA, [island])])
        hole = [reference for reference in network.references[0] if reference.usage == INTERIOR]
        self.assertEqual(len(hole), 1)
        self.assertEqual({reference.record_id for reference in network.references[1]}, {hole[0].record_id})
        self.assertNotEqual(hole[0].orientation, network.references[1][0].orientation)

    def test_line_along_part_of_an_outline_shares_that_part(self):
        window = Window(0, 10, 0, 10)
        quay = [(4, 4), (4, 6)]
        network = ChainNodeNetwork(window, [ChartObject("LNDARE", {}, AREA, [rectangle(4, 6, 4, 6)]),
                                            ChartObject("SLCONS", {}, LINE, quay)])
        users = {tuple(sorted(edge)): users for edge, users in zip(network.edges, network.users)}
        self.assertEqual(users[tuple(quay)], [0, 1])
        self.assertEqual(len(network.edges), 2)

    def test_random_strips_come_back_from_their_edges(self):
        for seed in range(30):
            with self.subTest(seed=seed):
                generator = random.Random(seed)
                window = Window(0, 10_000, 0, 10_000)
                limits = [[(0, 0), (0, 10_000)]]
                for x in range(1000, 10_000, 1000):
                    turns = sorted(generator.sample(range(1, 10_000), generator.randrange(1, 3 * MAX_EDGE_POINTS)))
                    limits.append([(x, 0)] + [(x + generator.randrange(400), y) for y in turns] + [(x, 10_000)])
                limits.append([(10_000, 0), (10_000, 10_000)])
                rings = [left + right[::-1] + left[:1] for left, right in zip(limits, limits[1:])]
                areas = [ChartObject("DEPARE", {"DRVAL1": i}, AREA, [ring]) for i, ring in enumerate(rings)]
                coverage = ChartObject("M_COVR", {}, AREA, [window.ring()])
                network = ChainNodeNetwork(window, areas + [coverage])
                for ring, references in zip(rings + [window.ring()], network.references):
                    self.assert_same_ring(ring, self.ring_from(network, references))
                self.assertTrue(all(len(users) == 2 for users in network.users))
                self.assertLessEqual(max(map(len, network.edges)), MAX_EDGE_POINTS)


class SeabedTest(unittest.TestCase):
    def test_island_keeps_its_points_and_all_areas_are_valid(self):
        _, island, seabed = small_world()
        land = [area for area in seabed.areas if area.acronym == "LNDARE"]
        self.assertEqual([set(area.rings[0]) for area in land], [set(island)])
        self.assertTrue(all(area.polygon().IsValid() for area in seabed.areas))
        whole = multipolygon([area.polygon() for area in seabed.areas]).UnionCascaded()
        self.assertEqual(2 * whole.GetArea(), seabed.window.twice_area())  # no two areas overlap

    def test_depth_grows_with_distance_and_stays_within_its_area(self):
        _, _, seabed = small_world()
        depths = []
        for step in range(1, 400):
            point = (to_grid(10.05) + step * 1200, to_grid(20.045))
            limits = seabed.area_at(point).attributes
            depths.append(seabed.depth_at(point))
            self.assertTrue(limits["DRVAL1"] <= depths[-1] <= limits["DRVAL2"], point)
        self.assertEqual(depths, sorted(depths))
        self.assertIsNone(seabed.depth_at((to_grid(10.045), to_grid(20.045))))

    def test_depth_ends_at_the_deepest_limit(self):
        window, island, _ = small_world()
        seabed = Seabed(window, [polygon_from_rings([island])], (Band(120.0, -1.0, 0.0), Band(None, 0.0, 0.5)))
        self.assertEqual(seabed.depth_at((to_grid(10.01), to_grid(20.01))), 0.5)

    def test_carving_keeps_the_tiling_and_refuses_to_cross_a_limit(self):
        _, _, seabed = small_world()
        inside = rectangle(to_grid(10.01), to_grid(10.02), to_grid(20.01), to_grid(20.015))
        seabed.carve("DRGARE", {"DRVAL1": 12.0}, inside)
        self.assertEqual(sum(twice_area(area.rings) for area in seabed.areas), seabed.window.twice_area())
        with self.assertRaisesRegex(SeabedError, "inside one depth area"):
            seabed.carve("UNSARE", {}, rectangle(to_grid(10.01), to_grid(10.06), to_grid(20.02), to_grid(20.06)))

    def test_labels_are_never_deeper_than_the_water(self):
        self.assertEqual([depth_label(depth) for depth in (2.0, 2.09, -0.85, 0.3, 9.999)], [2.0, 2.0, -0.9, 0.3, 9.9])


class CellTest(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.addCleanup(self._folder.cleanup)
        self.path = write_small_cell(self._folder.name)

    def rewrite(self, change):
        with open(self.path, "rb") as file:
            data = change(file.read())
        with open(self.path, "wb") as file:
            file.write(data)

    def test_cell_reads_back_without_a_fault(self):
        self.assertEqual(cell_faults(self.path), [])

    def test_what_was_put_in_comes_back(self):
        _, objects = small_cell_objects()
        layers = verify_maps.Cell(self.path).layers
        for item in (item for item in objects if item.primitive == POINT and item.acronym != "SOUNDG"):
            match = [feature for feature in layers[item.acronym] if feature["OBJNAM"] == item.attributes["OBJNAM"]]
            self.assertEqual(len(match), 1)
            geometry = match[0].GetGeometryRef()
            self.assertEqual((to_grid(geometry.GetX()), to_grid(geometry.GetY())), item.geometry[0])
            self.assertEqual(match[0]["WATLEV"], item.attributes["WATLEV"])
            self.assertEqual(match[0]["VALSOU"], item.attributes.get("VALSOU"))
        wanted = [sounding for item in objects if item.acronym == "SOUNDG" for sounding in item.geometry]
        read = [part.GetPoint() for feature in layers["SOUNDG"] for part in feature.GetGeometryRef()]
        self.assertEqual([(to_grid(x), to_grid(y), round(z, 1)) for x, y, z in read], wanted)

    def test_same_bytes_twice(self):
        again = write_small_cell(self._folder.name, "again.000")
        with open(self.path, "rb") as first, open(again, "rb") as second:
            self.assertEqual(first.read().replace(b"small.000", b"again.000"), second.read())

    def test_cell_cut_at_a_record_boundary_is_noticed(self):
        self.rewrite(lambda data: b"".join(records_of(data)[:-1]))
        self.assertTrue(any("features" in fault for fault in cell_faults(self.path)))

    def faults_of_objects(self, window, objects):
        path = os.path.join(self._folder.name, "other.000")
        write_cell(path, CellHeader(20_000, 5, "20260101", "test"), window, objects)
        return cell_faults(path)

    def test_missing_area_is_noticed(self):
        window, objects = small_cell_objects()
        depth_area = next(item for item in objects if item.acronym == "DEPARE")
        objects.remove(depth_area)
        faults = self.faults_of_objects(window, objects)
        self.assertTrue(any(f"differ by {twice_area(depth_area.geometry)} half" in fault for fault in faults), faults)

    def test_gap_and_overlap_of_equal_size_are_noticed(self):
        window = Window.from_degrees(10.0, 10.1, 20.0, 20.1)
        gap = rectangle(to_grid(10.01), to_grid(10.02), to_grid(20.01), to_grid(20.02))
        overlap = [(x + to_grid(0.05), y) for x, y in gap]
        faults = self.faults_of_objects(window, [
            ChartObject("M_COVR", {"CATCOV": 1}, AREA, [window.ring()]),
            ChartObject("DEPARE", {"DRVAL1": 5.0, "DRVAL2": 9.0}, AREA, [window.ring(), gap]),
            ChartObject("LNDARE", {}, AREA, [overlap])])
        self.assertEqual(len(faults), 1)
        self.assertIn("no neighbour", faults[0])

    def test_unknown_class_attribute_and_text_are_refused(self):
        window = Window(0, 10, 0, 10)
        header = CellHeader(20_000, 5, "20260101", "test")
        for item, words in ((ChartObject("NOSUCH", {}, POINT, [(1, 1)]), "class NOSUCH"),
                            (ChartObject("WRECKS", {"DRVAL1": 1.0}, POINT, [(1, 1)]), "attribute DRVAL1"),
                            (ChartObject("WRECKS", {"OBJNAM": "\u00e9pave"}, POINT, [(1, 1)]), "ASCII")):
            with self.subTest(words), self.assertRaisesRegex(CellWriteError, words):
                write_cell(os.path.join(self._folder.name, "bad.000"), header, window, [item])


class ReachabilityTest(unittest.TestCase):
    """A strip of water with a pier of land across it, from the south side up to a given latitude."""

    WEST, EAST = (10.005, 20.0155), (10.095, 20.0155)

    def picture(self, pier_to_deg, extra=()):
        window = Window.from_degrees(10.0, 10.1, 20.0, 20.02)
        pier = rectangle(to_grid(10.04), to_grid(10.06), to_grid(20.001), to_grid(pier_to_deg))
        objects = [ChartObject("DEPARE", {"DRVAL1": 5.0}, AREA, [window.ring(), pier]),
                   ChartObject("LNDARE", {}, AREA, [pier]),
                   ChartObject("LNDARE", {}, AREA, [rectangle(to_grid(10.0), to_grid(10.1), to_grid(20.0),
                                                              to_grid(20.001))]), *extra]
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "strip.000")
            write_cell(path, CellHeader(20_000, 5, "20260101", "test"), window, objects)
            return WaterPicture(verify_maps.Cell(path).features(), (10.0, 10.1, 20.0, 20.02))

    def east_is_reached(self, picture):
        return bool(picture.reached_from(picture.pixel(*self.WEST))[picture.pixel(*self.EAST)])

    def test_pier_with_a_gap_lets_through_and_a_whole_one_does_not(self):
        self.assertTrue(self.east_is_reached(self.picture(20.018)))
        self.assertFalse(self.east_is_reached(self.picture(20.0199)))

    def test_danger_closes_the_gap_unless_it_is_known_to_be_deep(self):
        gap = [(to_grid(10.05), to_grid(20.0195 - 0.0005 * row)) for row in range(4)]
        for attributes, open_ in (({}, False), ({"VALSOU": 1.0}, False), ({"VALSOU": 9.0}, True)):
            with self.subTest(attributes):
                wrecks = [ChartObject("WRECKS", attributes, POINT, [(x + 1000, y + 1000)]) for x, y in gap]
                self.assertEqual(self.east_is_reached(self.picture(20.018, wrecks)), open_)

    def test_restriction_closes_only_where_entry_is_prohibited(self):
        ring = rectangle(to_grid(10.045), to_grid(10.055), to_grid(20.015), to_grid(20.02))
        for attributes, open_ in (({"RESTRN": [1, 3]}, True), ({"RESTRN": [1, 7]}, False), ({"CATREA": [9]}, False)):
            with self.subTest(attributes):
                areas = [ChartObject("RESARE", attributes, AREA, [ring])]
                self.assertEqual(self.east_is_reached(self.picture(20.018, areas)), open_)


class MapsTest(unittest.TestCase):
    def test_charts_of_this_folder_have_no_fault(self):
        output = io.StringIO()
        with contextlib.redirect_stdout(output):
            status = verify_maps.main([])
        self.assertEqual(status, 0, output.getvalue())

    @unittest.skipUnless(os.path.exists(DEFAULT_FILE), "gmt-gshhg-full is not installed")
    def test_charts_of_this_folder_are_what_the_script_makes(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual(make_maps.main(["--out", folder]), 0)
            for plan in CHART_PLANS:
                with open(os.path.join(folder, plan.file_name), "rb") as made, \
                        open(os.path.join(FOLDER, plan.file_name), "rb") as kept:
                    self.assertEqual(made.read(), kept.read(), plan.file_name)

    def test_unreadable_cell_fails(self):
        with contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual(verify_maps.main([os.path.join(FOLDER, "no_such_cell.000")]), 1)


if __name__ == "__main__":
    unittest.main()
