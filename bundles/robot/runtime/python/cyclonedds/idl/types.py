"""As `cyclonedds.idl.types`."""

from typing import Annotated

from eventchain_ros2.idl import array, bounded_str, sequence

int8 = Annotated[int, "int8"]
int16 = Annotated[int, "int16"]
int32 = Annotated[int, "int32"]
int64 = Annotated[int, "int64"]
byte = Annotated[int, "byte"]
uint8 = Annotated[int, "uint8"]
uint16 = Annotated[int, "uint16"]
uint32 = Annotated[int, "uint32"]
uint64 = Annotated[int, "uint64"]
float32 = Annotated[float, "float32"]
float64 = Annotated[float, "float64"]

__all__ = [
    "array",
    "bounded_str",
    "byte",
    "float32",
    "float64",
    "int8",
    "int16",
    "int32",
    "int64",
    "sequence",
    "uint8",
    "uint16",
    "uint32",
    "uint64",
]
