"""Causes of results of a hand-written file that differ from run to run: clocks, random numbers and threads.

Found in the syntax tree, without running the file. Only what a file names is found: a name that is computed, or a
package of others that reads a clock itself, is left to the comparison of two runs.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import NamedTuple

CLOCK, RANDOM, THREAD = "component.clock", "component.random", "component.thread"
RULES = frozenset({CLOCK, RANDOM, THREAD})

_CLOCKS = frozenset(
    {
        *(f"time.{name}{unit}" for name in ("time", "monotonic", "perf_counter") for unit in ("", "_ns")),
        *(f"time.{name}{unit}" for name in ("process_time", "thread_time", "clock_gettime") for unit in ("", "_ns")),
        *("time.sleep", "datetime.datetime.now", "datetime.datetime.utcnow", "datetime.datetime.today"),
        *("datetime.date.today", "os.times", "asyncio.sleep", "asyncio.timeout", "asyncio.wait_for"),
        *("timeit.default_timer", "timeit.timeit", "timeit.repeat"),
    }
)
_RANDOM = frozenset({"os.urandom", "os.getrandom", "uuid.uuid1", "uuid.uuid4", "uuid.uuid6", "uuid.uuid7"})
_THREADS = frozenset(
    {
        *("threading.Thread", "threading.Timer", "_thread.start_new_thread", "concurrent.futures.ThreadPoolExecutor"),
        *("concurrent.futures.ProcessPoolExecutor", "multiprocessing.Process", "multiprocessing.Pool"),
        *("multiprocessing.pool.ThreadPool", "asyncio.to_thread"),
    }
)
_NOW_WITHOUT = {"time.localtime": 1, "time.gmtime": 1, "time.ctime": 1, "time.asctime": 1, "time.strftime": 2}
"""Functions that show the current time unless they are given this many arguments."""

_GENERATORS = ("random", "numpy.random")
"""Modules whose functions share one random number generator."""

_SEEDED = frozenset(
    {"random.Random", "random.seed"}
    | {
        f"numpy.random.{name}"
        for name in ("MT19937", "PCG64", "PCG64DXSM", "Philox", "RandomState", "SFC64", "SeedSequence", "default_rng")
    }
    | {"numpy.random.seed"}
)
"""Functions that are repeatable with an argument, and random without."""

CLOCK_HINT = "Count the calls of execute(), which come at the node's frequency, or read a time from a message."
RANDOM_HINT = (
    "Give __init__ the parameter random_source=None: a run passes a random.Random seeded by the scenario. "
    "A generator of its own with a constant seed is repeatable, too: random.Random(7)."
)
THREAD_HINT = "Compute the result in execute(), which is called as often as the model says."


class Use(NamedTuple):
    """A use of something that is not the same in every run."""

    rule: str
    node: ast.AST
    message: str
    hint: str


def uses(tree: ast.Module) -> list[Use]:
    """Find the uses in a file, in no particular order."""
    return _Reader(tree).found


class _Reader(ast.NodeVisitor):
    """Visitor of one file."""

    def __init__(self, tree: ast.Module) -> None:
        self.found: list[Use] = []
        self._names: dict[str, str] = {}
        self._own: list[set[str]] = []
        for node in ast.walk(tree):
            if isinstance(node, (ast.Import, ast.ImportFrom)):
                self._names.update(bound(node))
        self._seeded = {name for node in ast.walk(tree) if (name := self._seeds(node))}
        self.visit(tree)

    def _seeds(self, node: ast.AST) -> str | None:
        """Return the module whose shared generator a call seeds."""
        if not isinstance(node, ast.Call) or not _is_given(node, 1):
            return None
        module, _, function = self._dotted(node.func).rpartition(".")
        return module if function == "seed" and module in _GENERATORS else None

    def _dotted(self, node: ast.expr) -> str:
        """Return the full name of what an expression names, of a module or in it; empty for anything else."""
        if isinstance(node, ast.Attribute):
            owner = self._dotted(node.value)
            return f"{owner}.{node.attr}" if owner else ""
        if isinstance(node, ast.Name) and not any(node.id in names for names in self._own):
            return self._names.get(node.id, "")
        return ""

    def visit_If(self, node: ast.If) -> None:
        """Leave out what an import does not run."""
        for part in node.orelse if is_guard(node.test) else [node.test, *node.body, *node.orelse]:
            self.visit(part)

    def visit_FunctionDef(self, node: ast.FunctionDef) -> None:
        self._function(node)

    def visit_AsyncFunctionDef(self, node: ast.AsyncFunctionDef) -> None:
        self._function(node)

    def visit_Lambda(self, node: ast.Lambda) -> None:
        self._function(node)

    def _function(self, node: ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda) -> None:
        """Visit a function; defaults, decorators and annotations belong to the scope around it."""
        body = node.body if isinstance(node.body, list) else [node.body]
        inside = set(map(id, body))
        for child in ast.iter_child_nodes(node):
            if id(child) not in inside:
                self.visit(child)
        self._own.append(_own_names(node, body))
        for part in body:
            self.visit(part)
        self._own.pop()

    def visit_Call(self, node: ast.Call) -> None:
        name = self._dotted(node.func)
        if name in _NOW_WITHOUT and not _is_given(node, _NOW_WITHOUT[name]):
            self._clock(node.func, name)
        elif name in _SEEDED and not _is_given(node, 1):
            self._random(node.func, name, "without a seed")
        elif name == "numpy.datetime64" and node.args and _constant(node.args[0]) in ("now", "today"):
            self._clock(node.func, name)
        self.generic_visit(node)

    def visit_Name(self, node: ast.Name) -> None:
        self._name(node, self._dotted(node))

    def visit_Attribute(self, node: ast.Attribute) -> None:
        name = self._dotted(node)
        self._name(node, name)
        if not name:
            self.visit(node.value)

    def visit_ImportFrom(self, node: ast.ImportFrom) -> None:
        """A star takes every name of a module, and hides which of them are used."""
        if node.module in ("time", "random", "secrets", "numpy.random") and node.names[0].name == "*":
            if node.module == "time":
                self._clock(node, "time.*")
            else:
                self._random(node, f"{node.module}.*", "")

    def _name(self, node: ast.expr, name: str) -> None:
        module, _, last = name.rpartition(".")
        if name in _CLOCKS:
            self._clock(node, name)
        elif name in _THREADS:
            message = f"'{name}' runs at times of its own, which are others in every run."
            self.found.append(Use(THREAD, node, message, THREAD_HINT))
        elif name in _RANDOM or module == "secrets":
            self._random(node, name, "")
        elif module in _GENERATORS and last.islower() and name not in _SEEDED and module not in self._seeded:
            self._random(node, name, "without a seed")
        elif name == "random.SystemRandom":
            self._random(node, name, "")

    def _clock(self, node: ast.AST, name: str) -> None:
        message = f"'{name}' follows the clock of the computer, which has nothing to do with simulated time."
        self.found.append(Use(CLOCK, node, message, CLOCK_HINT))

    def _random(self, node: ast.AST, name: str, how: str) -> None:
        what = f"'{name}' {how}".strip()
        self.found.append(Use(RANDOM, node, f"{what} is something else in every run.", RANDOM_HINT))


def is_guard(test: ast.expr) -> bool:
    """Return whether it is `if TYPE_CHECKING:` or `if __name__ == "__main__":`, whose body an import does not run."""
    if isinstance(test, ast.Compare):
        return isinstance(test.left, ast.Name) and test.left.id == "__name__" and isinstance(test.ops[0], ast.Eq)
    return isinstance(test, ast.Name) and test.id == "TYPE_CHECKING"


def bound(node: ast.Import | ast.ImportFrom) -> Iterator[tuple[str, str]]:
    """Return the names that an import binds, with the full names of what they stand for."""
    for alias in node.names:
        if isinstance(node, ast.Import):
            yield (alias.asname, alias.name) if alias.asname else (alias.name.partition(".")[0],) * 2
        elif node.module and not node.level:
            yield alias.asname or alias.name, f"{node.module}.{alias.name}"


def _own_names(
    node: ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda, body: list[ast.stmt] | list[ast.expr]
) -> set[str]:
    """Return the names that belong to a function: its parameters, and what it assigns."""
    own = {argument.arg for argument in ast.walk(node.args) if isinstance(argument, ast.arg)}
    outer: set[str] = set()
    pending: list[ast.AST] = list(body)
    while pending:
        part = pending.pop()
        if isinstance(part, ast.Global):
            outer.update(part.names)
        elif isinstance(part, ast.Name) and isinstance(part.ctx, ast.Store):
            own.add(part.id)
        elif not isinstance(part, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Lambda)):
            pending += ast.iter_child_nodes(part)
    return own - outer


def _is_given(call: ast.Call, count: int) -> bool:
    """Return whether a call has so many arguments, none of them None; unknown numbers of arguments count."""
    given = [*call.args, *(keyword.value for keyword in call.keywords)]
    if any(isinstance(each, ast.Starred) for each in call.args) or any(each.arg is None for each in call.keywords):
        return True
    return len(given) >= count and not (isinstance(given[0], ast.Constant) and given[0].value is None)


def _constant(node: ast.expr) -> object:
    return node.value if isinstance(node, ast.Constant) else None
