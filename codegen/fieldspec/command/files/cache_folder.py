"""The cache folder, and the hash of the compiler that its entries depend on."""

from __future__ import annotations

import os
import re
import stat
import sys
from contextlib import suppress
from importlib.machinery import PathFinder

import fieldspec
from fieldspec.command.console.streams import print_error
from fieldspec.foundation.classes import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence


# A file in the cache begins with the hash of its content: one that is half written, or changed by hand, is ignored, and
# so is one that another user owns or could write to. The content is never executed, but for compiled
# templates. Where the folder cannot be written to, nothing is cached. Only files with names of the cache are ever
# removed, and only in a folder that carries its tag.

try:
    from _blake2 import blake2b  # `hashlib` loads OpenSSL first, which takes as long as to read a compiled device
except ImportError:
    from hashlib import blake2b

VARIABLE = "FIELDSPEC_CACHE"
MOST = 100
"""The most files of one kind in the cache; older ones are removed."""


def folder() -> str:
    """The folder: FIELDSPEC_CACHE, or where the system keeps caches. Raises OSError for a user without a home."""
    if stated_folder := os.environ.get(VARIABLE):
        return stated_folder.rstrip(os.sep) or stated_folder  # after a link, a separator would lead to its target
    home = os.path.expanduser("~")
    if home == "~":
        raise FileNotFoundError("this user has no home")
    if sys.platform == "win32":
        local = os.environ.get("LOCALAPPDATA") or os.path.join(home, "AppData", "Local")
        return os.path.join(local, "fieldspec", "cache")
    return os.path.join(os.environ.get("XDG_CACHE_HOME") or os.path.join(home, ".cache"), "fieldspec")


def checksum(*contents: bytes) -> str:
    """A hash of contents in their order, and of their sizes."""
    hasher = blake2b(digest_size=24)
    for content in contents:
        hasher.update(b"%d\n" % len(content))
        hasher.update(content)
    return hasher.hexdigest()


def cached(kind: str, name: str) -> bytes | None:
    """The content stored under a name; None where there is none, or where it is damaged."""
    try:
        expected, _, content = _content(_path(kind, name)).partition(b"\n")
    except OSError:
        return None
    return content if expected == checksum(content).encode() else None


def _content(path: str) -> bytes:
    """The bytes of a file; none where it does not exist, or where others may have written it. Raises OSError."""
    try:
        number = os.open(path, _READ)
    except FileNotFoundError:
        return b""
    try:
        state = os.fstat(number)
        if not _ours(state):
            return b""
        with open(number, "rb", closefd=False) as file:
            return file.read(state.st_size + 1)
    finally:
        os.close(number)


def store(kind: str, name: str, content: bytes) -> None:
    """Stores a content under a name, replacing an earlier one. Does nothing where that is not possible.

    Says once where it refuses a folder that is not the cache's own.
    """
    if not is_usable(kind):
        return
    with suppress(OSError):
        _write(_path(kind, name), checksum(content).encode() + b"\n" + content)


_refused: set[str] = set()
"""The folders that the user has been told of."""


def is_usable(kind: str) -> bool:
    """Whether a kind of files can be cached: creates its folder, and the tag of the whole cache."""
    try:
        root = folder()
        path = os.path.join(root, kind)
        reason = _foreign(root) or _untagged(root)
        if not reason:
            root = path
            reason = _foreign(path)
    except OSError:
        return False
    if reason and root not in _refused:
        _refused.add(root)
        print_error(f"nothing is cached in {root}: {reason}; set {VARIABLE} to a folder that is empty or new")
    return not reason


def _foreign(path: str) -> str:
    """Why a folder, which is created where it is absent, is not the user's own; empty where it is. Raises OSError."""
    with suppress(FileExistsError):
        os.makedirs(path, mode=0o700)
    state = os.lstat(path)
    if stat.S_ISLNK(state.st_mode) or (hasattr(os.path, "isjunction") and os.path.isjunction(path)):
        return "it is a link"
    if not stat.S_ISDIR(state.st_mode):
        raise NotADirectoryError(path)
    return "it belongs to another user" if os.name == "posix" and state.st_uid != os.geteuid() else ""


TAG = "CACHEDIR.TAG"
_TAG_TEXT = b"""Signature: 8a477f597d28d172789f06886806bc55
# This folder is a cache of fieldspec, which removes files from it. See https://bford.info/cachedir/
"""


def _untagged(root: str) -> str:
    """Why a folder does not carry the tag of the cache; empty where it does, and in a new one. Raises OSError."""
    path = os.path.join(root, TAG)
    if _content(path) == _TAG_TEXT:
        return ""
    from fieldspec.command.files.storage import lock, unlock, write_through

    number = lock(root, patient=False)
    try:
        if _content(path) == _TAG_TEXT:  # another process has written it and cached something
            return ""
        # Where nobody names another folder, it is that of an earlier fieldspec, which wrote no tag.
        if os.environ.get(VARIABLE) and {*os.listdir(root)} - {TAG}:
            return f"it has files and no {TAG} of fieldspec"
        write_through(path, _TAG_TEXT, 0o644)
    finally:
        unlock(number)
    return ""


_READ = os.O_RDONLY | getattr(os, "O_BINARY", 0) | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0)
_LARGEST = 1 << 30
_BESIDE = ".new"
_ENTRY = re.compile("[0-9a-f]{32}")
_UNFINISHED = re.compile("[0-9a-f]{32}" + re.escape(_BESIDE))


