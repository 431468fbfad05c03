"""Write random formulas with the robustness that rtamt computes: `random_formulas.py FILE`.

Each line is a JSON array: the formula in Eventchain's syntax, a value of `ego.speed` for each sample, and the
robustness at the first sample. Recorded with rtamt 0.4.10 (BSD-3-Clause), whose ANTLR runtime does not install on
every Python that Eventchain supports, so that the results are kept and not computed in each build.

Cases in which the two disagree by design are left out: rtamt counts a `rise` at the first sample, and judges samples
beyond the end of a run.
"""

from __future__ import annotations

import json
import random
import sys
from pathlib import Path

import rtamt

CASES = 600
SAMPLES = 40
LATEST = 6
DEPTH = 3

chance = random.Random(20261122)


def comparison() -> tuple[str, str]:
    """Return a comparison in the syntax of Eventchain and of rtamt."""
    operator, limit = chance.choice(["<", "<=", ">", ">="]), chance.randrange(5)
    return f"(ego.speed {operator} {limit} m/s)", f"(speed {operator} {limit})"


def interval() -> tuple[str, str, int]:
    """Return an interval and its first sample."""
    start = chance.randrange(LATEST)
    end = start + chance.randrange(LATEST)
    return f"[{start / 100:.2f}, {end / 100:.2f}]", f"[{start}:{end}]", start


def formula(depth: int, earliest: int) -> tuple[str, str]:
    """Return a formula that is evaluated at samples from `earliest` on."""
    if depth == 0:
        return comparison()
    kind = chance.randrange(8)
    if kind == 0:
        ours, theirs = formula(depth - 1, earliest)
        return f"(not {ours})", f"(not {theirs})"
    if kind == 1 and earliest > 0:
        edge = chance.choice(["rise", "fall"])
        ours, theirs = formula(depth - 1, earliest - 1)
        return f"{edge}({ours})", f"{edge}({theirs})"
    if kind in (2, 3):
        operator = "always" if kind == 2 else "eventually"
        if depth == 1 and chance.randrange(4) == 0:
            ours, theirs = comparison()
            return f"({operator} {ours})", f"({operator} {theirs})"
        window, their_window, start = interval()
        ours, theirs = formula(depth - 1, earliest + start)
        return f"({operator}{window} {ours})", f"({operator}{their_window} {theirs})"
    first, their_first = formula(depth - 1, earliest)
    if kind == 4:
        window, their_window, start = interval()
        second, their_second = formula(depth - 1, earliest + start)
        return f"({first} until{window} {second})", f"({their_first} until{their_window} {their_second})"
    operator = chance.choice(["and", "or", "implies"])
    second, their_second = formula(chance.randrange(depth), earliest)
    return f"({first} {operator} {second})", f"({their_first} {operator} {their_second})"


def robustness(text: str, values: list[int]) -> float:
    """Return the robustness of a formula at the first sample by rtamt."""
    specification = rtamt.StlDiscreteTimeOfflineSpecification()
    specification.declare_var("speed", "float")
    specification.spec = text
    specification.parse()
    return specification.evaluate({"time": list(range(SAMPLES)), "speed": values})[0][1]


def main(file: Path) -> None:
    """Write the cases."""
    lines = []
    for _ in range(CASES):
        ours, theirs = formula(DEPTH, 0)
        values = [chance.randrange(6) for _ in range(SAMPLES)]
        lines.append(json.dumps([ours, values, robustness(theirs, values)], separators=(",", ":")))
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")


main(Path(sys.argv[1]))
