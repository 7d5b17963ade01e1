"""What is printed: text for people, one JSON object for machines."""
import json
from dataclasses import asdict

from runs import starved
from summary import json_row, text_table


def json_report(campaign, runs, rows, files):
    return json.dumps({"status": "success", "exit": 0, "settings": campaign.manifest, "pairs_done": campaign.pairs,
                       "planners": [json_row(row, campaign.is_dive) for row in rows],
                       "starved_runs": len(starved(runs)),
                       "crashes": [asdict(crash) for crash in campaign.crashes], "files": files}, indent=2)


def text_report(campaign, runs, rows):
    lines = [text_table(rows, campaign.is_dive),
             "lengths in % above the best known of each pair; all are medians over runs and pairs"]
    lines += [f"UNSAFE: {row.unsafe} dive(s) of {row.planner} did not keep the limits" for row in rows if row.unsafe]
    lines += [f"crashed: {c.planner} on pair {c.pair}: {c.how} {c.said}".rstrip() for c in campaign.crashes]
    lines += [f"not valid: {row.invalid} path(s) of {row.planner}" for row in rows if row.invalid]
    if starved(runs):
        lines.append(f"{len(starved(runs))} of {len(runs)} runs had less than 90 % of a core; their times are too long")
    if len(campaign.pairs) < campaign.manifest["pairs"]:
        lines.append(f"{len(campaign.pairs)} of {campaign.manifest['pairs']} pairs are done")
    return "\n".join(lines)
