"""A synthetic seabed: depth areas nested around the real shoreline.

The depth at a point depends on its distance to the nearest land only. Bands of distance become depth areas that tile
the window together with the land, exactly, because each area is the difference of two nested shapes on the grid: a
boundary between two areas is the same list of points in both.
"""
import math
from dataclasses import dataclass

from grid import (COMF, Window, multipolygon, point_geometry, polygon_from_rings, polygons_of, rings_from_polygon,
                  twice_area)

METRES_PER_DEGREE = 111_195.0  # of a sphere with radius 6,371 km: these depths need no ellipsoid
QUADRANT_SEGMENTS = 6
SOUNDING_STEP_M = 0.1


class SeabedError(RuntimeError):
    """The depth areas don't tile the window, or something doesn't fit on them."""


@dataclass(frozen=True)
class Band:
    """A depth area: from the previous band's reach to this reach in metres from land (None = all the rest)."""

    reach_m: float
    shallow_m: float
    deep_m: float


BANDS = (
    Band(120.0, -1.0, 0.0),
    Band(350.0, 0.0, 2.0),
    Band(900.0, 2.0, 5.0),
    Band(2500.0, 5.0, 10.0),
    Band(6000.0, 10.0, 20.0),
    Band(None, 20.0, 30.0),
)
METRES_PER_METRE_OF_DEPTH_OFFSHORE = 1000.0  # slope beyond the last limited band


@dataclass
class Area:
    """One area of the seabed (S-57 group 1) on the grid."""

    acronym: str
    attributes: dict
    rings: list

    def polygon(self):
        return polygon_from_rings(self.rings)


def depth_label(depth_m):
    """A depth rounded to the decimetre towards the surface: never deeper than the seabed it stands for."""
    return math.floor(depth_m / SOUNDING_STEP_M + 1e-6) / 10.0


class Seabed:
    """Depth areas of a window and the depth at a point.

    `land_around` are the land polygons on the grid, also beyond the window as far as the widest limited band reaches.
    """

    def __init__(self, window: Window, land_around, bands=BANDS):
        self.window = window
        self._bands = bands
        middle = math.radians((window.south + window.north) / 2 / COMF)
        self._metres_north = METRES_PER_DEGREE / COMF
        self._metres_east = self._metres_north * math.cos(middle)
        self._land_m = multipolygon([self._to_metres(polygon) for polygon in land_around])
        self.areas = self._nested_areas(multipolygon(land_around))
        self._check_tiling()

    def distance_to_land_m(self, point):
        """Metres from a grid point to the nearest land, 0 on land."""
        return self._land_m.Distance(point_geometry(self._point_m(point)))

    def area_at(self, point):
        """The area that holds a grid point."""
        where = point_geometry(point)
        for area in self.areas:
            if area.polygon().Intersects(where):
                return area
        raise SeabedError(f"the point {point} lies in no area of the seabed")

    def depth_at(self, point):
        """The depth in metres at a point of a depth area, None elsewhere; always within the area's own limits."""
        area = self.area_at(point)
        if area.acronym != "DEPARE":
            return None
        shallow, deep = area.attributes["DRVAL1"], area.attributes["DRVAL2"]
        return min(max(self._depth_at_distance(self.distance_to_land_m(point)), shallow), deep)

    def carve(self, acronym, attributes, ring):
        """Turns a ring strictly inside one depth area into an area of its own."""
        shape = polygon_from_rings([ring])
        for host in self.areas:
            polygon = host.polygon()
            if host.acronym == "DEPARE" and polygon.Contains(shape) and not polygon.Boundary().Intersects(shape):
                host.rings.append(list(ring))
                self.areas.append(Area(acronym, attributes, [list(ring)]))
                self._check_tiling()
                return
        raise SeabedError(f"the {acronym} at {ring[0]} does not lie inside one depth area")

    def _point_m(self, point):
        return ((point[0] - self.window.west) * self._metres_east,
                (point[1] - self.window.south) * self._metres_north)

    def _to_metres(self, polygon):
        return polygon_from_rings([[self._point_m(point) for point in ring] for ring in rings_from_polygon(polygon)])

    def _to_window(self, geometry_m):
        """A geometry in metres as one multipolygon on the grid, clipped to the window."""
        polygons = []
        for polygon in polygons_of(geometry_m):
            rings = (polygon.GetGeometryRef(i).GetPoints() for i in range(polygon.GetGeometryCount()))
            polygons.append(polygon_from_rings([[(x / self._metres_east + self.window.west,
                                                  y / self._metres_north + self.window.south) for x, y in ring]
                                                for ring in rings]))
        return self._clipped(multipolygon(polygons))

    def _clipped(self, geometry):
        return self._on_grid(geometry.Intersection(polygon_from_rings([self.window.ring()])))

    @staticmethod
    def _on_grid(geometry):
        rings_of_polygons = (rings_from_polygon(polygon) for polygon in polygons_of(geometry))
        snapped = multipolygon([polygon_from_rings(rings) for rings in rings_of_polygons if rings])
        if not snapped.IsValid():
            raise SeabedError("a depth area is not valid on the grid")
        return snapped

    def _nested_areas(self, land_around):
        inner = self._clipped(land_around)
        areas = self._areas_of("LNDARE", {}, inner)
        for band in self._bands:
            if band.reach_m is None:
                outer = multipolygon([polygon_from_rings([self.window.ring()])])
            else:
                # The tolerance is far below the distance between two limits, so nested shapes stay nested.
                grown = self._land_m.Buffer(band.reach_m, QUADRANT_SEGMENTS)
                outer = self._to_window(grown.SimplifyPreserveTopology(min(12.0, band.reach_m / 8)))
            depths = {"DRVAL1": band.shallow_m, "DRVAL2": band.deep_m}
            areas += self._areas_of("DEPARE", depths, self._on_grid(outer.Difference(inner)))
            inner = outer
        return areas

    @staticmethod
    def _areas_of(acronym, attributes, shape):
        areas = [Area(acronym, dict(attributes), rings_from_polygon(polygon)) for polygon in polygons_of(shape)]
        return sorted(areas, key=lambda area: (-twice_area(area.rings), area.rings))

    def _check_tiling(self):
        missing = self.window.twice_area() - sum(twice_area(area.rings) for area in self.areas)
        if missing != 0:
            raise SeabedError(f"the areas of the seabed miss the window by {missing} half square grid steps")

    def _depth_at_distance(self, distance_m):
        nearest = 0.0
        for band in self._bands:
            if band.reach_m is None:
                return band.shallow_m + (distance_m - nearest) / METRES_PER_METRE_OF_DEPTH_OFFSHORE
            if distance_m <= band.reach_m:
                share = (distance_m - nearest) / (band.reach_m - nearest)
                return band.shallow_m + (band.deep_m - band.shallow_m) * share
            nearest = band.reach_m
        return self._bands[-1].deep_m
