"""Writes expressions of OpenSCENARIO XML with their values, which Python computes from the trees.

The values do not come from the texts, so that ranks of operators are tested too. Usage:

    python3 random_expressions.py > ../resources/expressions.tsv

Each line has an expression and its value; `none` stands for one that has none.
"""

import math
import random

SEED = 36
COUNT = 1000
DEPTH = 5

PARAMETERS = {"speed": 13.5, "count": 3, "zero": 0, "offset": -2.25, "tiny": 1e-300, "huge": 1e300}
FLAGS = {"day": True, "wet": False}

RANK = {"or": 1, "and": 2, "+": 3, "-": 3, "*": 4, "/": 4, "%": 4}
SIGN, TERM = 5, 6


class NoValueError(Exception):
    """An expression without a value."""


def rounded(value: float) -> float:
    whole = math.floor(abs(value))
    return math.copysign(whole + (1 if abs(value) - whole >= 0.5 else 0), value)


ONE = {
    "abs": abs,
    "sign": lambda value: (value > 0) - (value < 0),
    "sqrt": math.sqrt,
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "asin": math.asin,
    "acos": math.acos,
    "atan": math.atan,
    "round": rounded,
    "floor": math.floor,
    "ceil": math.ceil,
}
TWO = {"min": min, "max": max, "pow": math.pow}
BINARY = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: a / b,
    "%": math.fmod,
}


def finite(compute) -> float:
    try:
        value = float(compute())
    except (ValueError, OverflowError, ZeroDivisionError) as error:
        raise NoValueError from error
    if not math.isfinite(value):
        raise NoValueError
    return value


def number(depth: int, draw: random.Random) -> tuple[str, int, object]:
    """Returns a text, its rank, and what computes its value."""
    kind = draw.random()
    if depth == 0 or kind < 0.15:
        if draw.random() < 0.5:
            name = draw.choice(sorted(PARAMETERS))
            return "$" + name, TERM, lambda: float(PARAMETERS[name])
        text = draw.choice(["0", "1", "2.5", ".5", "10", "3.6", "1e3", "2.1E-7", "pi", "100."])
        return text, TERM, lambda: math.pi if text == "pi" else float(text)
    if kind < 0.65:
        return operation(depth, draw)
    if kind < 0.75:
        text, rank, value = number(depth - 1, draw)
        return "-" + within(text, rank, SIGN, draw), SIGN, lambda: finite(lambda: -value())
    if kind < 0.9:
        name = draw.choice(sorted(ONE))
        text, _, value = number(depth - 1, draw)
        return f"{name}({text})", TERM, lambda: finite(lambda: ONE[name](value()))
    name = draw.choice(sorted(TWO))
    first, _, left = number(depth - 1, draw)
    second, _, right = number(depth - 1, draw)
    return f"{name}({first}, {second})", TERM, lambda: finite(lambda: TWO[name](left(), right()))


def operation(depth: int, draw: random.Random) -> tuple[str, int, object]:
    operator = draw.choice(sorted(BINARY))
    rank = RANK[operator]
    first, first_rank, left = number(depth - 1, draw)
    second, second_rank, right = number(depth - 1, draw)
    space = draw.choice(["", " "])
    text = (
        within(first, first_rank, rank, draw) + space + operator + space + within(second, second_rank, rank + 1, draw)
    )
    return text, rank, lambda: finite(lambda: BINARY[operator](left(), right()))


def truth(depth: int, draw: random.Random) -> tuple[str, int, object]:
    kind = draw.random()
    if depth == 0 or kind < 0.2:
        text = draw.choice(["true", "false", "$day", "$wet"])
        return text, TERM, lambda: FLAGS[text[1:]] if text[0] == "$" else text == "true"
    if kind < 0.4:
        text, rank, value = truth(depth - 1, draw)
        return "not " + within(text, rank, SIGN, draw), SIGN, lambda: not value()
    operator = draw.choice(["and", "or"])
    rank = RANK[operator]
    first, first_rank, left = truth(depth - 1, draw)
    second, second_rank, right = truth(depth - 1, draw)
    first = within(first, first_rank, rank, draw)
    second = within(second, second_rank, rank + 1, draw)
    if operator == "and":
        return f"{first} and {second}", rank, lambda: left() and right()
    return f"{first} or {second}", rank, lambda: left() or right()


def within(text: str, rank: int, least: int, draw: random.Random) -> str:
    """Returns a text in parentheses where they are needed, and sometimes where they are not."""
    return f"({text})" if rank < least or draw.random() < 0.1 else text


def main() -> None:
    draw = random.Random(SEED)
    for index in range(COUNT):
        if index % 5 == 4:
            text, _, value = truth(DEPTH, draw)
            print(text, str(value()).lower(), sep="\t")
            continue
        text, _, value = number(DEPTH, draw)
        try:
            print(text, repr(value()), sep="\t")
        except NoValueError:
            print(text, "none", sep="\t")


if __name__ == "__main__":
    main()
