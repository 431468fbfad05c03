"""Compares the cases of a campaign with the published labels: python3 compare.py CASES.csv CELLS.csv."""

import csv
import sys
from pathlib import Path

MODELS = {"CC_human_driver": 1, "Reg157": 2, "RSS": 3, "FSM": 4}
FACTORS = ("ego_speed", "other_speed", "lateral_speed", "gap")
COLUMNS = ("ego_speed_kmh", "cut_in_speed_kmh", "lateral_speed_mps", "gap_m")


def rows(path):
    """Return the rows of a table."""
    with Path(path).open(newline="") as table:
        return list(csv.DictReader(table))


def main(cases, cells):
    """Print the cells that differ, and how many agree."""
    verdicts = {(int(row["model"]), *(float(row[name]) for name in FACTORS)): row["verdict"] for row in rows(cases)}
    labels = {(MODELS[row["model"]], *(float(row[name]) for name in COLUMNS)): row["crash"] for row in rows(cells)}
    expected = {cell: "failed" if crash == "1" else "passed" for cell, crash in labels.items()}
    different = [cell for cell, verdict in expected.items() if verdicts.get(cell) != verdict]
    for model, ego_speed, other_speed, lateral_speed, gap in different:
        name = next(key for key, number in MODELS.items() if number == model)
        print(f"{name}: {ego_speed:g} and {other_speed:g} km/h, {lateral_speed:g} m/s, {gap:g} m: not as published")
    print(f"{len(labels) - len(different)} of {len(labels)} cells agree")


if __name__ == "__main__":
    main(*sys.argv[1:])
