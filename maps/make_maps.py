#!/usr/bin/env python3
"""Makes the project's two charts, shangchuan.000 and sanya.000, from the GSHHG shoreline.

The shoreline is real, depths and dangers are synthetic: NOT FOR NAVIGATION. The same packages give the same bytes each
time. Needs python3-gdal and gmt-gshhg-full.
"""
import argparse
import os
import sys

from osgeo import gdal

from chart_plans import CHART_PLANS, closed_ring, grid_points
from dangers import PlacementError, PlaceFinder, scattered_dangers, soundings
from grid import position, rectangle, to_grid
from gshhg import DEFAULT_FILE, ShorelineBins, land_in_window
from s57_writer import CellHeader, write_cell
from seabed import Seabed
from topology import AREA, LINE, POINT, ChartObject

DATE = "20260101"
INTENDED_USE_APPROACH = 4
LAND_MARGIN_DEG = 0.1  # beyond the widest limited depth band
CLEARING_DEG = 0.01
DANGER_SPACING_DEG = 0.004
SOUNDING_SPACING_DEG = 0.02
DANGER_COPIES = 2
QUALITY_UNASSESSED = 6
LANDFALLS = {"SLCONS": (True, False), "BRIDGE": (True, True), "CBLOHD": (True, True)}


def area_objects(plan, seabed):
    """Coverage, data quality, the areas of the seabed and the planned areas."""
    limit = [plan.window.ring()]
    objects = [ChartObject("M_COVR", {"CATCOV": 1}, AREA, limit),
               ChartObject("M_QUAL", {"CATZOC": QUALITY_UNASSESSED}, AREA, limit)]
    objects += [ChartObject(area.acronym, area.attributes, AREA, area.rings) for area in seabed.areas]
    objects += [ChartObject(item.acronym, item.attributes, AREA, [closed_ring(item.where)]) for item in plan.areas]
    return objects


def line_objects(plan, seabed):
    """The planned lines, each checked to begin and end on land or in water as its class should."""
    objects = []
    for item in plan.lines:
        points = grid_points(item.where)
        ends = tuple(seabed.area_at(end).acronym == "LNDARE" for end in (points[0], points[-1]))
        if ends != LANDFALLS[item.acronym]:
            raise PlacementError(f"{plan.file_name}: the {item.acronym} from {item.where[0]} to {item.where[-1]} "
                                 f"has its ends on land: {ends}, wanted {LANDFALLS[item.acronym]}")
        objects.append(ChartObject(item.acronym, item.attributes, LINE, points))
    return objects


def point_objects(plan, seabed):
    """The planned points, all in water."""
    objects = []
    for item in plan.points:
        point = position(*item.where)
        if seabed.area_at(point).acronym == "LNDARE":
            raise PlacementError(f"{plan.file_name}: the {item.acronym} at {item.where} is on land")
        objects.append(ChartObject(item.acronym, item.attributes, POINT, [point]))
    return objects


def rings_kept_free(plan):
    """Where no danger is scattered: around the positions to keep clear and inside the fairways and lanes."""
    clearing = to_grid(CLEARING_DEG)
    rings = []
    for longitude_deg, latitude_deg in plan.clear_of:
        x, y = position(longitude_deg, latitude_deg)
        rings.append(rectangle(x - clearing, x + clearing, y - clearing, y + clearing))
    return rings + [closed_ring(item.where) for item in plan.areas if item.acronym in ("FAIRWY", "TSSLPT")]


def make_chart(plan, bins, folder):
    """Writes one chart and returns its path and the summary of the cell."""
    seabed = Seabed(plan.window, land_in_window(bins, plan.window.grown(LAND_MARGIN_DEG)))
    for item in plan.carved:
        seabed.carve(item.acronym, item.attributes, closed_ring(item.where))
    finder = PlaceFinder(seabed, plan.seed, rings_kept_free(plan), to_grid(DANGER_SPACING_DEG))
    objects = area_objects(plan, seabed) + line_objects(plan, seabed) + point_objects(plan, seabed)
    objects += scattered_dangers(finder, DANGER_COPIES)
    objects += soundings(seabed, plan.seed + 1, to_grid(SOUNDING_SPACING_DEG))
    header = CellHeader(scale=plan.scale, intended_use=INTENDED_USE_APPROACH, date=DATE, comment=plan.comment)
    path = os.path.join(folder, plan.file_name)
    return path, write_cell(path, header, plan.window, objects)


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", metavar="FOLDER", default=os.path.dirname(os.path.abspath(__file__)),
                        help="where the charts go (default: beside this script)")
    parser.add_argument("--gshhg", metavar="FILE", default=DEFAULT_FILE,
                        help="binned full-resolution shoreline (default: %(default)s)")
    return parser.parse_args(arguments)


def main(arguments=None):
    options = parse_arguments(arguments)
    gdal.UseExceptions()
    try:
        bins = ShorelineBins(options.gshhg)
        for plan in CHART_PLANS:
            path, summary = make_chart(plan, bins, options.out)
            print(f"{path}: {summary.bytes} bytes, {summary.features} features, {summary.isolated_nodes} isolated and "
                  f"{summary.connected_nodes} connected nodes, {summary.edges} edges")
    except RuntimeError as error:  # our own errors derive from it, and GDAL raises it
        print(f"make_maps.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
