"""Colours and lines of the planners: a colour a family, from the palette of Okabe and Ito, which colour-blind people
can tell apart, and a line style a member, which needs no colour at all."""
from dataclasses import dataclass

FAMILIES = (  # a part of the name, the colour; the first that fits
    ("HexAStar", "#0072b2"),
    ("Layered", "#0072b2"),
    ("AntColony", "#e69f00"),
    ("AStar", "#56b4e9"),
    ("RRTConnect", "#000000"),
    ("RRT", "#d55e00"),
    ("PRM", "#009e73"),
    ("FMT", "#e69f00"),
    ("ITstar", "#cc79a7"),
)
OTHERS = "#777777"
DASHES = ("-", (0, (5, 1.5)), (0, (1, 1.2)), (0, (5, 1.5, 1, 1.5)), (0, (8, 2, 1, 2, 1, 2)))


@dataclass(frozen=True)
class Look:
    colour: str
    dashes: object
    width: float


def family_of(planner):
    return next((colour for part, colour in FAMILIES if part in planner), OTHERS)


def looks(planners):
    """Of each planner; the first of each family has the solid line."""
    seen, found = {}, {}
    for planner in planners:
        colour = family_of(planner)
        member = seen.get(colour, 0)
        seen[colour] = member + 1
        found[planner] = Look(colour, DASHES[member % len(DASHES)], 2.2 if member == 0 else 1.6)
    return found
