#!/usr/bin/env python3
"""Reads the project's charts back with GDAL and checks them.

For each cell: the counts in the header against the records, every geometry, the exact tiling of the coverage by group 1
on the integer grid, and messages of the driver. For the charts of this folder also: land equal to the GSHHG shoreline
(where gmt-gshhg-full is installed), named positions in water, and water that hangs together. Exits with 1 if anything
is wrong.
"""
import argparse
import os
import sys
from collections import Counter

from osgeo import gdal, ogr

from chart_plans import CHART_PLANS
from grid import COMF, snapped_ring, twice_area, twice_signed_area
from gshhg import DEFAULT_FILE, ShorelineBins, shoreline_points
from reachability import WaterPicture
from topology import AREA, LINE, POINT

GROUP_ONE_CLASSES = ("DEPARE", "DRGARE", "LNDARE", "UNSARE")
PRIMITIVE_COUNTS = {"IsolatedNode": "DSSI_NOIN", "ConnectedNode": "DSSI_NOCN", "Edge": "DSSI_NOED"}
FEATURE_COUNTS = ("DSSI_NOMR", "DSSI_NOCR", "DSSI_NOGR", "DSSI_NOLR")
GEOMETRY_OF_PRIMITIVE = {POINT: (ogr.wkbPoint, ogr.wkbMultiPoint), LINE: (ogr.wkbLineString,),
                         AREA: (ogr.wkbPolygon,)}
WANTED_HEADER = {"DSPM_DUNI": 1, "DSPM_COMF": COMF, "DSSI_DSTR": 2, "DSSI_AALL": 0, "DSSI_NALL": 0, "DSID_EDTN": "1",
                 "DSID_UPDN": "0", "DSPM_SDAT": 23, "DSPM_VDAT": 17}
LEAST_SHARE_REACHED = 0.9


class Cell:
    """Everything that GDAL reads from a cell, and what it said while reading."""

    def __init__(self, path):
        self.messages = []
        gdal.PushErrorHandler(lambda level, number, text: self.messages.append(text))
        try:
            options = ["UPDATES=IGNORE", "RETURN_PRIMITIVES=ON", "RETURN_LINKAGES=ON", "LNAM_REFS=ON"]
            self._dataset = gdal.OpenEx(path, gdal.OF_VECTOR, allowed_drivers=["S57"], open_options=options)
            layers = {layer.GetName(): list(layer) for layer in map(self._dataset.GetLayer,
                                                                    range(self._dataset.GetLayerCount()))}
        finally:
            gdal.PopErrorHandler()
        self.header = layers.pop("DSID")[0]
        self.primitives = {name: layers.pop(name, []) for name in PRIMITIVE_COUNTS}
        layers.pop("Face", None)
        self.layers = layers

    def features(self):
        return [feature for features in self.layers.values() for feature in features]

    def areas(self, *acronyms):
        """The polygons of some classes as closed rings on the grid, exterior clockwise, holes counter-clockwise."""
        return [grid_rings(feature.GetGeometryRef()) for acronym in acronyms
                for feature in self.layers.get(acronym, []) if feature["PRIM"] == AREA]


def paths_of(geometry):
    """The points of a line or of each ring of a polygon; nothing for points."""
    kind = ogr.GT_Flatten(geometry.GetGeometryType())
    if kind == ogr.wkbPolygon:
        return [geometry.GetGeometryRef(place).GetPoints() for place in range(geometry.GetGeometryCount())]
    return [geometry.GetPoints()] if kind == ogr.wkbLineString else []


def grid_rings(polygon):
    """The rings of a polygon in degrees on the grid, exterior clockwise, holes counter-clockwise."""
    rings = []
    for place, degrees in enumerate(paths_of(polygon)):
        ring = snapped_ring((point[0] * COMF, point[1] * COMF) for point in degrees)
        rings.append(ring if (twice_signed_area(ring) > 0) == (place > 0) else ring[::-1])
    return rings


def header_faults(cell):
    """Counts and settings of the header that don't hold."""
    for name, wanted in WANTED_HEADER.items():
        if cell.header[name] != wanted:
            yield f"{name} is {cell.header[name]}, wanted {wanted}"
    for layer, name in PRIMITIVE_COUNTS.items():
        if cell.header[name] != len(cell.primitives[layer]):
            yield f"{name} says {cell.header[name]}, the cell has {len(cell.primitives[layer])} {layer} records"
    declared = sum(cell.header[name] for name in FEATURE_COUNTS)
    if declared != len(cell.features()):
        yield f"the header declares {declared} features, the cell has {len(cell.features())}"
    meta = sum(len(features) for acronym, features in cell.layers.items() if acronym.startswith("M_"))
    if cell.header["DSSI_NOMR"] != meta:
        yield f"DSSI_NOMR says {cell.header['DSSI_NOMR']}, the cell has {meta} meta features"


def geometry_faults(cell):
    """Features whose geometry is missing, invalid, not of the kind that PRIM says or repeats a point."""
    for feature in cell.features():
        name = f"{feature.GetDefnRef().GetName()} FIDN {feature['FIDN']}"
        geometry = feature.GetGeometryRef()
        if geometry is None or geometry.IsEmpty():
            yield f"{name} has no geometry"
        elif ogr.GT_Flatten(geometry.GetGeometryType()) not in GEOMETRY_OF_PRIMITIVE[feature["PRIM"]]:
            yield f"{name} has PRIM {feature['PRIM']} but is a {geometry.GetGeometryName()}"
        elif not geometry.IsValid():
            yield f"{name} has an invalid geometry"
        elif any(a == b for path in paths_of(geometry) for a, b in zip(path, path[1:])):
            yield f"{name} repeats a point"


