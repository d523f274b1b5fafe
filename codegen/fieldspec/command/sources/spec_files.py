"""Finds the folder with the specs and reads its files, without importing the compiler, which would take time."""

from __future__ import annotations

import os
import re

import fieldspec
from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.files import cache_folder
from fieldspec.command.files.regular_file import NO_LINK, IrregularError, SizeError, content, reading
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.foundation.source import Refused
from fieldspec.language.reading.findings import LARGEST_FILE, LARGEST_FOLDER, MAIN, MOST_FILES, PROTOCOLS, VERSIONS

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

FOLDER = "specs"
VARIABLE = "FIELDSPEC_SPECS"
INDEX = "manual.index"
"""The file of a device with the index of its manual, for audits."""

_PACKAGE = os.path.dirname(os.path.realpath(fieldspec.__file__))
INSTALLED = os.path.join(_PACKAGE, "_specs")
"""The specs in an installation of fieldspec. They are never written."""
_CHECKOUT = os.path.join(os.path.dirname(os.path.dirname(_PACKAGE)), FOLDER)
"""The same specs in a source checkout."""

_USE = re.compile(
    rb"""protocol["']?(?:\s|\#.*\n){0,999}:(?:\s|\#.*\n){0,999}  # the key, and comments before its value
    ["']?([A-Za-z0-9][A-Za-z0-9_-]*)(?![A-Za-z0-9_-]|["']?\s*:)  # the name, which is not a key itself""",
    re.VERBOSE,
)
"""What may be the use of a protocol. It is found without a YAML reader, which `decode` does not load."""


def writable_folder(specs_option: str | None) -> str:
    """The folder with the specs, for a verb that writes there. Raises UsageError for the installed specs."""
    path = folder(specs_option)
    if path == INSTALLED:
        raise UsageError(
            f"the installed specs of fieldspec are not changed; copy {INSTALLED} to a folder {FOLDER} of your own"
        )
    return path


def folder(specs_option: str | None) -> str:
    """The folder with the specs: by option, by environment, here or above, or installed. Raises UsageError."""
    path = folder_or_none(specs_option)
    if path is None:
        raise UsageError(
            f"there is no folder {FOLDER} here or in a parent folder; name it with --specs, or set {VARIABLE}"
        )
    return path


def folder_or_none(specs_option: str | None) -> str | None:
    """As `folder`, but None where there is none. Raises UsageError where the named one is missing."""
    stated_folder = specs_option or os.environ.get(VARIABLE)
    if stated_folder:
        if not os.path.isdir(stated_folder):
            raise UsageError(f"there is no folder {stated_folder}; name the folder with the specs with --specs")
        return stated_folder
    above, last = os.getcwd(), ""
    while above != last:
        path = os.path.join(above, FOLDER)
        if devices(path):
            return path
        above, last = os.path.dirname(above), above
    if os.path.isdir(INSTALLED):
        return INSTALLED
    return None


def devices(path: str | os.PathLike[str]) -> list[str]:
    """The devices in a folder of specs: the folders that contain the main file of a device."""
    try:
        return sorted(name for name in _names(path) if os.path.lexists(os.path.join(path, name, MAIN)))
    except OSError:  # which nobody may look into
        return []


def files(path: str | os.PathLike[str], only: frozenset[str] = frozenset()) -> dict[str, bytes]:
    """The spec files below a folder by relative path, of all devices or of `only` some. Raises UsageError.

    A file that is not regular, outside the folder or too large is not read; a `Refused` takes its place.
    """
    contents: dict[str, bytes] = {}
    try:
        for device in sorted(_names(path)):
            if only and device not in only and device != PROTOCOLS:
                continue
            left = LARGEST_FOLDER
            for number, (inner, file, linked) in enumerate(sorted(_of_specs(os.path.join(path, device)))):
                content = _content(path, file, linked, left, number)
                left -= 0 if isinstance(content, Refused) else len(content)
                contents[f"{device}/{inner}"] = content
                if number == MOST_FILES:
                    break
    except OSError as error:
        raise UsageError(f"cannot read {error.filename}: {error.strerror}") from None
    return contents


def _content(root: str | os.PathLike[str], path: str, linked: bool, left: int, number: int) -> bytes:
    """The bytes of a spec file, or a `Refused`; `left` is the number of bytes that the folder may still have."""
    limit = min(left, LARGEST_FILE)
    if number >= MOST_FILES:
        return Refused.because("file_too_large", f"the folder has more than {MOST_FILES} files", "remove some of them")
    try:
        if linked and _leads_out(root, path):
            return Refused.because("file_regular", "the file is a link out of the folder of the specs", _COPY)
        return content(path, limit, 0 if linked else NO_LINK)
    except SizeError as error:
        if limit < LARGEST_FILE:
            text = f"the files of this folder have more than {LARGEST_FOLDER} bytes together"
            return Refused.because("file_too_large", text, "remove some of them")
        text = f"the file has {error.size} bytes; a spec file may have {LARGEST_FILE}"
        return Refused.because("file_too_large", text, "split it over several files")
    except IrregularError as error:
        return Refused.because("file_regular", f"the file cannot be read: {error.strerror}", _COPY)
    except FileNotFoundError:
        return Refused.because("file_regular", "the file is a broken link", _COPY)


_COPY = "replace it by a regular file"


def _leads_out(root: str | os.PathLike[str], path: str) -> bool:
    """Whether a symbolic link on the path of a file leads out of the folder with the specs."""
    return not os.path.realpath(path).startswith(os.path.join(os.path.realpath(root), ""))


