"""Closed land polygons from the binned full-resolution shoreline of GSHHG.

The netCDF file `binned_GSHHS_f.nc` cuts the shorelines of the world along one-degree bins. A bin holds directed
segments, each with a level (1 = shore between sea and land, 2 = shore of a lake, ...), the side of the bin on which it
enters and the side on which it leaves (0 south, 1 east, 2 north, 3 west, 4 = neither: a closed shoreline inside the
bin), and points relative to the bin's south-west corner, 0 to 65535 across the bin. The four corners of a bin carry the
level of what lies there.

A shoreline keeps the land on its left. So the land inside a bin is found by walking: along a segment to its exit, then
counter-clockwise along the bin's outline to the next entry, until the walk closes. All of it is done in whole numbers.
The levels of the corners are not needed for that and serve as a check of every bin.

Lakes (level 2 and above) are not cut out of the land.
"""
import array

from osgeo import gdal

from grid import COMF, Window, multipolygon, polygon_from_rings, polygons_of, rings_from_polygon

DEFAULT_FILE = "/usr/share/gmt-gshhg/binned_GSHHS_f.nc"
LAND_LEVEL = 1
BIN_UNITS = 65535
CLOSED = 4

_NUMBER_CODES = {gdal.GDT_Int16: "h", gdal.GDT_Int32: "i"}


class ShorelineError(RuntimeError):
    """The shoreline file can't be read or contradicts itself."""