def _write(path: str, content: bytes) -> None:
    """Writes a file all or nothing, one process at a time, and removes what is too much. Raises OSError."""
    from fieldspec.command.files.storage import lock, unlock, write_through

    folder_path = os.path.dirname(path)
    number = lock(folder_path, patient=False)
    try:
        for entry in _files_named(folder_path, _UNFINISHED):  # left by a process that was killed while it wrote
            os.unlink(entry)
        try:
            write_through(path + _BESIDE, content, 0o600)
            os.replace(path + _BESIDE, path)
        except BaseException:
            with suppress(OSError):
                os.unlink(path + _BESIDE)
            raise
        files = sorted(_files_named(folder_path, _ENTRY), key=lambda entry: entry.stat().st_mtime_ns)
        for old in files[:-MOST]:
            os.unlink(old)
    finally:
        unlock(number)


def _files_named(folder: str, pattern: re.Pattern[str]) -> list[os.DirEntry[str]]:
    """The regular files of a folder whose names the cache could have written. Raises OSError."""
    with os.scandir(folder) as entries:
        return [entry for entry in entries if pattern.fullmatch(entry.name) and entry.is_file(follow_symlinks=False)]


def _ours(state: os.stat_result) -> bool:
    """Whether a file is regular, not too large, and writable only by its owner."""
    if not stat.S_ISREG(state.st_mode) or state.st_size > _LARGEST:
        return False
    if os.name != "posix":
        return True
    return state.st_uid == os.geteuid() and not state.st_mode & (stat.S_IWGRP | stat.S_IWOTH)


def _path(kind: str, name: str) -> str:
    return os.path.join(folder(), kind, checksum(name.encode("utf-8", "surrogateescape"))[:32])


LIBRARIES = {
    "construct": "construct",
    "jinja2": "jinja2",
    "jsonschema_rs": "jsonschema_rs",
    "markupsafe": "markupsafe",
    "openpyxl": "openpyxl",
    "xlsxwriter": "xlsxwriter",
    "yaml": "pyyaml",
}
"""The libraries that outputs and findings depend on: the module, and the name of the distribution."""


LAYING_OUT = ("foundation", "language", "codec", "tools/proofs", "command/sources")
"""The parts of the compiler that judge specs and turn them into a layout."""
WHOLE = ("",)
"""All of the compiler."""

_PACKAGE = os.path.dirname(os.path.realpath(fieldspec.__file__))
_OTHERS = ("__pycache__", "_specs")
"""Folders of the package that do not belong to the compiler."""


def identity() -> str:
    """A hash of every file of the compiler, of the versions of its libraries, and of Python.

    Files are taken as they are on disk now. Raises OSError where they cannot be read.
    """
    contents = [_python()]
    for path in _files(_PACKAGE):
        with open(path, "rb") as file:
            contents += [os.path.relpath(path, _PACKAGE).encode(), file.read()]
    contents += [f"{module} {_version(module, distribution)}".encode() for module, distribution in LIBRARIES.items()]
    return checksum(*contents)


def state(parts: Sequence[str] = LAYING_OUT) -> str:
    """A hash of the names, sizes and times of some files of the compiler, of the folders of libraries, and of Python.

    It changes whenever one of them does, and takes a tenth of the time of `identity`; it also changes when files are
    only copied. Raises OSError where they cannot be read.
    """
    lines: list[str] = []
    for name in parts:
        path = os.path.join(_PACKAGE, name)
        lines += _states(path, name) if os.path.isdir(path) else [_state(name, os.stat(path))]
    for folder in sys.path[1:]:  # the first is that of the script, or the current one
        if os.path.isdir(folder):
            lines.append(f"{folder} {os.stat(folder).st_mtime_ns}")
    return checksum(_python(), "\n".join(lines).encode("utf-8", "surrogateescape"))


def _python() -> bytes:
    return f"{sys.version} {sys.flags.optimize}".encode()


def _states(folder: str, prefix: str) -> Iterator[str]:
    with os.scandir(folder) as entries:
        for entry in sorted(entries, key=lambda entry: entry.name):
            if entry.is_dir():
                if entry.name not in _OTHERS:
                    yield from _states(entry.path, f"{prefix}/{entry.name}")
            else:
                yield _state(f"{prefix}/{entry.name}", entry.stat())


def _state(name: str, status: os.stat_result) -> str:
    return f"{name} {status.st_size} {status.st_mtime_ns} {status.st_ctime_ns} {status.st_ino}"


def _files(package: str) -> list[str]:
    """All files of the compiler, without compiled ones, in order."""
    paths = []
    for folder, inner, names in os.walk(package, onerror=_raised):
        inner[:] = sorted(name for name in inner if name not in _OTHERS)
        paths += [os.path.join(folder, name) for name in sorted(names) if not name.endswith((".pyc", ".pyo"))]
    return paths


def _raised(error: OSError) -> None:
    raise error


def _version(module: str, distribution: str) -> str:
    """The version of a library: the name of its metadata folder, or else a hash of its first file."""
    spec = PathFinder.find_spec(module)
    if spec is None or not spec.origin:
        return ""
    parent, name = os.path.split(spec.origin)
    parent = os.path.dirname(parent) if name.startswith("__init__.") else parent
    for name in sorted(os.listdir(parent)):
        lower_name = name.lower().replace("-", "_")
        if lower_name.startswith(f"{distribution}_") and lower_name.endswith("_info"):
            return name
    with open(spec.origin, "rb") as file:
        return checksum(file.read())
