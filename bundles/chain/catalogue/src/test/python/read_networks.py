"""Print what cantools reads of networks in DBC and ARXML, in the lines of NetworkLines."""

import logging
import struct
import sys
from pathlib import Path

import cantools


def number(value):
    """Return the bits of a double."""
    return "none" if value is None else struct.pack(">d", value).hex()


def limits(signal, autosar):
    """Return the limits; of numbers that AUTOSAR gives texts only, the least and greatest one."""
    if autosar and signal.choices and signal.minimum is None and signal.maximum is None:
        return min(signal.choices), max(signal.choices)
    return signal.minimum, signal.maximum


def described(signal, autosar):
    """Return the line of a signal."""
    choices = {key: str(text) for key, text in (signal.choices or {}).items()}
    minimum, maximum = limits(signal, autosar)
    return " ".join(
        [
            signal.name,
            str(signal.start),
            str(signal.length),
            "big" if signal.byte_order == "big_endian" else "little",
            "float" if signal.is_float else "signed" if signal.is_signed else "unsigned",
            number(signal.scale),
            number(signal.offset),
            number(minimum),
            number(maximum),
            repr(signal.unit or ""),
            "M" if signal.is_multiplexer else "-",
            ",".join(map(str, signal.multiplexer_ids or [])) or "-",
            str(signal.raw_initial) if autosar and signal.raw_initial is not None else "none",
            repr(sorted(choices.items())),
            repr(signal.comment or ""),
        ]
    )


def lines(file):
    """Return the lines of a network, or that it is refused."""
    try:
        network = cantools.database.load_file(file, strict=True, sort_signals=None)
        autosar = file.suffix == ".arxml"
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
        found += [described(signal, autosar) for signal in message.signals]
    return found


logging.disable(logging.WARNING)
for file in sorted(Path(sys.argv[1]).iterdir()):
    print(f"file {file.name}")
    for line in lines(file):
        print(line)
