"""Components of nodes: each runs in its own process, and its node gets a stub.

No code of a component is imported into this process, which contains the records of the scenario.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import Any, NamedTuple

import component_results
from component_client import ComponentError, ComponentProcess, ForkServer, Limits, Result
from component_results import Output
from component_rules import Component, check_file
from component_values import Objects

from eventchain_ros2.value_latency import Answer, Call, Record, measure


class Configuration(NamedTuple):
    """Configuration of a component.

    Args:
        module: the module from which its node imports it.
        class_name: the imported class.
        file: the file of that module.
        inputs: names of the arguments of `execute`; None: not known.
        outputs: names of its results; None: not known.
        restricted: whether the rules of generated components apply to it.
        seed: the seed of its random numbers, of the scenario and its name.
        path: folders with modules that it imports instead of those beside it.

    """

    module: str
    class_name: str
    file: str
    inputs: list[str] | None
    outputs: list[Output] | None
    restricted: bool
    seed: str = ""
    path: tuple[str, ...] = ()

    @classmethod
    def of(cls, json: dict[str, Any]) -> Configuration:
        """Read the entry `component` of a node in the configuration."""
        outputs = json.get("outputs")
        return cls(
            json["module"],
            json["class"],
            json["file"],
            json.get("inputs"),
            None if outputs is None else [Output(output["name"], output.get("type", "")) for output in outputs],
            bool(json.get("restricted", False)),
            str(json.get("seed", "")),
            tuple(json.get("path", ())),
        )


class Environment(NamedTuple):
    """Needs of the processes of components: folders for `sys.path`, files of message definitions, and the limits."""

    path: list[str]
    sources: list[str]
    messages: list[str]
    limits: Limits
    objects: Objects


class Components(MetaPathFinder, Loader):
    """Components of a scenario.

    Args:
        configurations: configurations of all components.
        environment: environment of their processes.
        spend: receives the processor time of each call, in ns.
        clock: returns the time at which calls are recorded, in ns; None: they are not.

    """

    def __init__(
        self,
        configurations: list[Configuration],
        environment: Environment,
        spend: Callable[[int], None],
        clock: Callable[[], int] | None = None,
    ) -> None:
        self._configurations = {configuration.module: configuration for configuration in configurations}
        self._environment = environment
        self._spend = spend
        self._clock = clock
        self._records = {module: Record() for module in self._configurations}
        self._processes: list[ComponentProcess] = []

    def install(self) -> None:
        """Serve the imports of nodes, before all other finders."""
        sys.meta_path.insert(0, self)

    def end(self) -> None:
        """End the processes and stop serving imports."""
        if self in sys.meta_path:
            sys.meta_path.remove(self)
        for process in self._processes:
            process.close()
        for module in self._configurations:
            sys.modules.pop(module, None)

    def find_spec(self, fullname: str, path: object, target: object = None) -> ModuleSpec | None:
        """Find the modules of components."""
        return ModuleSpec(fullname, self) if fullname in self._configurations else None

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        """Create a module with the stub's class."""
        configuration = self._configurations[spec.name]
        module = ModuleType(spec.name)
        stand_in = type(configuration.class_name, (_StandIn,), {"_start": staticmethod(self._starter(configuration))})
        setattr(module, configuration.class_name, stand_in)
        return module

    def exec_module(self, module: ModuleType) -> None:
        """Do nothing: the component's code runs elsewhere."""

    def _starter(self, configuration: Configuration) -> Callable[[], Callable[..., Any]]:
        def start() -> Callable[..., Any]:
            if configuration.restricted:
                _check_rules(configuration)
            process = self._start(configuration)

            def execute(*arguments: Any, **inputs: Any) -> Any:
                result = _call(configuration, process, arguments, inputs)
                self._spend(result.processor)
                if configuration.outputs is not None:
                    for problem in component_results.check(result.values, configuration.outputs):
                        place = configuration.file, result.line, result.column
                        raise ComponentError(problem.rule, f"execute() {problem.message}", *place, hint=problem.hint)
                if self._clock is not None:
                    named = {**dict(zip(configuration.inputs or (), arguments, strict=False)), **inputs}
                    self._records[configuration.module].add(Call(self._clock(), named, result.values))
                return result.values

            return execute

        return start

    def answers(self, module: str) -> list[Answer]:
        """Replay the recorded calls of a component; return which of its outputs answered which inputs."""
        configuration = self._configurations[module]
        return measure(self._records[module].calls, lambda: self._start(configuration))

    def _start(self, configuration: Configuration) -> ComponentProcess:
        environment = self._environment
        description = {
            "file": configuration.file,
            "module": configuration.module,
            "class": configuration.class_name,
            "path": [*environment.path, *configuration.path],
            "sources": environment.sources,
            "messages": environment.messages,
            "seed": configuration.seed,
        }
        server = ForkServer.inherited()
        process = ComponentProcess(server, description, environment.limits, environment.objects)
        self._processes.append(process)
        process.load()
        process.make()
        return process


class _StandIn:
    """Stub of a component in its node: it can only be created and executed."""

    _start: Callable[[], Callable[..., Any]]

    def __init__(self) -> None:
        self.execute = self._start()


def _call(
    configuration: Configuration, process: ComponentProcess, arguments: tuple[Any, ...], inputs: dict[str, Any]
) -> Result:
    try:
        return process.call(arguments, inputs)
    except ComponentError as error:
        if error.identifier == "component.result.type" and not error.hint and configuration.outputs is not None:
            error.hint = component_results.keys_hint(configuration.outputs)
        raise


def _check_rules(configuration: Configuration) -> None:
    """Check a generated component against the rules, since it may have been edited."""
    names = [output.name for output in configuration.outputs or ()]
    component = Component(configuration.class_name, configuration.inputs or [], names)
    for finding in check_file(configuration.file, component):
        place = configuration.file, finding.line, finding.column
        raise ComponentError(finding.id, finding.message, *place, hint=finding.hint)
