"""The page: one HTML file that needs nothing else."""
import base64
import html
import io

from runs import starved
from summary import cells, display_name, headings

STYLE = """
body { font: 15px/1.5 sans-serif; color: #222; max-width: 75rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin-top: 2.2rem; }
table { border-collapse: collapse; margin: 0.8rem 0; }
th, td { padding: 0.2rem 0.7rem; text-align: right; border-bottom: 1px solid #ddd; font-variant-numeric: tabular-nums; }
th { border-bottom: 2px solid #888; font-weight: 600; } th:first-child, td:first-child { text-align: left; }
.scroll { overflow-x: auto; } figure { margin: 1.5rem 0; } figure img { max-width: 100%; height: auto; }
figcaption, .small { color: #555; font-size: 0.9rem; max-width: 60rem; }
"""

ON_CHARTS = {
    "planners": "OMPL's with their defaults; FMT-N has N samples, +simplify runs the path simplifier on the clock; "
                "HexAStar as it comes, HexAStar-N the lattice's best path of N rings with nothing after it.",
    "solved": "exact solution whose every leg was checked once more against the cells; anything else counts as "
              "unsolved, and as infinite in medians and quartiles.",
    "turns, angle": "changes of heading above a millionth of a radian, and their sum.",
    "clear": "least distance from the whole line to the geometry of a blocking hazard, the vicinity of start and "
             "goal included.",
}
UNDER_WATER = {
    "planners": "all with their defaults; +simplify runs the path simplifier on the clock; LayeredPlanner and "
                "AntColony on 25 x 25 x 25 points; BIT* without pruning; PrismAStar-climb climbs no "
                "steeper than a fifth of its way over ground, which the others may.",
    "solved": "exact solution that keeps the limits; anything else counts as unsolved, and as infinite in medians and "
              "quartiles.",
    "unsafe": "dives that did not keep clearance, ceiling or coverage when they were looked at once more, by other "
              "code, at a tenth of the seabed's cells.",
    "turns, angle": "changes of direction above a millionth of a radian, up and down included, and their sum.",
    "clear": "least water between the dive and the seabed straight below, the vicinity of start and goal included.",
}


EVERYWHERE = {
    "first": "wall time inside the planner's solve() until its first path, median.",
    "over best": "length of the path that the run ended with, in percent above the shortest valid path that any run "
                 "of any planner found for the same pair. The true optimum may be shorter still.",
    "to 5, 1, 0 %": "median time until the best path so far was within so much of the best known; \"never\" if half "
                    "of the runs did not get there.",
}
ORDER = ("planners", "solved", "unsafe", "first", "over best", "turns, angle", "clear", "to 5, 1, 0 %")


def definitions(is_dive):
    """The table's words, explained."""
    words = {**EVERYWHERE, **(UNDER_WATER if is_dive else ON_CHARTS)}
    return [(word, words[word]) for word in ORDER if word in words]


def table(headings, rows):
    head = "".join(f"<th>{html.escape(text)}</th>" for text in headings)
    body = "".join("<tr>" + "".join(f"<td>{html.escape(str(text))}</td>" for text in row) + "</tr>\n" for row in rows)
    return f'<div class="scroll"><table>\n<tr>{head}</tr>\n{body}</table></div>\n'


def chart_rows(campaign):
    arena = campaign.manifest["arena"]
    return [
        ("chart", ", ".join(arena["charts"])),
        ("vessel", f"draught {arena['draught_m']:g} m, {arena['ukc_m']:g} m under the keel, margin "
                   f"{arena['margin_m']:g} m"),
        ("cells", f"{arena['columns']} x {arena['rows']}, {arena['pitch_m']:g} m wide, {arena['blocked']} blocked"),
        ("space", "R^2, path length, exact validity of states and motions, the same for all"),
        ("pairs", f"{len(campaign.pairs)} of {campaign.manifest['pairs']} done, at least "
                  f"{campaign.manifest['least_distance']:g} of the chart's diagonal apart, the straight line between "
                  "them blocked"),
    ]


