"""Quality of service as rclpy's endpoints are given it."""

from __future__ import annotations

import ast

from constants import Constants, Place, UnknownValueError
from ros_parameters import parameter_of
from source_modules import Module

QoS = dict[str, object]

_PRESETS = {
    "qos_profile_sensor_data": "sensor_data",
    "qos_profile_system_default": "system_default",
    "qos_profile_services_default": "services_default",
    "qos_profile_parameters": "parameters",
    "qos_profile_parameter_events": "parameter_events",
    "qos_profile_action_status_default": "action_status_default",
    "qos_profile_best_available": "best_available",
}
_ENUMS = {
    "ReliabilityPolicy": "reliability",
    "DurabilityPolicy": "durability",
    "HistoryPolicy": "history",
    "LivelinessPolicy": "liveliness",
}
_POLICIES = frozenset(_ENUMS.values())
_TIMES = {"deadline": "deadline", "liveliness_lease_duration": "lease_duration"}
_UNIT_NS = {"seconds": 1_000_000_000, "nanoseconds": 1}


class QualityOfService:
    """Reads quality of service: a depth, a profile of ROS 2, or a profile made of constants."""

    def __init__(self, constants: Constants) -> None:
        self._constants = constants

    def read(self, node: ast.expr, place: Place) -> QoS:
        """Return the policies that are set, and the ``profile`` that they change.

        Raises:
            UnknownValueError: the source does not say.

        """
        full = place.module.full_name(node) or ""
        last = full.rpartition(".")[2]
        if full.startswith("rclpy.") and last in _PRESETS:
            return {"profile": _PRESETS[last]}
        preset = _preset(node, place.module)
        if preset is not None:
            return {"profile": preset}
        if isinstance(node, ast.Call) and parameter_of(node) is None:
            return self._profile(node, place)
        if isinstance(node, (ast.Name, ast.Attribute)):
            _refuse_changed(node, place)
            inner, there = self._constants.definition(node, place)
            return self.read(inner, there)
        depth = self._constants.value(node, place)
        if isinstance(depth, bool) or not isinstance(depth, int) or depth < 0:
            raise UnknownValueError(f"it is {depth!r}, which is no depth")
        return {"depth": depth}

    def _profile(self, node: ast.Call, place: Place) -> QoS:
        full = place.module.full_name(node.func) or ""
        if not full.startswith("rclpy.") or not full.endswith(".QoSProfile") or node.args:
            raise UnknownValueError(f"it is '{ast.unparse(node)[:60]}'")
        found: QoS = {}
        for keyword in node.keywords:
            name = keyword.arg or ""
            if name == "depth":
                found["depth"] = int(self._constants.number(keyword.value, place))
            elif name in _POLICIES:
                found[name] = self._policy(name, keyword.value, place)
            elif name in _TIMES:
                found[_TIMES[name]] = self._milliseconds(keyword.value, place)
            elif name not in ("avoid_ros_namespace_conventions", "lifespan"):
                raise UnknownValueError(f"it has '{ast.unparse(keyword)[:60]}'")
        return found

    def _policy(self, name: str, node: ast.expr, place: Place) -> str:
        if isinstance(node, ast.Name) and place.module.full_name(node) is None:
            inner, there = self._constants.definition(node, place)
            return self._policy(name, inner, there)
        parts = (place.module.full_name(node) or "").split(".")
        enum = parts[-2].removeprefix("QoS") if len(parts) > 2 and parts[0] == "rclpy" else ""
        if _ENUMS.get(enum) != name:
            raise UnknownValueError(f"its {name} is '{ast.unparse(node)[:60]}'")
        return parts[-1].upper().removeprefix(f"RMW_QOS_POLICY_{name.upper()}_")

    def _milliseconds(self, node: ast.expr, place: Place) -> float:
        full = place.module.full_name(node.func) if isinstance(node, ast.Call) else None
        if not isinstance(node, ast.Call) or not (full or "").endswith("duration.Duration") or node.args:
            raise UnknownValueError(f"it has the time '{ast.unparse(node)[:60]}'")
        total = 0.0
        for keyword in node.keywords:
            if keyword.arg not in _UNIT_NS:
                raise UnknownValueError(f"it has the time '{ast.unparse(node)[:60]}'")
            total += self._constants.number(keyword.value, place) * _UNIT_NS[keyword.arg]
        return total / 1e6


def _preset(node: ast.expr, module: Module) -> str | None:
    """Return the preset of ``QoSPresetProfiles.SENSOR_DATA.value``."""
    inner = node.value if isinstance(node, ast.Attribute) and node.attr == "value" else node
    parts = (module.full_name(inner) or "").split(".")
    if len(parts) > 2 and parts[0] == "rclpy" and parts[-2] == "QoSPresetProfiles":
        return parts[-1].lower()
    return None


def _refuse_changed(node: ast.expr, place: Place) -> None:
    """Refuse a profile one of whose policies is assigned after it is made."""
    wanted = ast.dump(node)
    for each in ast.walk(place.module.tree):
        if isinstance(each, ast.Attribute) and isinstance(each.ctx, ast.Store) and ast.dump(each.value) == wanted:
            raise UnknownValueError(f"'{ast.unparse(each)}' is changed in line {each.lineno}")
