"""The texts of manuals and their indexes: files that are read and written, and what is wrong with them."""

from __future__ import annotations

from fieldspec.audit.manual_lines import NAME, ManualError, ManualIndex, index_of, index_text, parsed
from fieldspec.commands import regular_file, specs, storing
from fieldspec.commands.regular_file import SizeError
from fieldspec.commands.usage import UsageError
from fieldspec.model.device import Device

MOST_BYTES = 32 << 20
_LEAST_SHARE = 10
"""What a text has to have in common with the manual, in percent of the lines, to be compared with it at all."""


def recorded(given: str | None, device: str) -> ManualIndex | None:
    """The index beside the spec of a device, where there is one."""
    folder = specs.folder(given)
    path = folder / device / NAME
    try:
        text = regular_file.content(path, MOST_BYTES).decode("utf-8")
    except FileNotFoundError:
        return None
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "it is not UTF-8"
        raise UsageError(f"cannot read {path}: {reason}") from None
    shown = "/".join(filter(None, (specs.relative_path(folder), device, NAME)))
    try:
        return parsed(shown, text.replace("\r\n", "\n"))
    except ManualError as error:
        raise UsageError(f"{path} {error}") from None


def at_hand(name: str) -> ManualIndex:
    """The index of a manual's text that the user has."""
    try:
        content = regular_file.content(name, MOST_BYTES)
    except SizeError:
        raise UsageError(f"{name} has more than {MOST_BYTES >> 20} MiB; the text of a manual is smaller") from None
    except OSError as error:
        raise UsageError(f"cannot read {name}: {error.strerror}") from None
    try:
        return index_of(name, content)
    except ManualError as error:
        raise UsageError(f"{name} {error}") from None


def compared(given: str | None, device: str, name: str | None) -> tuple[ManualIndex | None, ManualIndex | None]:
    """The recorded index of a device's manual, and that of the text at hand.

    Raises UsageError for a text that has next to nothing in common with the manual.
    """
    index = recorded(given, device)
    manual = at_hand(name) if name else None
    if name and index is not None and manual is not None:
        have = {*manual.digests}
        whole = [digest for digest in index.digests if digest]
        same = sum(digest in have for digest in whole)
        if same * 100 < _LEAST_SHARE * len(whole):
            raise UsageError(
                f"{name} is not this manual: {same} of its {len(whole)} lines that are not empty are there; "
                "give the text from which the spec was transcribed, or another edition of it"
            )
    return index, manual


def record(given: str | None, device: Device, name: str | None) -> int:
    """Writes the index of a manual beside the spec of a device, which must be about that very text."""
    if not name:
        raise UsageError("give the text of the manual that is to be recorded: --manual FILE --record")
    manual, told = at_hand(name), device.manual
    if manual.sha256 != told.sha256 or len(manual.lines) != told.lines:
        raise UsageError(
            f"{name} is not the text that the spec cites; where the spec has been compared with it, "
            f"put its hash and its lines into the spec first: sha256: {manual.sha256}, lines: {len(manual.lines)}"
        )
    folder = specs.writable(given)
    storing.write(folder / device.id / NAME, index_text(manual, device.id).encode())
    shown = "/".join(filter(None, (specs.relative_path(folder), device.id, NAME)))
    print(f"wrote {shown}: {len(manual.lines)} lines")
    return 0
