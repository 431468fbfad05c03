"""The distributions of `second_author.py`: a file for each kind."""

import datetime
from pathlib import Path

from scenariogeneration import xosc


def deterministic() -> xosc.Deterministic:
    made = xosc.Deterministic()
    speeds = xosc.DistributionRange(0.1, xosc.Range(0.1, 0.5))
    made.add_single_distribution("speed", speeds)
    modes = xosc.DistributionSet()
    modes.add_value("calm")
    modes.add_value("wild")
    made.add_single_distribution("mode", modes)
    return made


def pairs() -> xosc.Deterministic:
    made = xosc.Deterministic()
    several = xosc.DeterministicMultiParameterDistribution()
    for speed, mode in ((10, "calm"), (20, "wild"), (30, "wild")):
        values = xosc.ParameterValueSet()
        values.add_parameter("speed", str(speed))
        values.add_parameter("mode", mode)
        several.add_value_set(values)
    made.add_multi_distribution(several)
    return made


def stochastic(speeds) -> xosc.Stochastic:
    made = xosc.Stochastic(200, 7)
    made.add_distribution("speed", speeds)
    modes = xosc.ProbabilityDistributionSet()
    modes.add_set("calm", 3)
    modes.add_set("wild", 1)
    made.add_distribution("mode", modes)
    return made


def histogram() -> xosc.Histogram:
    made = xosc.Histogram()
    made.add_bin(1, xosc.Range(10, 20))
    made.add_bin(3, xosc.Range(20, 30))
    return made


def distributions(folder: Path, minor: int, date: datetime.datetime) -> None:
    """Write a file for each kind of distribution that a minor version has."""
    made = {
        "steps": deterministic(),
        "pairs": pairs(),
        "normal": stochastic(xosc.NormalDistribution(30, 4, xosc.Range(28, 33))),
        "uniform": stochastic(xosc.UniformDistribution(xosc.Range(10, 20))),
        "poisson": stochastic(xosc.PoissonDistribution(20)),
        "histogram": stochastic(histogram()),
    }
    if minor > 2:
        made["log-normal"] = stochastic(xosc.LogNormalDistribution(30, 4))
    for name, distribution in made.items():
        file = xosc.ParameterValueDistribution(name, "Eventchain", "everything.xosc", distribution, minor)
        file.header.creation_date = date
        file.write_xml(str(folder / f"{name}.xosc"))
