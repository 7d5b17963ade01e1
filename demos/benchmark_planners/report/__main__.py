"""Makes database, table, plots and page of a benchmark's logs: python3 report --out FOLDER FOLDER...

Usually benchmark_planners runs it. Exit codes: 0 done; 2 the folders hold no results, or of different settings; 7 a
package is missing (one sentence says which).
"""
import argparse
import sys
from pathlib import Path

from campaign import read_campaign
from database import make_database
from failure import REPORT, Failure
from reports import json_report, text_report
from runs import read_runs
from summary import summarise


def load_plots():
    """The module of the plots; it needs matplotlib, and the table does not."""
    try:
        import plots  # pylint: disable=import-outside-toplevel
        return plots
    except ImportError as error:
        raise Failure(REPORT, "python3-matplotlib is missing, so there is no page: install the Debian package; "
                              "database and logs stay, and --merge makes the page later") from error


def write_figures_and_page(campaign, runs, rows, out):
    """Returns the names of the files."""
    from page import make_page  # pylint: disable=import-outside-toplevel
    figures = load_plots().make_figures(runs, campaign.planners, campaign.manifest["time_s"])
    for name, _, figure in figures:
        figure.savefig(out / f"{name}.png", dpi=110)
    page = out / "index.html"
    part = out / "index.html.part"
    part.write_text(make_page(campaign, runs, rows, figures), encoding="utf-8")
    part.replace(page)
    return ["index.html", *(f"{name}.png" for name, _, _ in figures)]


def make_report(folders, out, as_json):
    out.mkdir(parents=True, exist_ok=True)
    campaign = read_campaign(folders)
    make_database(campaign, out / "benchmark.db")
    runs = read_runs(out / "benchmark.db", campaign)
    rows = [summarise(planner, runs) for planner in campaign.planners]
    if not as_json:
        print(text_report(campaign, runs, rows), flush=True)  # it needs no matplotlib, so it comes before what does
    files = ["benchmark.db", *write_figures_and_page(campaign, runs, rows, out)]
    print(json_report(campaign, runs, rows, files) if as_json else f"wrote {', '.join(files)} in {out}")


def main():
    parser = argparse.ArgumentParser(description="Makes database, table, plots and page of a benchmark's logs.")
    parser.add_argument("folders", nargs="+", help="folders of one campaign's results")
    parser.add_argument("--out", required=True, type=Path, help="where to write")
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    arguments = parser.parse_args()
    try:
        make_report(arguments.folders, arguments.out, arguments.json)
    except Failure as failure:
        print(failure, file=sys.stderr)
        sys.exit(failure.code)


if __name__ == "__main__":
    main()
