"""Chain-node topology: the spatial records of a cell (S-57, DSSI_DSTR = 2).

S-57 areas don't carry their outlines: they refer to edges, and two areas that touch refer to the same edge, one
forwards, the other backwards. An edge runs from one connected node to another; features that stand alone at a point
refer to an isolated node.

`ChainNodeNetwork` takes the lines and areas of a cell as coordinates and finds the edges: every stretch along which the
set of features that use it stays the same.
"""
from dataclasses import dataclass, field

from grid import Window, twice_signed_area

ISOLATED_NODE, CONNECTED_NODE, EDGE = 110, 120, 130  # RCNM
FORWARD, REVERSE, NOT_RELEVANT = 1, 2, 255  # ORNT
EXTERIOR, INTERIOR, CUT_BY_LIMIT = 1, 2, 3  # USAG
POINT, LINE, AREA = 1, 2, 3  # PRIM

# An ISO 8211 record holds at most 99,999 bytes. GDAL writes a longer one without complaint and can't read it back.
MAX_EDGE_POINTS = 2000


@dataclass
class ChartObject:
    """A feature with its coordinates.

    `geometry` is for a POINT a list of (x, y), or of (x, y, depth) for soundings; for a LINE a list of (x, y); for an
    AREA a list of closed rings, exterior first.
    """

    acronym: str
    attributes: dict
    primitive: int
    geometry: list

    def is_meta(self):
        return self.acronym.startswith("M_")

    def is_group_one(self):
        return self.primitive == AREA and self.acronym in ("LNDARE", "DEPARE", "DRGARE", "UNSARE")


@dataclass(frozen=True)
class Reference:
    """One entry of a feature's list of spatial records."""

    record_name: int
    record_id: int
    orientation: int = NOT_RELEVANT
    usage: int = NOT_RELEVANT
    mask: int = NOT_RELEVANT


@dataclass
class ChainNodeNetwork:
    """The connected nodes and edges of a cell's lines and areas.

    After construction `nodes` maps a point to its record id, `edges` lists the points of each edge, end nodes included,
    (the record id is the place in the list plus 1), `users` lists for each edge the places of the objects that use it
    and `references` lists for each object its references.
    """

    window: Window
    objects: list
    nodes: dict = field(default_factory=dict)
    edges: list = field(default_factory=list)
    users: list = field(default_factory=list)
    references: list = field(default_factory=list)

    def __post_init__(self):
        paths_of_objects = self._paths()
        self._break_points = self._points_where_edges_end(paths_of_objects)
        self._edge_by_first_step = {}
        for place, (item, paths) in enumerate(zip(self.objects, paths_of_objects)):
            self.references.append([reference for hole, path in enumerate(paths)
                                    for reference in self._refer(place, item, path, bool(hole))])

    def _paths(self):
        """Each object's rings or line, turned the way S-57 wants and with a point wherever another one turns on the
        window's border."""
        stops = {point for item in self.objects for path in _raw_paths(item) for point in path}
        west_east = {x: sorted(y for px, y in stops if px == x) for x in (self.window.west, self.window.east)}
        south_north = {y: sorted(x for x, py in stops if py == y) for y in (self.window.south, self.window.north)}
        result = []
        for item in self.objects:
            paths = [self._with_stops(path, west_east, south_north) for path in _raw_paths(item)]
            if item.primitive == AREA:
                # Exterior rings run clockwise, holes counter-clockwise: the area lies to the right.
                paths = [path if (twice_signed_area(path) > 0) == (place > 0) else path[::-1]
                         for place, path in enumerate(paths)]
            result.append(paths)
        return result

    def _with_stops(self, path, west_east, south_north):
        result = path[:1]
        for (ax, ay), (bx, by) in zip(path, path[1:]):
            if ax == bx and ax in west_east:
                between = [(ax, y) for y in west_east[ax] if min(ay, by) < y < max(ay, by)]
                result += between if ay < by else between[::-1]
            elif ay == by and ay in south_north:
                between = [(x, ay) for x in south_north[ay] if min(ax, bx) < x < max(ax, bx)]
                result += between if ax < bx else between[::-1]
            result.append((bx, by))
        return result

    def _points_where_edges_end(self, paths_of_objects):
        """Ends of lines, points where more than two steps meet, and points where the users change."""
        owners = {}
        for place, paths in enumerate(paths_of_objects):
            for path in paths:
                for a, b in zip(path, path[1:]):
                    owners.setdefault((min(a, b), max(a, b)), set()).add(place)
        steps_at = {}
        for step in owners:
            for point in step:
                steps_at.setdefault(point, []).append(step)
        return {point for point, steps in steps_at.items()
                if len(steps) != 2 or owners[steps[0]] != owners[steps[1]]}

    def _refer(self, place, item, path, is_hole):
        references = []
        for chain in self._chains(path):
            record_id, orientation = self._edge(chain)
            if place not in self.users[record_id - 1]:
                self.users[record_id - 1].append(place)
            if item.primitive == LINE:
                usage = NOT_RELEVANT
            elif is_hole:
                usage = INTERIOR
            elif item.is_group_one() and self._runs_along_border(chain):
                usage = CUT_BY_LIMIT
            else:
                usage = EXTERIOR
            references.append(Reference(EDGE, record_id, orientation, usage))
        return references

    def _chains(self, path):
        """A path cut at the break points and where an edge would get too long."""
        if path[0] == path[-1]:
            first = next((i for i, point in enumerate(path[:-1]) if point in self._break_points), 0)
            path = path[first:-1] + path[:first + 1]
        chain = path[:1]
        for point in path[1:]:
            chain.append(point)
            if point in self._break_points or len(chain) == MAX_EDGE_POINTS or point == path[-1]:
                # Whoever comes along the same points later must stop here too.
                self._break_points.update((chain[0], point))
                yield chain
                chain = [point]

    def _edge(self, chain):
        """The record id and orientation of a chain, made on first use."""
        known = self._edge_by_first_step.get((chain[0], chain[1]))
        if known:
            return known
        self.edges.append(chain)
        self.users.append([])
        record_id = len(self.edges)
        for point in (chain[0], chain[-1]):
            self.nodes.setdefault(point, len(self.nodes) + 1)
        self._edge_by_first_step[(chain[0], chain[1])] = (record_id, FORWARD)
        self._edge_by_first_step[(chain[-1], chain[-2])] = (record_id, REVERSE)
        return record_id, FORWARD

    def _runs_along_border(self, chain):
        return all(self.window.holds_segment_on_border(a, b) for a, b in zip(chain, chain[1:]))


def _raw_paths(item):
    if item.primitive == AREA:
        return item.geometry
    return [item.geometry] if item.primitive == LINE else []
