"""The integer grid of the cells and the few conversions to and from OGR geometries.

An S-57 cell stores a coordinate as a whole number: degrees times COMF. Everything in this folder works on those whole
numbers, x = longitude and y = latitude, because sums of products of whole numbers are exact: two areas either share a
boundary or they do not. A ring is a list of (x, y) whose first and last entries are equal.

One grid step is 1e-7 degree, about 1.1 cm on the ground. Whole numbers of this size (up to 1.8e9) are exact in the
double precision numbers that OGR and GEOS compute with.
"""
from dataclasses import dataclass

from osgeo import ogr

COMF = 10_000_000


def to_grid(degrees):
    """The grid number next to an angle in degrees."""
    return int(round(degrees * COMF))


def to_degrees(number):
    """The angle in degrees of a grid number."""
    return number / COMF


def position(longitude_deg, latitude_deg):
    """The grid point (x, y) of a position in degrees."""
    return to_grid(longitude_deg), to_grid(latitude_deg)


@dataclass(frozen=True)
class Window:
    """A rectangle of the grid, limits included."""

    west: int
    east: int
    south: int
    north: int

    @classmethod
    def from_degrees(cls, west, east, south, north):
        return cls(to_grid(west), to_grid(east), to_grid(south), to_grid(north))

    def grown(self, margin_deg):
        """The window with a margin in degrees on each side."""
        margin = to_grid(margin_deg)
        return Window(self.west - margin, self.east + margin, self.south - margin, self.north + margin)

    def ring(self):
        """The closed outline, clockwise."""
        return rectangle(self.west, self.east, self.south, self.north)

    def twice_area(self):
        """Twice the area in square grid steps, exact."""
        return 2 * (self.east - self.west) * (self.north - self.south)

    def contains_strictly(self, point):
        """Whether a point lies inside and not on the outline."""
        return self.west < point[0] < self.east and self.south < point[1] < self.north

    def holds_segment_on_border(self, a, b):
        """Whether the segment from a to b runs along the outline."""
        return (a[0] == b[0] and a[0] in (self.west, self.east)) or (a[1] == b[1] and a[1] in (self.south, self.north))


def rectangle(west, east, south, north):
    """A closed clockwise ring."""
    return [(west, south), (west, north), (east, north), (east, south), (west, south)]


def twice_signed_area(ring):
    """Twice the signed area of a closed ring in square grid steps: exact, positive if counter-clockwise."""
    return sum(ax * by - bx * ay for (ax, ay), (bx, by) in zip(ring, ring[1:]))


def twice_area(rings):
    """Twice the area of a polygon given as its exterior ring followed by its holes, exact."""
    exterior, *holes = (abs(twice_signed_area(ring)) for ring in rings)
    return exterior - sum(holes)


def snapped_ring(coordinates):
    """Coordinates rounded to the grid, repeated points dropped."""
    ring = []
    for x, y in coordinates:
        point = (int(round(x)), int(round(y)))
        if not ring or point != ring[-1]:
            ring.append(point)
    return ring


def polygon_from_rings(rings):
    """The OGR polygon of an exterior ring and its holes."""
    polygon = ogr.Geometry(ogr.wkbPolygon)
    for ring in rings:
        linear = ogr.Geometry(ogr.wkbLinearRing)
        for x, y in ring:
            linear.AddPoint_2D(x, y)
        polygon.AddGeometry(linear)
    return polygon


def rings_from_polygon(polygon):
    """The rings of an OGR polygon, exterior first, snapped and closed; rings that vanish on the grid are left out."""
    rings = [snapped_ring(polygon.GetGeometryRef(i).GetPoints()) for i in range(polygon.GetGeometryCount())]
    return [ring for ring in rings if len(ring) >= 4]


def polygons_of(geometry):
    """Every polygon inside an OGR geometry; points and lines, which an overlay can leave behind, are dropped."""
    kind = ogr.GT_Flatten(geometry.GetGeometryType())
    if kind == ogr.wkbPolygon:
        return [] if geometry.IsEmpty() else [geometry.Clone()]
    if kind in (ogr.wkbMultiPolygon, ogr.wkbGeometryCollection):
        parts = (geometry.GetGeometryRef(i) for i in range(geometry.GetGeometryCount()))
        return [polygon for part in parts for polygon in polygons_of(part)]
    return []


def multipolygon(polygons):
    """One OGR multipolygon of many polygons."""
    result = ogr.Geometry(ogr.wkbMultiPolygon)
    for polygon in polygons:
        result.AddGeometry(polygon)
    return result


def point_geometry(point):
    """The OGR point of a grid point."""
    geometry = ogr.Geometry(ogr.wkbPoint)
    geometry.AddPoint_2D(*point)
    return geometry


def line_geometry(points):
    """The OGR line through grid points."""
    geometry = ogr.Geometry(ogr.wkbLineString)
    for x, y in points:
        geometry.AddPoint_2D(x, y)
    return geometry
