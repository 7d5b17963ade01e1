"""What is in the two charts apart from the shoreline: a list of objects for each, positions in degrees.

Every object here is invented. The names say so.
"""
from dataclasses import dataclass

from grid import Window, position


@dataclass(frozen=True)
class Planned:
    """An object placed by hand; `where` is one (longitude, latitude) for a point, else a list of them (areas open)."""

    acronym: str
    attributes: dict
    where: object


@dataclass(frozen=True)
class ChartPlan:
    """One chart. `clear_of` are positions that no scattered danger comes near; `carved` are areas of group 1."""

    file_name: str
    title: str
    window: Window
    scale: int
    seed: int
    clear_of: tuple
    carved: tuple
    areas: tuple
    lines: tuple
    points: tuple

    @property
    def comment(self):
        return f"{self.title}: shoreline GSHHG 2.3.7, depths and dangers synthetic, NOT FOR NAVIGATION"


def box(west, east, south, north):
    """The corners of a rectangle given in degrees."""
    return [(west, south), (west, north), (east, north), (east, south)]


def grid_points(where):
    """Positions in degrees as grid points."""
    return [position(*entry) for entry in where]


def closed_ring(where):
    """Corners in degrees as a closed ring on the grid."""
    ring = grid_points(where)
    return ring + ring[:1]


SHANGCHUAN = ChartPlan(
    file_name="shangchuan.000",
    title="Shangchuan Dao",
    window=Window.from_degrees(112.45, 113.10, 21.50, 22.05),
    scale=50_000,
    seed=20201,
    clear_of=((112.521, 21.635), (112.901, 21.669)),
    carved=(
        Planned("DRGARE", {"DRVAL1": 6.0, "QUASOU": [10], "OBJNAM": "Synthetic dredged basin"},
                box(112.565, 112.588, 21.7515, 21.7545)),
        Planned("UNSARE", {}, box(113.020, 113.070, 21.520, 21.555)),
    ),
    areas=(
        Planned("OBSTRN", {"CATOBS": 6, "WATLEV": 3, "OBJNAM": "Synthetic foul area"},
                [(112.972, 21.795), (112.985, 21.806), (112.998, 21.803), (113.002, 21.792), (112.986, 21.788)]),
        Planned("OBSTRN", {"CATOBS": 7, "WATLEV": 3, "OBJNAM": "Synthetic foul ground"},
                [(112.955, 21.665), (112.962, 21.674), (112.971, 21.668)]),
        Planned("RESARE", {"CATREA": [4], "RESTRN": [7], "OBJNAM": "Synthetic reserve, entry prohibited"},
                box(112.662, 112.684, 21.630, 21.650)),
        Planned("RESARE", {"RESTRN": [1, 3], "OBJNAM": "Synthetic area, anchoring and fishing prohibited"},
                box(112.700, 112.760, 21.795, 21.810)),
        Planned("RESARE", {"CATREA": [9], "OBJNAM": "Synthetic military area"}, box(113.030, 113.080, 21.600, 21.650)),
        Planned("TSSLPT", {"ORIENT": 270.0, "CATTSS": 2}, box(112.800, 112.980, 21.545, 21.560)),
        Planned("TSEZNE", {"CATTSS": 2}, box(112.800, 112.980, 21.535, 21.545)),
        Planned("TSSLPT", {"ORIENT": 90.0, "CATTSS": 2}, box(112.800, 112.980, 21.520, 21.535)),
        Planned("FAIRWY", {"DRVAL1": 5.0, "ORIENT": 338.0, "TRAFIC": 4, "OBJNAM": "Synthetic fairway"},
                [(112.955, 21.600), (112.855, 21.830), (112.870, 21.830), (112.970, 21.600)]),
        Planned("ACHARE", {"CATACH": [1], "OBJNAM": "Synthetic anchorage"}, box(112.780, 112.820, 21.880, 21.900)),
    ),
    lines=(
        Planned("SLCONS", {"CATSLC": 1, "WATLEV": 2, "OBJNAM": "Synthetic breakwater"},
                [(112.6500, 21.8250), (112.6590, 21.8215), (112.6640, 21.8195)]),
        Planned("BRIDGE", {"CATBRG": [1], "VERCLR": 12.0, "HORCLR": 40.0, "OBJNAM": "Synthetic bridge"},
                [(112.8130, 21.9720), (112.8280, 21.9720)]),
        Planned("CBLOHD", {"CATCBL": 1, "VERCLR": 30.0, "VERCSA": 25.0, "OBJNAM": "Synthetic overhead cable"},
                [(112.6550, 21.7000), (112.6750, 21.7060)]),
    ),
    points=(
        Planned("PILPNT", {"CATPLE": 3, "OBJNAM": "Synthetic pile"}, (112.6660, 21.8185)),
        Planned("BCNLAT", {"BCNSHP": 5, "CATLAM": 1, "COLOUR": [3], "MARSYS": 1}, (112.6655, 21.8200)),
        Planned("BCNCAR", {"BCNSHP": 3, "CATCAM": 3, "COLOUR": [6, 2], "COLPAT": [1], "MARSYS": 1},
                (112.5650, 21.7500)),
        Planned("BOYLAT", {"BOYSHP": 2, "CATLAM": 1, "COLOUR": [3], "MARSYS": 1}, (112.9540, 21.6000)),
        Planned("BOYLAT", {"BOYSHP": 1, "CATLAM": 2, "COLOUR": [4], "MARSYS": 1}, (112.9710, 21.6000)),
        Planned("BOYLAT", {"BOYSHP": 2, "CATLAM": 1, "COLOUR": [3], "MARSYS": 1}, (112.8540, 21.8300)),
        Planned("BOYLAT", {"BOYSHP": 1, "CATLAM": 2, "COLOUR": [4], "MARSYS": 1}, (112.8710, 21.8300)),
        Planned("BOYCAR", {"BOYSHP": 4, "CATCAM": 3, "COLOUR": [6, 2], "COLPAT": [1], "MARSYS": 1},
                (112.9860, 21.7850)),
        Planned("BOYISD", {"BOYSHP": 5, "COLOUR": [2, 3, 2], "COLPAT": [1], "MARSYS": 1}, (112.9500, 21.7300)),
        Planned("WRECKS", {"CATWRK": 2, "WATLEV": 3, "VALSOU": 4.0, "OBJNAM": "Synthetic marked wreck"},
                (112.9505, 21.7300)),
        Planned("BOYSPP", {"BOYSHP": 4, "CATSPM": [19], "COLOUR": [6], "MARSYS": 1}, (112.8000, 21.5400)),
    ),
)

