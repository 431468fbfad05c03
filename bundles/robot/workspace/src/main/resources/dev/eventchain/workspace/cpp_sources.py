"""Nodes of rclcpp, by the tokens of their sources alone: literal topics, types and quality of service.

Macros, templates, base classes and names of other files are not followed, so what is found may not be all.
"""

from __future__ import annotations

import itertools
import re

from source_modules import Question

Json = dict[str, object]

_COMMENT = re.compile(r'"(?:\\.|[^"\\\n])*"|//[^\n]*|/\*.*?\*/', re.DOTALL)
_MAKER = re.compile(r"\bcreate_(publisher|subscription)\s*<\s*([\w:]+)\s*>\s*\(")
_ANY_MAKER = re.compile(r"\bcreate_(?:publisher|subscription|client|service|wall_timer|timer)\s*[<(]")
_CLASS = re.compile(r"\bclass\s+(\w+)[^;{:]{0,80}:[^;{]{0,200}?\b(?:rclcpp|rclcpp_lifecycle)::(?:Lifecycle)?Node\b")
_NAME = re.compile(r'\b(?:Node|LifecycleNode)\s*(?:>\s*|::\s*make_shared\s*)?\(\s*"([\w]+)"')
_TYPE = re.compile(r"(?:::)?([a-z]\w*)::msg::([A-Z]\w*)$")
_TEXT = re.compile(r'"((?:[^"\\]|\\.)*)"$')
_QOS = re.compile(
    r"(?:rclcpp::)?(QoS\s*\(\s*(\d+)\s*\)|SensorDataQoS\s*\(\s*\)|SystemDefaultsQoS\s*\(\s*\))(.*)$", re.DOTALL
)
_CHANGES = re.compile(r"\s*\.\s*(reliable|best_effort|transient_local|durability_volatile|keep_all)\s*\(\s*\)")
_POLICIES = {
    "reliable": ("reliability", "RELIABLE"),
    "best_effort": ("reliability", "BEST_EFFORT"),
    "transient_local": ("durability", "TRANSIENT_LOCAL"),
    "durability_volatile": ("durability", "VOLATILE"),
    "keep_all": ("history", "KEEP_ALL"),
}
_REGISTERED = re.compile(r"\bRCLCPP_COMPONENTS_REGISTER_NODE\s*\(\s*([\w:]+)\s*\)")
_OF_PLUGIN = re.compile(r"\brclcpp_components_register_node\s*\(([^)]{0,5000})\)")
_EXECUTABLE = re.compile(r"\badd_executable\s*\(\s*(\w+)\s+([^)]{0,5000})\)")


def executables(text: str) -> dict[str, list[str]]:
    """Return the sources of the executables of a CMakeLists.txt, as written."""
    plain = re.sub(r"#[^\n]*", "", text)
    return {found[1]: found[2].split() for found in _EXECUTABLE.finditer(plain)}


def plugins(source: str) -> list[str]:
    """Return the classes that a source registers, to be loaded into a container."""
    return [found.removeprefix("::") for found in _REGISTERED.findall(source)]


def executables_of_plugins(text: str) -> dict[str, str]:
    """Return the registered class of each executable that a CMakeLists.txt has for one."""
    found: dict[str, str] = {}
    for match in _OF_PLUGIN.finditer(re.sub(r"#[^\n]*", "", text)):
        words = match[1].replace('"', " ").split()
        options = dict(itertools.pairwise(words))
        if "PLUGIN" in options and "EXECUTABLE" in options:
            found[options["EXECUTABLE"]] = options["PLUGIN"]
    return found


def read(file: str, source: str, questions: list[Question]) -> Json | None:
    """Return the node of a source; None if it has none, or more than can be told apart."""
    text = _COMMENT.sub(lambda found: found[0] if found[0].startswith('"') else re.sub(r"[^\n]", " ", found[0]), source)
    if _ANY_MAKER.search(text) is None:
        return None
    classes, names = _CLASS.findall(text), sorted(set(_NAME.findall(text)))
    if len(names) != 1 or len(classes) > 1:
        reason = f"{len(names)} literal names of nodes and {len(classes)} classes"
        questions.append(Question(file, 1, f"Which nodes does this C++ source have? It is not read: {reason}."))
        return None
    own = [Question(file, 1, "This C++ source was read by its tokens alone. Are these all of its topics?")]
    endpoints = [found for match in _MAKER.finditer(text) if (found := _endpoint(file, text, match, own))]
    return {
        "file": file,
        "module": "",
        "class": classes[0] if classes else names[0],
        "line": 1,
        "name": names[0],
        "namespace": "",
        "description": "",
        "endpoints": endpoints,
        "timers": [],
        "questions": [each.json for each in own],
    }


def _endpoint(file: str, text: str, match: re.Match[str], questions: list[Question]) -> Json | None:
    kind, line = match[1], text.count("\n", 0, match.start()) + 1
    arguments = _arguments(text, match.end())
    of_type, topic = _TYPE.match(match[2]), _TEXT.match(arguments[0]) if arguments else None
    if of_type is None or topic is None:
        unknown = "type" if of_type is None else "topic"
        questions.append(Question(file, line, f"What is the {unknown} of this {kind}? It is no literal."))
        return None
    qos = _qos(arguments[1]) if len(arguments) > 1 else None
    if qos is None:
        questions.append(
            Question(file, line, f"What is the quality of service of '{topic[1]}' here? It is no literal.")
        )
    full = f"{of_type[1]}/msg/{of_type[2]}"
    return {"kind": kind, "file": file, "line": line, "fields": None, "type": full, "topic": topic[1], "qos": qos}


def _qos(text: str) -> Json | None:
    if text.isdigit():
        return {"depth": int(text)}
    found = _QOS.match(text)
    if found is None:
        return None
    preset = {"Sen": "sensor_data", "Sys": "system_default"}.get(found[1][:3])
    qos: Json = {"profile": preset} if preset else {"depth": int(found[2])}
    if _CHANGES.sub("", found[3]).strip():
        return None
    for change in _CHANGES.findall(found[3]):
        policy, value = _POLICIES[change]
        qos[policy] = value
    return qos


def _arguments(text: str, start: int) -> list[str]:
    """Return the arguments of a call that begin at a place, without those behind the second."""
    found: list[str] = []
    depth, begin, quoted = 0, start, False
    for at in range(start, min(len(text), start + 5000)):
        character = text[at]
        if character == '"' and text[at - 1] != "\\":
            quoted = not quoted
        elif quoted:
            continue
        elif character in "([{":
            depth += 1
        elif character in ")]}" and depth:
            depth -= 1
        elif depth == 0 and character in ",)":
            found.append(text[begin:at].strip())
            begin = at + 1
            if character == ")" or len(found) == 2:
                return found
    return found