class ShorelineBins:
    """Reads bins of a GSHHG netCDF file through GDAL's multidimensional interface."""

    def __init__(self, path):
        dataset = gdal.OpenEx(path, gdal.OF_MULTIDIM_RASTER)
        if dataset is None:
            raise ShorelineError(f"{path}: GDAL can't open the shoreline file")
        self._path = path
        self._group = dataset.GetRootGroup()
        self.version = self._group.GetAttribute("version").Read()
        self.minutes = self._numbers("Bin_size_in_minutes", 0, 1)[0]
        self.columns = self._numbers("N_bins_in_360_longitude_range", 0, 1)[0]
        self.rows = self._numbers("N_bins_in_180_degree_latitude_range", 0, 1)[0]

    def _numbers(self, name, start, count):
        numbers = array.array("i")
        if count == 0:
            return numbers
        variable = self._group.OpenMDArray(name)
        if variable is None:
            raise ShorelineError(f"{self._path}: no variable {name}")
        numbers = array.array(_NUMBER_CODES[variable.GetDataType().GetNumericDataType()])
        numbers.frombytes(bytes(variable.Read([start], [count])))
        return numbers

    def corner_levels(self, column, row):
        """Levels at the corners SW, SE, NE, NW; rows count from the north."""
        packed = self._numbers("Embedded_node_levels_in_a_bin", row * self.columns + column % self.columns, 1)[0]
        return [(packed >> shift) & 7 for shift in (9, 6, 3, 0)]

    def segments(self, column, row, level=LAND_LEVEL):
        """The segments of one level as (entry side, exit side, points in bin units)."""
        index = row * self.columns + column % self.columns
        first = self._numbers("Id_of_first_segment_in_a_bin", index, 1)[0]
        count = self._numbers("N_segments_in_a_bin", index, 1)[0]
        packed = self._numbers("Embedded_npts_levels_exit_entry_for_a_segment", first, count)
        starts = self._numbers("Id_of_first_point_in_a_segment", first, count)
        found = []
        for word, start in zip(packed, starts):
            if (word >> 6) & 7 != level:
                continue
            length = (word & 0xFFFFFFFF) >> 9
            xs = self._numbers("Relative_longitude_from_SW_corner_of_bin", start, length)
            ys = self._numbers("Relative_latitude_from_SW_corner_of_bin", start, length)
            points = [(x & 0xFFFF, y & 0xFFFF) for x, y in zip(xs, ys)]
            found.append(((word >> 3) & 7, word & 7, points))
        return found

    def bins_touching(self, window):
        """The (column, row) of every bin that a window touches."""
        size = self.minutes * COMF // 60
        top = 90 * COMF
        for row in range((top - window.north) // size, -((window.south - top) // size)):
            for column in range(window.west // size, -(-window.east // size)):
                yield column, row

    def to_grid(self, column, row, point):
        """A point in bin units as the next point of the chart's grid, rounded once and in whole numbers."""
        x = column * BIN_UNITS + point[0]
        y = (self.rows - 1 - row) * BIN_UNITS + point[1]
        return self._rounded(x), self._rounded(y) - 90 * COMF

    def _rounded(self, bin_units):
        divisor = 60 * BIN_UNITS
        return (2 * bin_units * self.minutes * COMF + divisor) // (2 * divisor)


def place_on_outline(side, point):
    """How far along the outline of a bin, counter-clockwise from its south-west corner, a point of a side lies."""
    x, y = point
    offsets = (x, y, BIN_UNITS - x, BIN_UNITS - y)
    distances = (y, BIN_UNITS - x, BIN_UNITS - y, x)
    if distances[side] != 0:
        raise ShorelineError(f"a segment ends at {point} in the bin instead of on side {side}")
    return side * BIN_UNITS + offsets[side]


def land_rings_of_bin(segments, corner_levels, level=LAND_LEVEL):
    """The outlines of the land in one bin, in bin units.

    Raises ShorelineError where the walk contradicts the level of a corner.
    """
    rings = [points for entry, leave, points in segments if CLOSED in (entry, leave)]
    rings = [ring if ring[0] == ring[-1] else ring + ring[:1] for ring in rings]
    corners = [(0, 0), (BIN_UNITS, 0), (BIN_UNITS, BIN_UNITS), (0, BIN_UNITS)]
    around = 4 * BIN_UNITS
    crossing = [(place_on_outline(entry, points[0]), place_on_outline(leave, points[-1]), points)
                for entry, leave, points in segments if CLOSED not in (entry, leave)]
    if not crossing:
        if min(corner_levels) >= level:
            rings.append(corners + corners[:1])
        elif max(corner_levels) >= level:
            raise ShorelineError("the corners of a bin differ but no shoreline parts them")
        return rings

    on_land = set()
    waiting = sorted(crossing)
    while waiting:
        segment = waiting.pop(0)
        first_entry = segment[0]
        ring = list(segment[2])
        while True:
            left_at = segment[1]
            ahead = [(first_entry - left_at) % around] + [(other[0] - left_at) % around for other in waiting]
            nearest = min(range(len(ahead)), key=ahead.__getitem__)
            passed = sorted(((corner * BIN_UNITS - left_at) % around, corner) for corner in range(4))
            for distance, corner in passed:
                if distance <= ahead[nearest]:
                    on_land.add(corner)
                    ring.append(corners[corner])
            if nearest == 0:
                break
            segment = waiting.pop(nearest - 1)
            ring.extend(segment[2])
        rings.append(ring + ring[:1])
    if on_land != {corner for corner in range(4) if corner_levels[corner] >= level}:
        raise ShorelineError(f"the shoreline puts the corners {sorted(on_land)} on land, "
                             f"their levels are {corner_levels}")
    return rings


def shoreline_points(bins, window):
    """Every point of the land's shoreline strictly inside a window, on the grid."""
    points = set()
    for column, row in bins.bins_touching(window):
        for _, _, segment in bins.segments(column, row):
            points.update(bins.to_grid(column, row, point) for point in segment)
    return {point for point in points if window.contains_strictly(point)}


def land_in_window(bins, window: Window):
    """The land inside a window as OGR polygons on the grid, largest first."""
    pieces = []
    for column, row in bins.bins_touching(window):
        try:
            rings = land_rings_of_bin(bins.segments(column, row), bins.corner_levels(column, row))
        except ShorelineError as error:
            raise ShorelineError(f"GSHHG bin column {column} row {row}: {error}") from error
        for ring in rings:
            pieces.append(polygon_from_rings([[bins.to_grid(column, row, point) for point in ring]]))
    land = multipolygon(pieces).UnionCascaded() if pieces else multipolygon([])
    clipped = land.Intersection(polygon_from_rings([window.ring()]))
    polygons = [polygon_from_rings(rings) for rings in map(rings_from_polygon, polygons_of(clipped)) if rings]
    broken = [polygon for polygon in polygons if not polygon.IsValid()]
    if broken:
        raise ShorelineError(f"{len(broken)} land polygons are not valid on the grid")
    return sorted(polygons, key=lambda polygon: (-polygon.GetArea(), polygon.ExportToWkt()))
