"""Binding of the C library of Eclipse Cyclone DDS 11.0.1 (libddsc) by ctypes: typed functions, and structures.

The official Python binding announces type information, which ROS 2's own middleware does not; therefore only its
library is used. Assumptions about the library's memory beyond its headers are checked at each use
(`set_source_timestamp`, and the descriptors of `type_support`).
"""

from __future__ import annotations

import ctypes
import importlib.util
import os
import sys
from ctypes import (
    POINTER,
    c_bool,
    c_char,
    c_char_p,
    c_int16,
    c_int32,
    c_int64,
    c_size_t,
    c_ssize_t,
    c_uint8,
    c_uint32,
    c_uint64,
)
from ctypes import c_void_p as pointer
from functools import cache
from pathlib import Path
from typing import Any

INFINITY = 0x7FFFFFFFFFFFFFFF
"""The duration without an end, in ns (DDS_INFINITY)."""

TIMEOUT = -10
"""Return code: the time given was not enough (DDS_RETCODE_TIMEOUT)."""

ANY_STATE = 0x7F
"""Samples and instances in whatever state."""

SERDATA_SAMPLE = 2
"""The kind of serialized data that is a whole sample (SDK_DATA)."""

_TIMESTAMP_OFFSET = 32  # offset of the source timestamp in `struct ddsi_serdata`
_UNSET_TIMESTAMP = -(2**63)


class LibraryUnavailableError(Exception):
    """The library cannot be used here; `hint` gives a remedy."""

    def __init__(self, message: str, hint: str) -> None:
        super().__init__(message)
        self.hint = hint


class DdsError(RuntimeError):
    """Cyclone DDS returned an error; `code` is its negative return code."""

    def __init__(self, what: str, code: int) -> None:
        super().__init__(f"{what}: {load().dds_strretcode(code).decode()}")
        self.code = code


class LayoutError(RuntimeError):
    """The library's memory layout differs from that of version 11.0.1."""

    def __init__(self, what: str) -> None:
        super().__init__(f"this libddsc is not that of Cyclone DDS 11.0.1: {what}")


class DynamicType(ctypes.Structure):
    """`dds_dynamic_type_t`."""

    _fields_ = (("opaque", pointer * 2), ("code", c_int32))


class TypeSpec(ctypes.Structure):
    """`dds_dynamic_type_spec_t`: a primitive kind (in the first bytes of `type`) or another dynamic type."""

    _fields_ = (("kind", c_int32), ("type", DynamicType))


class TypeDescriptor(ctypes.Structure):
    """`dds_dynamic_type_descriptor_t`."""

    _fields_ = (
        ("kind", c_int32),
        ("name", c_char_p),
        ("base_type", TypeSpec),
        ("discriminator_type", TypeSpec),
        ("number_of_bounds", c_uint32),
        ("bounds", POINTER(c_uint32)),
        ("element_type", TypeSpec),
        ("key_element_type", TypeSpec),
    )


class MemberDescriptor(ctypes.Structure):
    """`dds_dynamic_member_descriptor_t`."""

    _fields_ = (
        ("name", c_char_p),
        ("id", c_uint32),
        ("type", TypeSpec),
        ("default_value", pointer),
        ("index", c_uint32),
        ("number_of_labels", c_uint32),
        ("labels", pointer),
        ("is_default_label", c_bool),
    )


class Blob(ctypes.Structure):
    """`struct dds_type_meta_ser`."""

    _fields_ = (("data", pointer), ("size", c_uint32))


class TopicDescriptor(ctypes.Structure):
    """`dds_topic_descriptor_t`."""

    _fields_ = (
        ("size", c_uint32),
        ("alignment", c_uint32),
        ("flags", c_uint32),
        ("number_of_keys", c_uint32),
        ("type_name", c_char_p),
        ("keys", pointer),
        ("number_of_operations", c_uint32),
        ("operations", pointer),
        ("meta", pointer),
        ("type_information", Blob),
        ("type_mapping", Blob),
        ("restricted_representations", c_uint32),
    )


class SampleInfo(ctypes.Structure):
    """`dds_sample_info_t`."""

    _fields_ = (
        ("sample_state", c_uint32),
        ("view_state", c_uint32),
        ("instance_state", c_uint32),
        ("valid_data", c_bool),
        ("source_timestamp", c_int64),
        ("instance_handle", c_uint64),
        ("publication_handle", c_uint64),
        ("generations_and_ranks", c_uint32 * 5),
    )


class IoVector(ctypes.Structure):
    """`ddsrt_iovec_t`."""

    _fields_ = (("base", c_char_p), ("length", c_size_t))


class CountStatus(ctypes.Structure):
    """Statuses that count events; `last` is the handle of an instance, or the id of a policy in its lower half."""

    _fields_ = (("total", c_uint32), ("change", c_int32), ("last", c_uint64))