def _of_specs(path: str) -> Iterator[tuple[str, str, bool]]:
    """The spec files in the folder of a device, and the index of its manual.

    Each is its path within the folder, the path to open, and whether there is a symbolic link on the way.
    """
    is_linked = os.path.islink(path)
    for folder in ("", VERSIONS):
        inner = os.path.join(path, folder)
        linked = is_linked or (folder != "" and os.path.islink(inner))
        try:
            with os.scandir(inner) as entries:
                for entry in entries:
                    name = entry.name
                    hidden = name.startswith(".")  # left by editors beside a file
                    if not hidden and (name.endswith(".yaml") or (name == INDEX and not folder)):
                        yield f"{folder}/{name}" if folder else name, entry.path, linked or entry.is_symlink()
        except (FileNotFoundError, NotADirectoryError):
            continue


def _names(path: str | os.PathLike[str]) -> list[str]:
    """The names in a folder; none where there is no such folder."""
    try:
        return os.listdir(path)
    except (FileNotFoundError, NotADirectoryError):
        return []


class InstalledFile(bytes):
    """The content of a protocol that is not among the specs, with the path that it was read from."""

    path: str


def with_protocols(files: Mapping[str, bytes]) -> dict[str, bytes]:
    """Spec files, with the files of used protocols that they lack: fieldspec's own and the plug-ins' protocols.

    Raises UsageError for a broken plug-in.
    """
    complete = dict(files)
    waiting = list(files)
    available: dict[str, str] | None = None
    for path in waiting:
        for name in _uses(complete[path]):
            key = f"{PROTOCOLS}/{name}.yaml"
            if key in complete:
                continue
            available = installed_protocols() if available is None else available
            if name in available:
                complete[key] = _installed_file(available[name])
                waiting.append(key)
    return complete


def origins(files: Mapping[str, bytes]) -> dict[str, str]:
    """Where the files were read from that are not in the folder of the specs."""
    return {path: data.path for path, data in files.items() if isinstance(data, InstalledFile)}


def _uses(data: bytes) -> Iterator[str]:
    """The names of protocols that a spec file may use."""
    offset = data.find(b"protocol")
    while offset >= 0:
        if match := _USE.match(data, offset):
            yield match[1].decode()
        offset = data.find(b"protocol", offset + 1)


def installed_protocols() -> dict[str, str]:
    """The files of the installed protocols, by name: fieldspec's own and the plug-ins' protocols."""
    from fieldspec.command.packages.plugins import protocol_paths

    own = bundled_protocols()
    return protocol_paths(own) | own


def bundled_protocols() -> dict[str, str]:
    """The files of fieldspec's own protocols, by name; of an installation, or of a source checkout."""
    folder = os.path.join(INSTALLED if os.path.isdir(INSTALLED) else _CHECKOUT, PROTOCOLS)
    names = sorted(name for name in _names(folder) if name.endswith(".yaml") and not name.startswith("."))
    return {name.removesuffix(".yaml"): os.path.join(folder, name) for name in names}


def _installed_file(path: str) -> bytes:
    with reading(path):
        file = InstalledFile(content(path, LARGEST_FILE))
    file.path = path.replace(os.sep, "/")
    return file


def of_devices(specs_option: str | None, requested: frozenset[str] = frozenset()) -> tuple[str, dict[str, bytes]]:
    """The folder with the specs, its files, and the files of installed protocols. Raises UsageError for
    unknown ones.
    """
    path = folder(specs_option)
    known = devices(path)
    for device in sorted(requested.difference(known)):
        error = unknown("device", device, known)
        raise UsageError(f"{error}{_passed_over(specs_option, path)}")
    if not known:
        raise UsageError(f"the folder {path} contains no device; a device is a folder with a {MAIN}")
    return path, with_protocols(files(path, requested))


def _passed_over(specs_option: str | None, path: str) -> str:
    """What to say of a folder `specs` here that has no device, so that the specs of another folder are read."""
    local_folder = os.path.join(os.getcwd(), FOLDER)
    if (
        specs_option
        or os.environ.get(VARIABLE)
        or not os.path.isdir(local_folder)
        or os.path.realpath(local_folder) == os.path.realpath(path)
    ):
        return ""
    return f"; these are the specs of {path}, as {FOLDER} here has no device"


def relative_path(path: str | os.PathLike[str]) -> str:
    """The folder as findings show it: relative to the current one, so that editors find the files."""
    text, current_folder = os.path.realpath(path), os.getcwd()
    if text == current_folder:
        return ""
    text = (
        text[len(current_folder) :].lstrip(os.sep)
        if text.startswith(os.path.join(current_folder, ""))
        else os.fspath(path)
    )
    return text.replace(os.sep, "/")


def split(text: str) -> tuple[str, str]:
    """`drive@2.0` as device and version; the version is empty in `drive`."""
    device, _, version = text.partition("@")
    return device, version


def is_own(specs_option: str | None) -> bool:
    """Whether specs are read from a folder of the user. Raises UsageError where there is none."""
    return folder(specs_option) != INSTALLED


def entry_key(text: str, files: dict[str, bytes]) -> str:
    """The key of what is computed from `DEVICE[@VERSION]`; empty where the files of the compiler cannot be read."""
    try:
        named_contents = [part for path, content in files.items() for part in (os.fsencode(path), content)]
        return cache_folder.checksum(cache_folder.state().encode(), os.fsencode(text), *named_contents)
    except OSError:
        return ""
