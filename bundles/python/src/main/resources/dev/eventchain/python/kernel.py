"""Give up rights for good, through the kernel: seccomp (system calls), Landlock (files) and capabilities.

The same for a process that bubblewrap holds and for one that only audit hooks hold. Everything here is optional: on a
kernel or a processor that lacks a part, that part is skipped, and the functions return whether they took effect.
References: seccomp(2), landlock(7), capset(2); ``linux/seccomp.h``, ``linux/landlock.h``.
"""

from __future__ import annotations

import ctypes
import errno
import os
import platform
import signal
import stat
import struct
from collections.abc import Iterable

PR_SET_PDEATHSIG = 1
PR_SET_SECCOMP = 22
PR_SET_NO_NEW_PRIVS = 38
SECCOMP_MODE_FILTER = 2
CLONE_THREAD = 0x00010000

_library = ctypes.CDLL(None, use_errno=True)

ARCHITECTURES = {"x86_64": 0xC000003E, "aarch64": 0xC00000B7}
X32_BIT = 0x40000000
# Numbers above 424 are the same on every architecture.
COMMON_DENIED = (
    *(424, 425, 426, 427, 428, 429, 430, 431, 432, 433, 434, 438, 440, 442, 447, 452, 463, 466),
    # pidfd_send_signal, io_uring_*, open_tree, move_mount, fs*, pidfd_open, pidfd_getfd, process_madvise,
    # mount_setattr, memfd_secret, fchmodat2, setxattrat, removexattrat
)
CLONE3 = 435
DENIED = {
    "x86_64": {
        "network": (41, 42, 49, 50, 53),  # socket connect bind listen socketpair
        "processes": (57, 58, 59, 322, 101, 310, 311, 312, 272, 308, 129, 297, 135),
        # fork vfork execve execveat ptrace process_vm_* kcmp unshare setns rt_*sigqueueinfo personality
        "files": (90, 91, 92, 93, 94, 260, 268, 132, 235, 261, 280, 188, 189, 190, 197, 198, 199, 133, 259, 303, 304),
        # *chmod* *chown* utime* futimesat *setxattr *removexattr mknod* *_handle_at
        "memory": (29, 240, 319),  # shmget mq_open memfd_create
        "machine": (160, 161, 155, 165, 166, 167, 168, 169, 164, 227, 170, 171, 163, 172, 173, 175, 176, 313, 246, 320),
        # setrlimit chroot pivot_root mount umount2 swap* reboot settime* sethostname acct iopl *_module kexec_*
        "kernel": (103, 179, 248, 249, 250, 298, 321, 323),  # syslog quotactl keys perf_event_open bpf userfaultfd
    },
    "aarch64": {
        "network": (198, 203, 200, 201, 199),
        "processes": (221, 281, 117, 270, 271, 272, 97, 268, 138, 240, 92),
        "files": (52, 53, 54, 55, 88, 5, 6, 7, 14, 15, 16, 33, 264, 265),
        "memory": (194, 180, 279),
        "machine": (164, 51, 41, 40, 39, 224, 225, 142, 170, 112, 161, 162, 89, 105, 106, 273, 104, 294),
        "kernel": (116, 60, 217, 218, 219, 241, 280, 282),
    },
}
CLONE = {"x86_64": 56, "aarch64": 220}
PRCTL = {"x86_64": 157, "aarch64": 167}
PRLIMIT = {"x86_64": 302, "aarch64": 261}
SIGNALLING = {"x86_64": (62, 200, 234), "aarch64": (129, 130, 131)}  # kill tkill tgkill

LOAD, EQUAL, AT_LEAST, ANY_BIT, RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
ALLOW, REFUSE, KILL = 0x7FFF0000, 0x00050000, 0x80000000
NUMBER, ARCHITECTURE = 0, 4


def die_with_parent() -> None:
    """Ask for SIGKILL when the parent ends, however it ends."""
    _library.prctl(PR_SET_PDEATHSIG, int(signal.SIGKILL), 0, 0, 0)


def drop_capabilities() -> bool:
    """Give up what root may do beyond owning files."""
    header = struct.pack("<Ii", 0x20080522, 0)
    return int(_library.capset(header, bytes(24))) == 0


def filter_system_calls() -> bool:
    """Refuse, from now on, to start processes, to open sockets, to signal or read other processes, to change modes."""
    program = _program()
    if not program:
        return False
    buffer = ctypes.create_string_buffer(program)
    header = struct.pack("@HP", len(program) // 8, ctypes.addressof(buffer))
    _library.prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0)
    return int(_library.prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, header, 0, 0)) == 0