def tiling_faults(cell):
    """Whether group 1 tiles the coverage exactly.

    Two proofs in whole numbers. The areas add up. And every step of an outline is cancelled by the same step backwards
    in exactly one neighbour, save for those that make up the outline of the coverage.
    """
    covered = [rings for feature, rings in zip(cell.layers.get("M_COVR", []), cell.areas("M_COVR"))
               if feature["CATCOV"] == 1]
    group_one = cell.areas(*GROUP_ONE_CLASSES)
    difference = sum(map(twice_area, covered)) - sum(map(twice_area, group_one))
    if difference != 0:
        yield f"group 1 and the coverage differ by {difference} half square grid steps"
    steps = Counter(step for rings in group_one for ring in rings for step in zip(ring, ring[1:]))
    repeated = [step for step, count in steps.items() if count > 1]
    if repeated:
        yield f"{len(repeated)} steps of group 1 outlines belong to two areas on the same side, first {repeated[0]}"
    uncancelled = {(a, b) for a, b in steps if (b, a) not in steps}
    outline = {step for rings in covered for ring in rings for step in zip(ring, ring[1:])}
    if uncancelled != outline:
        yield f"{len(uncancelled ^ outline)} steps of group 1 outlines have no neighbour inside the coverage"


def shoreline_faults(cell, window, bins):
    """Whether the points of the land's outlines are those of GSHHG."""
    land = {point for rings in cell.areas("LNDARE") for ring in rings for point in ring}
    land = {point for point in land if window.contains_strictly(point)}
    wanted = shoreline_points(bins, window)
    if land != wanted:
        yield f"{len(land - wanted)} points of land are not in GSHHG, {len(wanted - land)} of GSHHG are not in the cell"


def water_faults(cell, plan):
    """Whether the plan's positions are in water and within reach of each other, and most water is."""
    for longitude_deg, latitude_deg in plan.clear_of:
        where = ogr.CreateGeometryFromWkt(f"POINT ({longitude_deg} {latitude_deg})")
        holders = [acronym for acronym in GROUP_ONE_CLASSES for feature in cell.layers.get(acronym, [])
                   if feature.GetGeometryRef().Intersects(where)]
        if holders != ["DEPARE"]:
            yield f"the position {latitude_deg} N {longitude_deg} E lies in {holders}, wanted one DEPARE"
    window = plan.window
    picture = WaterPicture(cell.features(), [side / COMF for side in (window.west, window.east, window.south,
                                                                      window.north)])
    pixels = [picture.pixel(*entry) for entry in plan.clear_of]
    if not all(map(picture.is_free, pixels)):
        yield "a named position is blocked"
        return
    reached = picture.reached_from(pixels[0])
    if not all(reached[pixel] for pixel in pixels):
        yield "the named positions are not within reach of each other"
    share = sum(reached) / picture.free_count()
    if share < LEAST_SHARE_REACHED:
        yield f"only {share:.1%} of the free water hangs together"


def faults_of(cell, plan, bins):
    """All faults of a cell; `plan` and `bins` may be None."""
    faults = [f"GDAL says: {message}" for message in cell.messages]
    broken = list(geometry_faults(cell))
    faults += list(header_faults(cell)) + broken
    if not broken:
        faults += tiling_faults(cell)
        faults += shoreline_faults(cell, plan.window, bins) if plan and bins else []
        faults += water_faults(cell, plan) if plan else []
    return faults


def print_summary(path, cell, plan, bins):
    print(f"{path}: {os.path.getsize(path)} bytes, 1:{cell.header['DSPM_CSCL']}, edition {cell.header['DSID_EDTN']}, "
          f"{len(cell.features())} features, "
          + ", ".join(f"{len(records)} {name}" for name, records in cell.primitives.items()))
    for acronym in sorted(cell.layers):
        kinds = Counter(feature["PRIM"] for feature in cell.layers[acronym])
        parts = [f"{kinds[primitive]} {word}" for primitive, word in ((POINT, "point"), (LINE, "line"), (AREA, "area"))
                 if kinds[primitive]]
        print(f"  {acronym:<7} {', '.join(parts)}")
    if not plan:
        print("  not a chart of this folder: shoreline and water not checked")
    elif not bins:
        print("  gmt-gshhg-full is not installed: shoreline not checked")


def parse_arguments(arguments):
    folder = os.path.dirname(os.path.abspath(__file__))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cells", nargs="*", metavar="CELL", default=[os.path.join(folder, plan.file_name)
                                                                     for plan in CHART_PLANS],
                        help="cells to check (default: the two charts beside this script)")
    parser.add_argument("--gshhg", metavar="FILE", default=DEFAULT_FILE,
                        help="binned full-resolution shoreline (default: %(default)s)")
    return parser.parse_args(arguments)


def main(arguments=None):
    options = parse_arguments(arguments)
    gdal.UseExceptions()
    plans = {plan.file_name: plan for plan in CHART_PLANS}
    bins = ShorelineBins(options.gshhg) if os.path.exists(options.gshhg) else None
    found = 0
    for path in options.cells:
        plan = plans.get(os.path.basename(path))
        try:
            cell = Cell(path)
        except RuntimeError as error:
            print(f"{path}: FAILED: {error}")
            found += 1
            continue
        print_summary(path, cell, plan, bins)
        faults = faults_of(cell, plan, bins)
        for fault in faults:
            print(f"  FAILED: {fault}")
        print("  OK" if not faults else f"  {len(faults)} faults")
        found += len(faults)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
