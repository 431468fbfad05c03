"""Print what cantools reads of networks in DBC, in the lines of DbcPeerTest."""

import struct
import sys
from pathlib import Path

import cantools


def number(value):
    """Return the bits of a double."""
    return "none" if value is None else struct.pack(">d", value).hex()


def described(signal):
    """Return the line of a signal."""
    choices = {key: str(text) for key, text in (signal.choices or {}).items()}
    return " ".join(
        [
            signal.name,
            str(signal.start),
            str(signal.length),
            "big" if signal.byte_order == "big_endian" else "little",
            "float" if signal.is_float else "signed" if signal.is_signed else "unsigned",
            number(signal.scale),
            number(signal.offset),
            number(signal.minimum),
            number(signal.maximum),
            repr(signal.unit or ""),
            "M" if signal.is_multiplexer else "-",
            ",".join(map(str, signal.multiplexer_ids or [])) or "-",
            repr(sorted(choices.items())),
            repr(signal.comment or ""),
        ]
    )


def lines(file):
    """Return the lines of a network, or that it is refused."""
    try:
        network = cantools.database.load_file(file, strict=True, sort_signals=None)
    except cantools.database.UnsupportedDatabaseFormatError:
        return ["refused"]
    found = [f"nodes {' '.join(node.name for node in network.nodes)}"]
    for message in network.messages:
        extended = "extended" if message.is_extended_frame else "standard"
        senders = ",".join(sorted(message.senders)) or "-"
        found.append(
            f"message {message.name} {message.frame_id} {extended} {message.length} {senders} "
            f"{message.cycle_time or 0} {message.comment or ''!r}"
        )
        found += [described(signal) for signal in message.signals]
    return found


for file in sorted(Path(sys.argv[1]).glob("*.dbc")):
    print(f"file {file.name}")
    for line in lines(file):
        print(line)