def _program() -> bytes:
    """The filter as Berkeley packet filter code; empty on a processor whose system calls are not listed."""
    machine = platform.machine()
    if machine not in ARCHITECTURES:
        return b""
    code = [
        _instruction(LOAD, ARCHITECTURE),
        _instruction(EQUAL, ARCHITECTURES[machine], 1, 0),
        _instruction(RETURN, KILL),
        _instruction(LOAD, NUMBER),
        *((_instruction(AT_LEAST, X32_BIT, 0, 1), _refuse(errno.EPERM)) if machine == "x86_64" else ()),
        *_for_call(CLONE3, _refuse(errno.ENOSYS)),  # the C library then falls back to clone, whose flags can be seen
        *_for_call(CLONE[machine], *_unless(ANY_BIT, 0, CLONE_THREAD)),
        *_for_call(PRCTL[machine], *_if(0, PR_SET_PDEATHSIG)),
        *_for_call(PRLIMIT[machine], *_unless_own_limit_is_read()),
    ]
    for number in SIGNALLING[machine]:
        code += _for_call(number, *_unless(EQUAL, 0, os.getpid()))
    for number in sorted({*COMMON_DENIED, *(n for group in DENIED[machine].values() for n in group)}):
        code += _for_call(number, _refuse(errno.EPERM))
    return b"".join([*code, _instruction(RETURN, ALLOW)])


def _instruction(code: int, value: int, if_true: int = 0, if_false: int = 0) -> bytes:
    return struct.pack("<HBBI", code, if_true, if_false, value & 0xFFFFFFFF)


def _refuse(error: int) -> bytes:
    return _instruction(RETURN, REFUSE | error)


def _for_call(number: int, *then: bytes) -> list[bytes]:
    """Do this for one system call; ``then`` has to return."""
    return [_instruction(EQUAL, number, 0, len(then)), *then]


def _argument(index: int, high: bool = False) -> bytes:
    return _instruction(LOAD, 16 + 8 * index + (4 if high else 0))


def _unless(test: int, argument: int, value: int) -> tuple[bytes, ...]:
    return (
        _argument(argument),
        _instruction(test, value, 1, 0),
        _refuse(errno.EPERM),
        _instruction(RETURN, ALLOW),
    )


def _if(argument: int, value: int) -> tuple[bytes, ...]:
    return (
        _argument(argument),
        _instruction(EQUAL, value, 0, 1),
        _refuse(errno.EPERM),
        _instruction(RETURN, ALLOW),
    )


def _unless_own_limit_is_read() -> tuple[bytes, ...]:
    """prlimit64(0, resource, NULL, old): the own process, and no new limit."""
    refuse = _refuse(errno.EPERM)
    tests = ((_argument(0), 5), (_argument(2), 3), (_argument(2, high=True), 1))
    code = [part for load, distance in tests for part in (load, _instruction(EQUAL, 0, 0, distance))]
    return (*code, _instruction(RETURN, ALLOW), refuse)


CREATE_RULESET, ADD_RULE, RESTRICT_SELF = 444, 445, 446
EXECUTE, WRITE_FILE, READ_FILE, READ_DIR = 1, 2, 4, 8
MAKE_CHAR, MAKE_SOCK, MAKE_BLOCK, REFER, TRUNCATE, IOCTL = 1 << 6, 1 << 9, 1 << 11, 1 << 13, 1 << 14, 1 << 15
FILE_RIGHTS = EXECUTE | WRITE_FILE | READ_FILE | TRUNCATE | IOCTL


def restrict_files(readable: Iterable[str], writable: Iterable[str]) -> bool:
    """Refuse, from now on, all files but these and what is below them (Landlock)."""
    version = int(_library.syscall(CREATE_RULESET, None, ctypes.c_size_t(0), 1))
    if version < 1:
        return False
    handled = (1 << 13) - 1
    handled |= (REFER if version >= 2 else 0) | (TRUNCATE if version >= 3 else 0) | (IOCTL if version >= 5 else 0)
    network = struct.pack("<Q", 3) if version >= 4 else b""
    attributes = struct.pack("<Q", handled) + network
    rules = int(_library.syscall(CREATE_RULESET, attributes, ctypes.c_size_t(len(attributes)), 0))
    if rules < 0:
        return False
    for path in readable:
        _allow(rules, path, handled & (READ_FILE | READ_DIR | EXECUTE))
    for path in writable:
        _allow(rules, path, handled & ~(EXECUTE | MAKE_CHAR | MAKE_BLOCK | MAKE_SOCK | IOCTL))
    _library.prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0)
    restricted = int(_library.syscall(RESTRICT_SELF, rules, 0)) == 0
    os.close(rules)
    return restricted


def _allow(rules: int, path: str, rights: int) -> None:
    try:
        place = os.open(path, os.O_PATH | os.O_CLOEXEC)
    except OSError:
        return
    if not stat.S_ISDIR(os.fstat(place).st_mode):
        rights &= FILE_RIGHTS
    _library.syscall(ADD_RULE, rules, 1, struct.pack("<Qi", rights, place), 0)
    os.close(place)
