"""The kinds of synthetic dangers and the places where they are put.

A table, not code, says what there is: for each class the combinations of WATLEV, CATWRK, CATOBS, EXPSOU, QUASOU and
VALSOU that a reader of charts has to tell apart, with and without a depth.
"""
import random
from dataclasses import dataclass

from grid import point_geometry, polygon_from_rings
from seabed import depth_label
from topology import POINT, ChartObject

MAX_TRIES = 10_000


class PlacementError(RuntimeError):
    """No place was found for a synthetic object, or its place contradicts its kind."""


@dataclass(frozen=True)
class DangerKind:
    """A kind of danger and the depths of the water in which it may stand.

    `depth_share`: VALSOU as a share of the depth of the water, None where VALSOU is absent or fixed by `attributes`.
    """

    acronym: str
    attributes: dict
    shallowest_m: float = 2.0
    deepest_m: float = 30.0
    depth_share: float = None


DANGER_KINDS = (
    DangerKind("UWTROC", {"WATLEV": 3}, 2, 20, 0.5),
    DangerKind("UWTROC", {"WATLEV": 3, "QUASOU": [7]}, 5, 20, 0.8),
    DangerKind("UWTROC", {"WATLEV": 3}, 2, 20),
    DangerKind("UWTROC", {"WATLEV": 3, "EXPSOU": 1}, 5, 20),
    DangerKind("UWTROC", {"WATLEV": 4, "VALSOU": -0.8}, 1, 10),
    DangerKind("UWTROC", {"WATLEV": 4}, 1, 10),
    DangerKind("UWTROC", {"WATLEV": 5, "VALSOU": 0.0}, 1, 10),
    DangerKind("UWTROC", {"WATLEV": 5}, 1, 10),
    DangerKind("WRECKS", {"CATWRK": 1, "WATLEV": 3}, 10, 30, 0.8),
    DangerKind("WRECKS", {"CATWRK": 1, "WATLEV": 3}, 20, 30),
    DangerKind("WRECKS", {"CATWRK": 2, "WATLEV": 3}, 5, 20, 0.3),
    DangerKind("WRECKS", {"CATWRK": 2, "WATLEV": 3}, 5, 20),
    DangerKind("WRECKS", {"CATWRK": 2, "WATLEV": 5}, 5, 10),
    DangerKind("WRECKS", {"CATWRK": 3, "WATLEV": 3}, 10, 20, 0.7),
    DangerKind("WRECKS", {"CATWRK": 4, "WATLEV": 4}, 5, 20),
    DangerKind("WRECKS", {"CATWRK": 5, "WATLEV": 1}, 2, 10),
    DangerKind("WRECKS", {"WATLEV": 3, "EXPSOU": 1}, 10, 20),
    DangerKind("OBSTRN", {"WATLEV": 3}, 5, 20, 0.4),
    DangerKind("OBSTRN", {"WATLEV": 3}, 5, 20),
    DangerKind("OBSTRN", {"CATOBS": 1, "WATLEV": 3}, 2, 10, 0.5),
    DangerKind("OBSTRN", {"CATOBS": 2, "WATLEV": 3}, 10, 30, 0.7),
    DangerKind("OBSTRN", {"CATOBS": 5, "WATLEV": 3, "QUASOU": [6]}, 10, 20, 0.8),
    DangerKind("OBSTRN", {"CATOBS": 6, "WATLEV": 3}, 5, 20),
    DangerKind("OBSTRN", {"CATOBS": 7, "WATLEV": 3}, 10, 20),
    DangerKind("OBSTRN", {"WATLEV": 4, "VALSOU": -0.5}, 1, 5),
    DangerKind("OBSTRN", {"WATLEV": 5}, 1, 5),
    DangerKind("OBSTRN", {"WATLEV": 2}, 1, 5),
    DangerKind("OBSTRN", {"WATLEV": 7}, 5, 20),
)


class PlaceFinder:
    """Finds places for points on a seabed: reproducible, apart from each other and from what is kept free.

    `kept_free` is a list of closed rings; `spacing` is in grid steps, measured along each axis.
    """

    def __init__(self, seabed, seed, kept_free, spacing):
        self._seabed = seabed
        self._random = random.Random(seed)
        self._kept_free = [polygon_from_rings([ring]) for ring in kept_free]
        self._spacing = spacing
        self._taken = []

    def place(self, shallowest_m, deepest_m):
        """A point whose water is between two depths, and its depth in metres."""
        window = self._seabed.window
        for _ in range(MAX_TRIES):
            point = (self._between(window.west, window.east), self._between(window.south, window.north))
            if not self._is_free(point):
                continue
            depth_m = self._seabed.depth_at(point)
            if depth_m is not None and shallowest_m <= depth_m <= deepest_m:
                self._taken.append(point)
                return point, depth_m
        raise PlacementError(f"no free place in water of {shallowest_m} to {deepest_m} m")

    def _between(self, low, high):
        """A number at least one spacing away from both limits."""
        return low + self._spacing + int(self._random.random() * (high - low - 2 * self._spacing))

    def _is_free(self, point):
        if any(max(abs(point[0] - x), abs(point[1] - y)) < self._spacing for x, y in self._taken):
            return False
        where = point_geometry(point)
        return not any(polygon.Intersects(where) for polygon in self._kept_free)


def scattered_dangers(finder, copies, kinds=DANGER_KINDS):
    """Every kind of danger, `copies` times, each at a place that suits it."""
    objects = []
    for copy in range(copies):
        for number, kind in enumerate(kinds, copy * len(kinds) + 1):
            point, depth_m = finder.place(kind.shallowest_m, kind.deepest_m)
            attributes = dict(kind.attributes)
            if kind.depth_share is not None:
                attributes["VALSOU"] = depth_label(depth_m * kind.depth_share)
            attributes["OBJNAM"] = f"Synthetic {kind.acronym} {number}"
            objects.append(ChartObject(kind.acronym, attributes, POINT, [point]))
    return objects


def soundings(seabed, seed, spacing):
    """Soundings about `spacing` grid steps apart, one SOUNDG object for each row that has any."""
    generator = random.Random(seed)
    window = seabed.window
    objects = []
    for south in range(window.south, window.north - spacing, spacing):
        row = []
        for west in range(window.west, window.east - spacing, spacing):
            point = (west + int(spacing * (0.2 + 0.6 * generator.random())),
                     south + int(spacing * (0.2 + 0.6 * generator.random())))
            depth_m = seabed.depth_at(point)
            if depth_m is not None:
                row.append((*point, depth_label(depth_m)))
        if row:
            objects.append(ChartObject("SOUNDG", {}, POINT, row))
    return objects
