"""Definitions in IDL, against rosbags, an independent implementation."""

from __future__ import annotations

import random
from array import array
from pathlib import Path
from typing import Any

import pytest
from conftest import BUNDLE
from eventchain_ros2.catalog import Catalog
from eventchain_ros2.definitions import MessageDefinitionError
from eventchain_ros2.messages import Messages, from_cdr, to_cdr
from eventchain_ros2.type_support import type_hash
from instances import STORE, random_message
from rosbags.typesys import get_types_from_idl

FOLDER = BUNDLE.parent / "messages" / "conformance" / "definitions"
FILES = sorted(FOLDER.glob("*/msg/*.idl"))
NAMES = [f"{file.parent.parent.name}/msg/{file.stem}" for file in FILES]


@pytest.fixture(scope="module", autouse=True)
def known_to_rosbags() -> None:
    for file in FILES:  # rosbags takes no comment between the includes
        lines = file.read_text().splitlines()
        STORE.register(get_types_from_idl("\n".join(line for line in lines if not line.startswith("#include"))))


def in_modules(body: str, before: str = "") -> str:
    return f"module own_msgs {{ module msg {{\n{before}struct Own {{\n{body}\n}};\n}}; }};\n"


def written(tmp_path: Path, text: str, name: str = "Own.idl") -> Messages:
    file = tmp_path / "own_msgs" / "msg" / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)
    return Messages([tmp_path])


def test_there_are_files() -> None:
    assert [f"radar_msgs/msg/{name}" for name in ("Kinds", "Nothing", "Scan", "Target")] == NAMES


@pytest.mark.parametrize("name", NAMES)
def test_the_bytes_are_those_of_rosbags(name: str) -> None:
    message_class = Messages([FOLDER]).get(name)
    generator = random.Random(name)
    for _ in range(50):
        data = bytes(STORE.serialize_cdr(random_message(name, generator), name))
        assert to_cdr(from_cdr(message_class, data)) == data


@pytest.mark.parametrize("name", NAMES)
def test_the_hash_is_that_of_rosbags(name: str) -> None:
    catalog = Catalog([FOLDER])

    def defined(each: str) -> Any:
        return catalog.find(each)

    assert type_hash(name, defined) == STORE.hash_rihs01(name)


def test_constants_and_defaults_are_read() -> None:
    target: Any = Messages([FOLDER]).get("radar_msgs/msg/Target")
    assert (target.LIMIT, target.MASK, target.RANGE, target.IS_NEW) == (-7, 31, 150.0, True)
    assert target.NAME == "a name\n"
    message = target()
    assert (message.speed, message.seen, message.name) == (-2.5, True, 'no "name"')
    assert message.codes == array("h", [1, 2, 3])
    assert message.words == ["", ""]


def test_constants_are_those_of_rosbags() -> None:
    constants, _ = STORE.fielddefs["radar_msgs/msg/Target"]
    found = Catalog([FOLDER]).find("radar_msgs/msg/Target")
    assert found is not None
    by_rosbags = {name: value for name, _, value in constants if name != "NAME"}  # which it does not join
    assert by_rosbags == {each.name: each.value for each in found.constants if each.name != "NAME"}