class MatchedStatus(ctypes.Structure):
    """`dds_publication_matched_status_t` and `dds_subscription_matched_status_t`."""

    _fields_ = (
        ("total", c_uint32),
        ("total_change", c_int32),
        ("current", c_uint32),
        ("current_change", c_int32),
        ("last", c_uint64),
    )


class LivelinessStatus(ctypes.Structure):
    """`dds_liveliness_changed_status_t`."""

    _fields_ = (
        ("alive", c_uint32),
        ("not_alive", c_uint32),
        ("alive_change", c_int32),
        ("not_alive_change", c_int32),
        ("last", c_uint64),
    )


class SerializedData(ctypes.Structure):
    """The known part of `struct ddsi_serdata`."""

    _fields_ = (("before", c_char * _TIMESTAMP_OFFSET), ("source_timestamp", c_int64))


class Endpoint(ctypes.Structure):
    """`dds_builtintopic_endpoint_t`: a discovered reader or writer."""

    _fields_ = (
        ("guid", c_uint8 * 16),
        ("participant_guid", c_uint8 * 16),
        ("participant_handle", c_uint64),
        ("topic_name", c_char_p),
        ("type_name", c_char_p),
        ("qos", pointer),
    )


_ENTITY = c_int32
_DURATION = c_int64
_STATUS = (c_int32, _ENTITY, POINTER(CountStatus))
# Name -> result type, argument types.
_FUNCTIONS: dict[str, tuple[Any, ...]] = {
    "dds_strretcode": (c_char_p, c_int32),
    "dds_free": (None, pointer),
    "dds_delete": (c_int32, _ENTITY),
    "dds_create_domain": (_ENTITY, c_uint32, c_char_p),
    "dds_create_participant": (_ENTITY, c_uint32, pointer, pointer),
    "dds_create_topic": (_ENTITY, _ENTITY, POINTER(TopicDescriptor), c_char_p, pointer, pointer),
    "dds_create_writer": (_ENTITY, _ENTITY, _ENTITY, pointer, pointer),
    "dds_create_reader": (_ENTITY, _ENTITY, _ENTITY, pointer, pointer),
    "dds_create_readcondition": (_ENTITY, _ENTITY, c_uint32),
    "dds_create_guardcondition": (_ENTITY, _ENTITY),
    "dds_set_guardcondition": (c_int32, _ENTITY, c_bool),
    "dds_create_waitset": (_ENTITY, _ENTITY),
    "dds_waitset_attach": (c_int32, _ENTITY, _ENTITY, c_ssize_t),
    "dds_waitset_wait": (c_int32, _ENTITY, pointer, c_size_t, _DURATION),
    "dds_set_status_mask": (c_int32, _ENTITY, c_uint32),
    "dds_get_guid": (c_int32, _ENTITY, c_char * 16),
    "dds_get_matched_subscriptions": (c_int32, _ENTITY, pointer, c_size_t),
    "dds_get_matched_publications": (c_int32, _ENTITY, pointer, c_size_t),
    "dds_get_matched_subscription_data": (POINTER(Endpoint), _ENTITY, c_uint64),
    "dds_get_matched_publication_data": (POINTER(Endpoint), _ENTITY, c_uint64),
    "dds_builtintopic_free_endpoint": (None, POINTER(Endpoint)),
    "dds_assert_liveliness": (c_int32, _ENTITY),
    "dds_wait_for_acks": (c_int32, _ENTITY, _DURATION),
    "dds_get_requested_incompatible_qos_status": _STATUS,
    "dds_get_offered_incompatible_qos_status": _STATUS,
    "dds_get_requested_deadline_missed_status": _STATUS,
    "dds_get_offered_deadline_missed_status": _STATUS,
    "dds_get_liveliness_lost_status": _STATUS,
    "dds_get_liveliness_changed_status": (c_int32, _ENTITY, POINTER(LivelinessStatus)),
    "dds_get_publication_matched_status": (c_int32, _ENTITY, POINTER(MatchedStatus)),
    "dds_get_subscription_matched_status": (c_int32, _ENTITY, POINTER(MatchedStatus)),
    "dds_create_qos": (pointer,),
    "dds_delete_qos": (None, pointer),
    "dds_qset_reliability": (None, pointer, c_int32, _DURATION),
    "dds_qset_history": (None, pointer, c_int32, c_int32),
    "dds_qset_durability": (None, pointer, c_int32),
    "dds_qset_durability_service": (None, pointer, _DURATION, c_int32, c_int32, c_int32, c_int32, c_int32),
    "dds_qset_deadline": (None, pointer, _DURATION),
    "dds_qset_lifespan": (None, pointer, _DURATION),
    "dds_qset_liveliness": (None, pointer, c_int32, _DURATION),
    "dds_qset_data_representation": (None, pointer, c_uint32, POINTER(c_int16)),
    "dds_qset_writer_data_lifecycle": (None, pointer, c_bool),
    "dds_qset_ignorelocal": (None, pointer, c_int32),
    "dds_qset_userdata": (None, pointer, c_char_p, c_size_t),
    "dds_qget_reliability": (c_bool, pointer, POINTER(c_int32), POINTER(_DURATION)),
    "dds_qget_durability": (c_bool, pointer, POINTER(c_int32)),
    "dds_qget_deadline": (c_bool, pointer, POINTER(_DURATION)),
    "dds_qget_liveliness": (c_bool, pointer, POINTER(c_int32), POINTER(_DURATION)),
    "dds_qget_userdata": (c_bool, pointer, POINTER(POINTER(c_char)), POINTER(c_size_t)),
    "dds_dynamic_type_create": (DynamicType, _ENTITY, TypeDescriptor),
    "dds_dynamic_type_add_member": (c_int32, POINTER(DynamicType), MemberDescriptor),
    "dds_dynamic_type_set_extensibility": (c_int32, POINTER(DynamicType), c_int32),
    "dds_dynamic_type_register": (c_int32, POINTER(DynamicType), POINTER(pointer)),
    "dds_dynamic_type_unref": (c_int32, POINTER(DynamicType)),
    "dds_free_typeinfo": (c_int32, pointer),
    "dds_create_topic_descriptor": (
        c_int32,
        c_int32,
        _ENTITY,
        pointer,
        _DURATION,
        POINTER(POINTER(TopicDescriptor)),
    ),
    "dds_delete_topic_descriptor": (None, POINTER(TopicDescriptor)),
    "dds_get_entity_sertype": (c_int32, _ENTITY, POINTER(pointer)),
    "dds_writecdr": (c_int32, _ENTITY, POINTER(SerializedData)),
    "dds_forwardcdr": (c_int32, _ENTITY, POINTER(SerializedData)),
    "dds_take": (c_int32, _ENTITY, POINTER(pointer), POINTER(SampleInfo), c_size_t, c_uint32),
    "dds_return_loan": (c_int32, _ENTITY, POINTER(pointer), c_int32),
    "dds_takecdr": (c_int32, _ENTITY, POINTER(pointer), c_uint32, POINTER(SampleInfo), c_uint32),
    "ddsi_serdata_from_ser_iov": (POINTER(SerializedData), pointer, c_int32, c_size_t, POINTER(IoVector), c_size_t),
    "ddsi_serdata_size": (c_uint32, pointer),
    "ddsi_serdata_to_ser": (None, pointer, c_size_t, c_size_t, pointer),
    "ddsi_serdata_unref": (None, pointer),
}


