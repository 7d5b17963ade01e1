"""What the folders of a campaign hold."""
import json
from dataclasses import dataclass
from pathlib import Path

from failure import USAGE, Failure


@dataclass(frozen=True)
class Crash:
    pair: int
    planner: str
    how: str
    said: str


@dataclass(frozen=True)
class Campaign:
    """Settings, and of each pair that is done its logs and crashes."""
    manifest: dict
    logs: dict  # of each pair's number: paths
    crashes: list

    @property
    def planners(self):
        return self.manifest["planners"]

    @property
    def is_dive(self):
        """Over a seabed, not on a chart."""
        return "seabed" in self.manifest["arena"]

    @property
    def place(self):
        """Where it was, in words."""
        arena = self.manifest["arena"]
        return f"over the seabed {arena['seabed']}" if self.is_dive else f"on the chart {', '.join(arena['charts'])}"

    @property
    def pairs(self):
        """The numbers of the pairs that are done."""
        return sorted(self.logs)


def read_campaign(folders):
    """Folders of one campaign as one; of a pair that several hold, the first counts."""
    manifests = [read_manifest(Path(folder)) for folder in folders]
    for folder, manifest in zip(folders, manifests):
        if manifest != manifests[0]:
            key = first_difference(manifests[0], manifest)
            raise Failure(USAGE, f"{folders[0]} and {folder} hold the results of different settings: "
                                 f"{key} is {manifests[0].get(key)} in one and {manifest.get(key)} in the other")
    logs, crashes = {}, []
    for folder in map(Path, folders):
        for record in read_records(folder):
            if record["pair"] in logs:
                continue
            logs[record["pair"]] = [folder / name for name in record["logs"]]
            crashes += [Crash(record["pair"], c["planner"], c["how"], c["said"]) for c in record["crashed"]]
    if not any(logs.values()):
        raise Failure(USAGE, f"no job is done yet in {', '.join(map(str, folders))}")
    return Campaign(manifests[0], logs, crashes)


def read_manifest(folder):
    try:
        return json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise Failure(USAGE, f"{folder} is no folder of results: it has no manifest.json that can be read") from error


def read_records(folder):
    """The records of the pairs whose logs are all there."""
    for path in sorted(folder.glob("pair-*.json")):
        record = json.loads(path.read_text(encoding="utf-8"))
        if all((folder / name).is_file() for name in record["logs"]):
            yield record


def first_difference(left, right):
    return next(key for key in [*left, *right] if left.get(key) != right.get(key))
