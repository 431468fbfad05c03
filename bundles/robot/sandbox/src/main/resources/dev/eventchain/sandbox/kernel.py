"""Permanently give up rights through the kernel: seccomp (system calls), Landlock (files) and capabilities.

The same with bubblewrap and with audit hooks only. Everything here is optional: a part that the kernel or the processor
lacks is skipped, and the functions return whether they took effect. References: seccomp(2), landlock(7), capset(2);
``linux/seccomp.h``, ``linux/landlock.h``.
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
PR_SCHED_CORE = 62
SECCOMP_MODE_FILTER = 2
CLONE_THREAD = 0x00010000
NAMESPACES = 0x7E020000
"""All namespaces that bubblewrap makes: of mounts, cgroup, UTS, IPC, users, processes and network (sched.h)."""

_library = ctypes.CDLL(None, use_errno=True)

# The audit architecture of each processor, and its column of NUMBERS.
ARCHITECTURES = {"x86_64": (0xC000003E, 0), "aarch64": (0xC00000B7, 1)}
X32_BIT = 0x40000000
# Linux's numbers of system calls, on x86-64 and on AArch64 (which lacks old ones); a test compares them with the
# headers of the machine. From 424 on both have the same numbers.
NUMBERS: dict[str, tuple[int, int | None]] = {
    "accept": (43, 202),
    "accept4": (288, 242),
    "acct": (163, 89),
    "add_key": (248, 217),
    "adjtimex": (159, 171),
    "bind": (49, 200),
    "bpf": (321, 280),
    "chmod": (90, None),
    "chown": (92, None),
    "chroot": (161, 51),
    "clock_adjtime": (305, 266),
    "clock_settime": (227, 112),
    "clone": (56, 220),
    "clone3": (435, 435),
    "connect": (42, 203),
    "delete_module": (176, 106),
    "execve": (59, 221),
    "execveat": (322, 281),
    "fanotify_init": (300, 262),
    "fanotify_mark": (301, 263),
    "fchmod": (91, 52),
    "fchmodat": (268, 53),
    "fchmodat2": (452, 452),
    "fchown": (93, 55),
    "fchownat": (260, 54),
    "fcntl": (72, 25),
    "finit_module": (313, 273),
    "fork": (57, None),
    "fremovexattr": (199, 16),
    "fsconfig": (431, 431),
    "fsetxattr": (190, 7),
    "fsmount": (432, 432),
    "fsopen": (430, 430),
    "fspick": (433, 433),
    "futimesat": (261, None),
    "init_module": (175, 105),
    "inotify_add_watch": (254, 27),
    "inotify_init": (253, None),
    "inotify_init1": (294, 26),
    "io_uring_enter": (426, 426),
    "io_uring_register": (427, 427),
    "io_uring_setup": (425, 425),
    "ioctl": (16, 29),
    "ioperm": (173, None),
    "iopl": (172, None),
    "ioprio_set": (251, 30),
    "kcmp": (312, 272),
    "kexec_file_load": (320, 294),
    "kexec_load": (246, 104),
    "keyctl": (250, 219),
    "kill": (62, 129),
    "landlock_add_rule": (445, 445),
    "landlock_create_ruleset": (444, 444),
    "landlock_restrict_self": (446, 446),
    "lchown": (94, None),
    "listen": (50, 201),
    "lookup_dcookie": (212, 18),
    "lremovexattr": (198, 15),
    "lsetxattr": (189, 6),
    "membarrier": (324, 283),
    "memfd_create": (319, 279),
    "memfd_secret": (447, 447),
    "migrate_pages": (256, 238),
    "mknod": (133, None),
    "mknodat": (259, 33),
    "modify_ldt": (154, None),
    "mount": (165, 40),
    "mount_setattr": (442, 442),
    "move_mount": (429, 429),
    "move_pages": (279, 239),
    "mq_getsetattr": (245, 185),
    "mq_notify": (244, 184),
    "mq_open": (240, 180),
    "mq_timedreceive": (243, 183),
    "mq_timedsend": (242, 182),
    "mq_unlink": (241, 181),
    "msgctl": (71, 187),
    "msgget": (68, 186),
    "msgrcv": (70, 188),
    "msgsnd": (69, 189),
    "name_to_handle_at": (303, 264),
    "open_by_handle_at": (304, 265),
    "open_tree": (428, 428),
    "perf_event_open": (298, 241),
    "personality": (135, 92),
    "pidfd_getfd": (438, 438),
    "pidfd_open": (434, 434),
    "pidfd_send_signal": (424, 424),
    "pivot_root": (155, 41),
    "prctl": (157, 167),
    "prlimit64": (302, 261),
    "process_madvise": (440, 440),
    "process_mrelease": (448, 448),
    "process_vm_readv": (310, 270),
    "process_vm_writev": (311, 271),
    "ptrace": (101, 117),
    "quotactl": (179, 60),
    "quotactl_fd": (443, 443),
    "reboot": (169, 142),
    "removexattr": (197, 14),
    "request_key": (249, 218),
    "rt_sigqueueinfo": (129, 138),
    "rt_tgsigqueueinfo": (297, 240),
    "sched_setaffinity": (203, 122),
    "sched_setattr": (314, 274),
    "sched_setparam": (142, 118),
    "sched_setscheduler": (144, 119),
    "semctl": (66, 191),
    "semget": (64, 190),
    "semop": (65, 193),
    "semtimedop": (220, 192),
    "setdomainname": (171, 162),
    "sethostname": (170, 161),
    "setns": (308, 268),
    "setpriority": (141, 140),
    "setrlimit": (160, 164),
    "settimeofday": (164, 170),
    "setxattr": (188, 5),
    "shmat": (30, 196),
    "shmctl": (31, 195),
    "shmget": (29, 194),
    "socket": (41, 198),
    "socketpair": (53, 199),
    "swapoff": (168, 225),
    "swapon": (167, 224),
    "sync": (162, 81),
    "syncfs": (306, 267),
    "sysfs": (139, None),
    "syslog": (103, 116),
    "tgkill": (234, 131),
    "tkill": (200, 130),
    "umount2": (166, 39),
    "unshare": (272, 97),
    "uselib": (134, None),
    "userfaultfd": (323, 282),
    "ustat": (136, None),
    "utime": (132, None),
    "utimensat": (280, 88),
    "utimes": (235, None),
    "vfork": (58, None),
    "vhangup": (153, 58),
}
# System calls newer than this table are treated as unsupported: the C library then uses an older one.
NEWEST_KNOWN = 462
# System calls that a component does not need, by resource.
DENIED = {
    "network": (*("socket", "connect", "bind", "listen", "accept", "accept4", "socketpair"),),
    "processes": (
        *("fork", "vfork", "execve", "execveat", "ptrace", "process_vm_readv", "process_vm_writev"),
        *("process_madvise", "process_mrelease", "kcmp", "unshare", "setns", "rt_sigqueueinfo"),
        *("rt_tgsigqueueinfo", "personality", "pidfd_open", "pidfd_getfd", "pidfd_send_signal"),
    ),
    "scheduling": (
        *("setpriority", "ioprio_set", "sched_setaffinity", "sched_setscheduler", "sched_setparam"),
        *("sched_setattr", "migrate_pages", "move_pages", "membarrier"),
    ),
    "files": (
        *("chmod", "fchmod", "fchmodat", "fchmodat2", "chown", "fchown", "lchown", "fchownat", "utime", "utimes"),
        *("utimensat", "futimesat", "setxattr", "lsetxattr", "fsetxattr", "removexattr", "lremovexattr"),
        *("fremovexattr", "mknod", "mknodat", "name_to_handle_at", "open_by_handle_at", "inotify_init"),
        *("inotify_init1", "inotify_add_watch", "fanotify_init", "fanotify_mark", "sync", "syncfs"),
    ),
    "memory": (
        *("shmget", "shmat", "shmctl", "msgget", "msgsnd", "msgrcv", "msgctl", "semget", "semop", "semtimedop"),
        *("semctl", "mq_open", "mq_unlink", "mq_timedsend", "mq_timedreceive", "mq_notify", "mq_getsetattr"),
        *("memfd_create", "memfd_secret", "userfaultfd"),
    ),
    "machine": (
        *("setrlimit", "chroot", "pivot_root", "mount", "umount2", "mount_setattr", "move_mount", "open_tree"),
        *("fsopen", "fsconfig", "fsmount", "fspick", "swapon", "swapoff", "reboot", "settimeofday"),
        *("clock_settime", "clock_adjtime", "adjtimex", "sethostname", "setdomainname", "acct", "vhangup", "iopl"),
        *("ioperm", "modify_ldt", "init_module", "finit_module", "delete_module", "kexec_load", "kexec_file_load"),
        *("quotactl", "quotactl_fd"),
    ),
    "kernel": (
        *("syslog", "add_key", "request_key", "keyctl", "perf_event_open", "bpf", "io_uring_setup"),
        *("io_uring_enter", "io_uring_register", "lookup_dcookie", "uselib", "ustat", "sysfs"),
    ),
}
SIGNALLING = ("kill", "tkill", "tgkill")
# fcntl: receiver and number of an open file's signals; ioctl: typing on a terminal.
SIGNAL_COMMANDS = {"F_SETOWN": 8, "F_SETSIG": 10, "F_SETOWN_EX": 15}
TERMINAL_COMMANDS = {"TIOCSTI": 0x5412, "TIOCLINUX": 0x541C}

LOAD, EQUAL, AT_LEAST, ANY_BIT, RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
ALLOW, REFUSE, KILL = 0x7FFF0000, 0x00050000, 0x80000000
NUMBER, ARCHITECTURE = 0, 4


def die_with_parent() -> None:
    """Request SIGKILL for the end of the parent, however it ends."""
    _library.prctl(PR_SET_PDEATHSIG, int(signal.SIGKILL), 0, 0, 0)


def enter_namespaces(process: int) -> None:
    """Enter the namespaces of this process; from then on, children are in its namespace of processes.

    Raises:
        OSError: they cannot be entered.

    """
    descriptor = os.pidfd_open(process)
    try:
        if int(_library.setns(descriptor, NAMESPACES)) != 0:
            raise OSError(ctypes.get_errno(), "setns")
    finally:
        os.close(descriptor)


def gain_no_privileges() -> None:
    """Refuse, permanently, privileges by the execution of a file."""
    _library.prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0)


def drop_capabilities() -> bool:
    """Give up the capabilities of root except those for its own files."""
    header = struct.pack("<Ii", 0x20080522, 0)
    return int(_library.capset(header, bytes(24))) == 0


def filter_system_calls() -> bool:
    """Refuse, permanently, to start processes, to open sockets, to affect other processes, to change modes.

    This is a deny list: an allow list for Python, NumPy and the C library would break with each of their versions.
    System calls newer than the table are refused.
    """
    program = _program()
    if not program:
        return False
    buffer = ctypes.create_string_buffer(program)
    header = struct.pack("@HP", len(program) // 8, ctypes.addressof(buffer))
    gain_no_privileges()
    return int(_library.prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, header, 0, 0)) == 0


def _program() -> bytes:
    """Return the filter as Berkeley packet filter code; empty on a processor without listed system calls."""
    if _INDEPENDENT is None:
        return b""
    first, known, rest = _INDEPENDENT
    process = [part for name in SIGNALLING for part in _for_call(known[name], *_unless(EQUAL, 0, os.getpid()))]
    return b"".join([first, *process, rest])


def _independent(machine: str) -> tuple[bytes, dict[str, int], bytes] | None:
    """Return the code before and after that which depends on the process, and the numbers of the system calls."""
    if machine not in ARCHITECTURES:
        return None
    architecture, column = ARCHITECTURES[machine]
    known = {name: number for name, both in NUMBERS.items() if (number := both[column]) is not None}
    first = [
        _instruction(LOAD, ARCHITECTURE),
        _instruction(EQUAL, architecture, 1, 0),
        _instruction(RETURN, KILL),
        _instruction(LOAD, NUMBER),
        *((_instruction(AT_LEAST, X32_BIT, 0, 1), _refuse(errno.EPERM)) if machine == "x86_64" else ()),
        *(_instruction(AT_LEAST, NEWEST_KNOWN + 1, 0, 1), _refuse(errno.ENOSYS)),
        *_for_call(known["clone3"], _refuse(errno.ENOSYS)),  # a filter sees clone's flags, not clone3's
        *_for_call(known["clone"], *_unless(ANY_BIT, 0, CLONE_THREAD)),
        *_for_call(known["prctl"], *_if_any(0, [PR_SET_PDEATHSIG, PR_SCHED_CORE])),
        *_for_call(known["fcntl"], *_if_any(1, SIGNAL_COMMANDS.values())),
        *_for_call(known["ioctl"], *_if_any(1, TERMINAL_COMMANDS.values())),
        *_for_call(known["prlimit64"], *_unless_own_limit_is_read()),
    ]
    denied = sorted(known[name] for group in DENIED.values() for name in group if name in known)
    rest = [part for number in denied for part in _for_call(number, _refuse(errno.EPERM))]
    return b"".join(first), known, b"".join([*rest, _instruction(RETURN, ALLOW)])


def _instruction(code: int, value: int, if_true: int = 0, if_false: int = 0) -> bytes:
    return struct.pack("<HBBI", code, if_true, if_false, value & 0xFFFFFFFF)


def _refuse(error: int) -> bytes:
    return _instruction(RETURN, REFUSE | error)


def _for_call(number: int, *then: bytes) -> list[bytes]:
    """Return the code for one system call; ``then`` has to return."""
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


def _if_any(argument: int, values: Iterable[int]) -> tuple[bytes, ...]:
    tests = [part for value in values for part in (_instruction(EQUAL, value, 0, 1), _refuse(errno.EPERM))]
    return (_argument(argument), *tests, _instruction(RETURN, ALLOW))


def _unless_own_limit_is_read() -> tuple[bytes, ...]:
    """Return the code that allows only prlimit64(0, resource, NULL, old): reading the own limits."""
    refuse = _refuse(errno.EPERM)
    tests = ((_argument(0), 5), (_argument(2), 3), (_argument(2, high=True), 1))
    code = [part for load, distance in tests for part in (load, _instruction(EQUAL, 0, 0, distance))]
    return (*code, _instruction(RETURN, ALLOW), refuse)


CREATE_RULESET, ADD_RULE, RESTRICT_SELF = 444, 445, 446  # same number on every processor
SCOPE_ABSTRACT_UNIX_SOCKET, SCOPE_SIGNAL = 1, 2
EXECUTE, WRITE_FILE, READ_FILE, READ_DIR = 1, 2, 4, 8
MAKE_CHAR, MAKE_SOCK, MAKE_BLOCK, REFER, TRUNCATE, IOCTL = 1 << 6, 1 << 9, 1 << 11, 1 << 13, 1 << 14, 1 << 15
FILE_RIGHTS = EXECUTE | WRITE_FILE | READ_FILE | TRUNCATE | IOCTL


def restrict_files(readable: Iterable[str], writable: Iterable[str]) -> bool:
    """Refuse, permanently, files outside these paths, and signals to others (Landlock)."""
    version = int(_library.syscall(CREATE_RULESET, None, ctypes.c_size_t(0), 1))
    if version < 1:
        return False
    handled = (1 << 13) - 1
    handled |= (REFER if version >= 2 else 0) | (TRUNCATE if version >= 3 else 0) | (IOCTL if version >= 5 else 0)
    network = struct.pack("<Q", 3) if version >= 4 else b""
    scoped = struct.pack("<Q", SCOPE_ABSTRACT_UNIX_SOCKET | SCOPE_SIGNAL) if version >= 6 else b""
    attributes = struct.pack("<Q", handled) + network + scoped
    rules = int(_library.syscall(CREATE_RULESET, attributes, ctypes.c_size_t(len(attributes)), 0))
    if rules < 0:
        return False
    for path in readable:
        _allow(rules, path, handled & (READ_FILE | READ_DIR | EXECUTE))
    for path in writable:
        _allow(rules, path, handled & ~(EXECUTE | MAKE_CHAR | MAKE_BLOCK | MAKE_SOCK | IOCTL))
    gain_no_privileges()
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


_INDEPENDENT = _independent(platform.machine())
"""Made once, and inherited by the processes that are forked after the import."""