def library_path() -> Path:
    """Return the library that `EVENTCHAIN_LIBDDSC` names, else that of the wheel of `cyclonedds` on `sys.path`.

    Raises:
        LibraryUnavailableError: there is none.

    """
    named = os.environ.get("EVENTCHAIN_LIBDDSC")
    if named:
        return Path(named)
    # Not by an import: in the host `cyclonedds` is the simulated package.
    for folder in sys.path:
        source = Path(folder) / "cyclonedds" / "__library__.py"
        spec = importlib.util.spec_from_file_location("_cyclonedds_library", source) if source.is_file() else None
        if spec is not None and spec.loader is not None:
            module = importlib.util.module_from_spec(spec)
            spec.loader.exec_module(module)
            return Path(module.library_path)
    raise LibraryUnavailableError(
        "Eclipse Cyclone DDS is not installed in this Python",
        "install cyclonedds==11.0.1, or name its library in EVENTCHAIN_LIBDDSC",
    )


@cache
def load() -> ctypes.CDLL:
    """Return the library, loaded once, with the types of its functions.

    Raises:
        LibraryUnavailableError: it cannot be loaded, or has another version.

    """
    path = library_path()
    hint = "use the library of the Python package cyclonedds 11.0.1"
    try:
        library = ctypes.CDLL(str(path))
    except OSError as problem:
        raise LibraryUnavailableError(f"{path} cannot be loaded: {problem}", hint) from problem
    for name, (result, *arguments) in _FUNCTIONS.items():
        try:
            function = getattr(library, name)
        except AttributeError:
            raise LibraryUnavailableError(f"{path} has no function {name}", hint) from None
        function.restype, function.argtypes = result, arguments
    return library


def checked(code: int, what: str) -> int:
    """Return the result of a call.

    Raises:
        DdsError: it is an error.

    """
    if code < 0:
        raise DdsError(what, code)
    return code


def set_source_timestamp(serialized: Any, timestamp: int) -> None:
    """Set the source timestamp of new serialized data, in ns.

    Raises:
        LayoutError: the field has an unexpected value.

    """
    data = serialized.contents  # without access by address, which confined processes are refused
    if data.source_timestamp != _UNSET_TIMESTAMP:
        raise LayoutError("the source timestamp of a sample is elsewhere")
    data.source_timestamp = timestamp