@pytest.mark.parametrize(
    ("text", "line", "problem"),
    [
        ("union Own switch (long) { case 1: long a; };", 1, "'union' of IDL is not part"),
        ("module own_msgs { module srv {", 1, "the module own_msgs::srv is not one of own_msgs::msg::Own_Constants"),
        ("#define N 3", 1, "'#' is not allowed here"),
        ("module own_msgs { module msg { }; };", 0, "there is no structure own_msgs::msg::Own"),
        (
            "module own_msgs {\nmodule msg {\nstruct Other { long a; };",
            3,
            "the structure Other needs its own file",
        ),
        ("module own_msgs { module msg { struct Own : Base {", 1, "here has to be {, not :"),
        ("module own_msgs { module msg {\nenum Color { RED };", 2, "'enum' of IDL is not part"),
        ("module own_msgs { module msg {\nconst long N = 1;", 2, "'const' of IDL is not part"),
        (in_modules("long a"), 4, "here has to be ;, not }"),
        (in_modules("wstring a;"), 3, "the type wstring of IDL is not part"),
        (in_modules("char a;"), 3, "the type char of IDL is not part"),
        (in_modules("long double a;"), 3, "the type long double of IDL is not part"),
        (in_modules("map<long, long> a;"), 3, "the type map of IDL is not part"),
        (in_modules("long a;\nlong a;"), 4, "'a' is defined twice"),
        (in_modules("long class;"), 3, "'class' cannot be the name"),
        (in_modules("long a[2][2];"), 3, "arrays and sequences of arrays"),
        (in_modules("sequence<sequence<long>> a;"), 3, "arrays and sequences of arrays"),
        (in_modules("Rows a;", "typedef double Row[2]; typedef sequence<Row> Rows;\n"), 2, "arrays and sequences"),
        (in_modules("sequence<long, 0> a;"), 3, "0 is not a size"),
        (in_modules("sequence<long, N> a;"), 3, "here has to be number, not N"),
        (in_modules("long a[1 + 1];"), 3, "here has to be ], not +"),
        (in_modules("@optional long a;"), 3, "@optional is not part"),
        (in_modules("long a;").replace("struct", "@extensibility(MUTABLE) struct"), 2, "@extensibility is not part"),
        (in_modules("@default(value=x) long a;"), 3, "here has to be TRUE or FALSE, not x"),
        (in_modules("@default(value=1.5) long a;"), 3, "invalid literal"),
        (in_modules('@default(value="\\x41") string a;'), 3, "the escape sequence"),
        (in_modules("@verbatim (language="), 6, "here has to be ), not the end of the file"),
        (in_modules("other_msgs::Thing a;"), 3, "is neither a primitive type nor a message type"),
        (in_modules("/* without end"), 3, "'/' is not allowed here"),
    ],
)
def test_what_is_not_read_is_refused_with_its_line(tmp_path: Path, text: str, line: int, problem: str) -> None:
    with pytest.raises(MessageDefinitionError) as caught:
        written(tmp_path, text).get("own_msgs/msg/Own")
    assert problem in str(caught.value)
    assert (caught.value.line, caught.value.file) == (line, str(tmp_path / "own_msgs" / "msg" / "Own.idl"))


MSG = "char c\nuint8[<=2] d\nint32 LIMIT=4\nstring name 'x'\n"
SAME = in_modules(
    'uint8 c;\nsequence<uint8, 2> d;\n@default(value="x") string name;',
    "module Own_Constants { const int32 LIMIT = 4; };\n",
)


def test_two_files_of_a_type_may_say_the_same(tmp_path: Path) -> None:
    written(tmp_path, MSG, "Own.msg")
    own: Any = written(tmp_path, SAME).get("own_msgs/msg/Own")
    assert (own.LIMIT, own().name) == (4, "x")


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("uint8 c", "int8 c"),
        ("uint8 c;\nsequence<uint8, 2> d;", "sequence<uint8, 2> d;\nuint8 c;"),
        ('"x"', '"y"'),
        ("LIMIT = 4", "LIMIT = 5"),
        ("uint8 c;", "uint8 c; uint8 e;"),
    ],
)
def test_two_files_of_a_type_that_differ_are_refused(tmp_path: Path, old: str, new: str) -> None:
    assert old in SAME
    written(tmp_path, MSG, "Own.msg")
    with pytest.raises(MessageDefinitionError, match=r"Own\.msg beside it says something else") as caught:
        written(tmp_path, SAME.replace(old, new)).get("own_msgs/msg/Own")
    assert caught.value.file == str(tmp_path / "own_msgs" / "msg" / "Own.idl")


def test_a_later_folder_hides_both_files_of_an_earlier_one(tmp_path: Path) -> None:
    first, second = tmp_path / "first", tmp_path / "second"
    written(first, in_modules("long a;"))
    written(second, "int64 b\n", "Own.msg")
    own: Any = Messages([first, second]).get("own_msgs/msg/Own")
    assert own.__slots__ == ("b",)


def test_messages_in_idl_can_be_imported() -> None:
    Messages([FOLDER]).install()
    from radar_msgs.msg import Nothing, Scan, Target

    assert isinstance(Scan().nearest, Target)
    assert Nothing.get_fields_and_field_types() == {}