SANYA = ChartPlan(
    file_name="sanya.000",
    title="Sanya",
    window=Window.from_degrees(109.30, 109.90, 18.05, 18.45),
    scale=45_000,
    seed=20171,
    clear_of=((109.420, 18.150), (109.780, 18.250)),
    carved=(
        Planned("DRGARE", {"DRVAL1": 6.0, "QUASOU": [10], "OBJNAM": "Synthetic dredged basin"},
                box(109.370, 109.400, 18.2835, 18.2860)),
        Planned("UNSARE", {}, box(109.800, 109.860, 18.080, 18.120)),
    ),
    areas=(
        Planned("OBSTRN", {"CATOBS": 6, "WATLEV": 3, "OBJNAM": "Synthetic foul area"},
                [(109.386, 18.226), (109.389, 18.236), (109.398, 18.234), (109.400, 18.226), (109.392, 18.222)]),
        Planned("OBSTRN", {"CATOBS": 7, "WATLEV": 3, "OBJNAM": "Synthetic foul ground"},
                [(109.620, 18.150), (109.628, 18.158), (109.636, 18.149)]),
        Planned("RESARE", {"CATREA": [5], "RESTRN": [7], "OBJNAM": "Synthetic reserve, entry prohibited"},
                box(109.664, 109.682, 18.178, 18.194)),
        Planned("RESARE", {"CATREA": [4], "RESTRN": [1, 3],
                           "OBJNAM": "Synthetic reserve, anchoring and fishing prohibited"},
                box(109.615, 109.650, 18.205, 18.222)),
        Planned("RESARE", {"CATREA": [9], "OBJNAM": "Synthetic military area"}, box(109.820, 109.870, 18.300, 18.340)),
        Planned("TSSLPT", {"ORIENT": 270.0, "CATTSS": 2}, box(109.450, 109.620, 18.105, 18.120)),
        Planned("TSEZNE", {"CATTSS": 2}, box(109.450, 109.620, 18.095, 18.105)),
        Planned("TSSLPT", {"ORIENT": 90.0, "CATTSS": 2}, box(109.450, 109.620, 18.080, 18.095)),
        Planned("FAIRWY", {"DRVAL1": 5.0, "ORIENT": 0.0, "TRAFIC": 4, "OBJNAM": "Synthetic fairway"},
                [(109.512, 18.135), (109.514, 18.205), (109.522, 18.205), (109.522, 18.135)]),
        Planned("ACHARE", {"CATACH": [1], "OBJNAM": "Synthetic anchorage"}, box(109.430, 109.460, 18.240, 18.260)),
    ),
    lines=(
        Planned("SLCONS", {"CATSLC": 1, "WATLEV": 2, "OBJNAM": "Synthetic breakwater"},
                [(109.7320, 18.3400), (109.7400, 18.3390), (109.7450, 18.3370)]),
        Planned("BRIDGE", {"CATBRG": [1], "VERCLR": 8.0, "HORCLR": 30.0, "OBJNAM": "Synthetic bridge"},
                [(109.5600, 18.2480), (109.5740, 18.2480)]),
        Planned("CBLOHD", {"CATCBL": 1, "VERCLR": 22.0, "VERCSA": 18.0, "OBJNAM": "Synthetic overhead cable"},
                [(109.6600, 18.2200), (109.6600, 18.2400)]),
    ),
    points=(
        Planned("PILPNT", {"CATPLE": 3, "OBJNAM": "Synthetic pile"}, (109.7470, 18.3360)),
        Planned("BCNLAT", {"BCNSHP": 5, "CATLAM": 1, "COLOUR": [3], "MARSYS": 1}, (109.7460, 18.3375)),
        Planned("BCNCAR", {"BCNSHP": 3, "CATCAM": 3, "COLOUR": [6, 2], "COLPAT": [1], "MARSYS": 1},
                (109.3850, 18.2820)),
        Planned("BOYLAT", {"BOYSHP": 2, "CATLAM": 1, "COLOUR": [3], "MARSYS": 1}, (109.5110, 18.1350)),
        Planned("BOYLAT", {"BOYSHP": 1, "CATLAM": 2, "COLOUR": [4], "MARSYS": 1}, (109.5230, 18.1350)),
        Planned("BOYLAT", {"BOYSHP": 2, "CATLAM": 1, "COLOUR": [3], "MARSYS": 1}, (109.5130, 18.2050)),
        Planned("BOYLAT", {"BOYSHP": 1, "CATLAM": 2, "COLOUR": [4], "MARSYS": 1}, (109.5230, 18.2050)),
        Planned("BOYCAR", {"BOYSHP": 4, "CATCAM": 3, "COLOUR": [6, 2], "COLPAT": [1], "MARSYS": 1},
                (109.3920, 18.2190)),
        Planned("BOYISD", {"BOYSHP": 5, "COLOUR": [2, 3, 2], "COLPAT": [1], "MARSYS": 1}, (109.7900, 18.2000)),
        Planned("WRECKS", {"CATWRK": 2, "WATLEV": 3, "VALSOU": 4.0, "OBJNAM": "Synthetic marked wreck"},
                (109.7905, 18.2000)),
        Planned("BOYSPP", {"BOYSHP": 4, "CATSPM": [19], "COLOUR": [6], "MARSYS": 1}, (109.4500, 18.1000)),
    ),
)

CHART_PLANS = (SHANGCHUAN, SANYA)