def seabed_rows(campaign):
    arena = campaign.manifest["arena"]
    blocked = sum(pair["seabed_in_the_way"] for pair in campaign.manifest["pair_list"])
    deepest = "" if arena["deepest_m"] is None else f", no deeper than {arena['deepest_m']:g} m"
    return [
        ("seabed", arena["seabed"]),
        ("nodes", f"{arena['columns']} x {arena['rows']}, {arena['spacing_m'][0]:.4g} m by "
                  f"{arena['spacing_m'][1]:.4g} m apart, down to {arena['greatest_depth_m']:.0f} m"),
        ("vehicle", f"{arena['clearance_m']:g} m above the seabed, {arena['ceiling_m']:g} m below the surface"
                    f"{deepest}"),
        ("space", "R^3, path length, exact validity of states and motions, the same for all"),
        ("pairs", f"{len(campaign.pairs)} of {campaign.manifest['pairs']} done, at least "
                  f"{campaign.manifest['least_distance']:g} of the seabed's diagonal apart, at random depths; the "
                  f"seabed is in the way of the straight line of {blocked}"),
    ]


def settings_rows(campaign, runs):
    m = campaign.manifest
    return [
        *(seabed_rows(campaign) if campaign.is_dive else chart_rows(campaign)),
        ("runs", f"{m['runs']} of every planner on every pair, {m['time_s']:g} s each, one core"),
        ("starved", f"{len(starved(runs))} of {len(runs)} runs had less than 90 % of a core"),
        ("seed", m["seed"]),
        ("OMPL", m["ompl"]),
    ]


def place_text(place):
    """Latitude, longitude, and the depth of one in the water."""
    depth = f", {place[2]:.0f} m" if len(place) > 2 else ""
    return f"{place[0]:.5f}, {place[1]:.5f}{depth}"


def pair_rows(campaign, runs):
    best = {run.pair: run.best_known for run in runs}
    holders = {}
    for run in runs:
        if run.solved and run.excess_percent <= 1e-4:
            holders.setdefault(run.pair, set()).add(run.planner)
    for pair in campaign.manifest["pair_list"]:
        number = pair["number"]
        if number not in campaign.logs:
            continue
        names = [display_name(p) for p in campaign.planners if p in holders.get(number, ())]
        start, goal = (place_text(pair[end]) for end in ("start", "goal"))
        yield (number, start, goal, f"{pair['course_deg']:03.0f}", f"{pair['distance_m'] / 1000:.2f}",
               f"{best[number] / 1000:.3f}", ", ".join(names))


def image(figure):
    """The figure as an SVG within the page; text is drawn as shapes, so that no font is needed."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="svg", metadata={"Date": None, "Creator": None})
    return "data:image/svg+xml;base64," + base64.b64encode(buffer.getvalue()).decode("ascii")


def crash_text(campaign):
    if not campaign.crashes:
        return ""
    rows = [(c.pair, display_name(c.planner), c.how, c.said) for c in campaign.crashes]
    return "<h2>Crashes</h2>\n<p>Their runs count as unsolved.</p>\n" + table(("pair", "planner", "how", "said"), rows)


def make_page(campaign, runs, rows, figures):
    title = html.escape(f"Planners {campaign.place}")
    unsafe = sum(row.unsafe for row in rows)
    invalid = sum(row.invalid for row in rows)
    parts = [
        f"<h1>{title}</h1>\n",
        f"<p><b>UNSAFE: {unsafe} dive(s) did not keep the limits.</b></p>\n" if unsafe else "",
        "<h2>Results</h2>\n", table(headings(campaign.is_dive), (cells(row, campaign.is_dive) for row in rows)),
        '<ul class="small">\n', *(f"<li><b>{html.escape(word)}</b>: {html.escape(text)}</li>\n"
                                  for word, text in definitions(campaign.is_dive)), "</ul>\n",
        f"<p>{invalid} path(s) were not valid and count as unsolved.</p>\n" if invalid else "",
        crash_text(campaign)]
    for _, caption, figure in figures:
        parts.append(f'<figure><img alt="{html.escape(caption)}" src="{image(figure)}">'
                     f"<figcaption>{html.escape(caption)}</figcaption></figure>\n")
    parts += ["<h2>Settings</h2>\n", table(("what", "value"), settings_rows(campaign, runs)),
              "<h2>Pairs</h2>\n", table(("pair", "start", "goal", "course", "straight km", "best known km", "found by"),
                                        pair_rows(campaign, runs)),
              '<p class="small">Not for navigation.</p>\n']
    return ('<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
            f"<title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n"
            + "".join(parts) + "</body>\n</html>\n")
