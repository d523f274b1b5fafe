"""`fieldspec scan`: which addresses of a device answer, compared with every version of its spec."""

from __future__ import annotations

import argparse
import re
from collections.abc import Sequence

from fieldspec.codec.reference.records import CodecError
from fieldspec.command.console.streams import print_error, print_json
from fieldspec.command.console.terminal import print_blocks
from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.live.connection import begin, connected, unsent
from fieldspec.command.live.output import progress
from fieldspec.command.rendering.blocks import Line, Table
from fieldspec.command.sources import specs
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.tools.live.bases import located
from fieldspec.tools.live.client import Client, NoAnswerError, RefusedError
from fieldspec.tools.live.scanning import Scan, ScanSpace, compared, scan, scan_spaces, usual_ranges

if TYPE_CHECKING:
    from fieldspec.language.reading.device_spec import DeviceSpec

_RANGE = re.compile(r"(?:([a-z][a-z0-9_]*):)?(0x[0-9A-Fa-f]{1,8}|[0-9]{1,9})(?:\.\.(0x[0-9A-Fa-f]{1,8}|[0-9]{1,9}))?")


def run(arguments: argparse.Namespace) -> int:
    """Scans a device. Exit code 1 where it does not answer at all. Raises UsageError."""
    spec, version = specs.sound_at(arguments.specs, arguments.device)
    layout = specs.layout_of(spec, version)
    try:
        with connected(layout, arguments) as client:
            return scan_device(client, spec, arguments)
    except (NoAnswerError, RefusedError) as error:
        print_error(f"{layout.device.id}: {error}")
        return 1
    except CodecError as error:
        raise unsent(error) from None


def scan_device(client: Client, spec: DeviceSpec, arguments: argparse.Namespace) -> int:
    """Says what answers, what does not, and which version of the device it looks like. Raises UsageError."""
    layout = client.layout
    spaces = scan_spaces(layout, client.frames.link)
    plan = _plan(client, spaces, arguments.arguments)
    begin(client, arguments)
    with progress(sum(len(part) for _, ranges in plan for part in ranges), "scanning") as done:
        results = [scan(client, space, ranges, done) for space, ranges in plan]
    differences = {
        version: sum(compared(specs.layout_of(spec, version), result).differences for result in results)
        for version in spec.versions()
    }
    alike = [version for version, count in differences.items() if count == min(differences.values())]
    if arguments.format == "json":
        print_json(_data(client, results, differences, alike), indent=1)
    else:
        _print(client, results, differences, alike)
    return 0


def _plan(client: Client, spaces: Sequence[ScanSpace], texts: Sequence[str]) -> list[tuple[ScanSpace, list[range]]]:
    """The ranges to scan in each space; the usual ones of all spaces without any. Raises UsageError."""
    if not spaces:
        raise UsageError(f"no message of {client.frames.link.name} reads by an address or a number")
    if not texts:
        layout = located(client, client.layout)
        return [(space, ranges) for space in spaces if (ranges := usual_ranges(layout, space))]
    known = {space.name: space for space in spaces}
    plan: dict[str, list[range]] = {}
    for text in texts:
        match = _RANGE.fullmatch(text)
        name = match[1] if match and match[1] else spaces[0].name
        if name not in known and "" in known:
            raise UsageError(f"`{text}` names a space, and the device declares none: write the addresses alone")
        if name not in known:
            raise unknown("space", name, known)
        first, last = (int(match[2], 0), int(match[3] or match[2], 0)) if match else (1, 0)
        end = known[name].end
        if not 0 <= first <= last < end:
            raise UsageError(
                f"`{text}` is not an address range up to 0x{end - 1:04X}; write it as 0x1000..0x10FF or SPACE:0..255"
            )
        plan.setdefault(name, []).append(range(first, last + 1))
    return [(known[name], ranges) for name, ranges in plan.items()]


def _data(
    client: Client, results: Sequence[Scan], differences: dict[str, int], alike: Sequence[str]
) -> dict[str, object]:
    """A scan as evidence: the counts of what answers, and the addresses that do not, in each space."""
    spaces = []
    for result in results:
        own = compared(client.layout, result)
        spaces.append(
            {
                "space": result.space.name,
                "words": {f"0x{address:04X}": _counts(result.words[address]) for address in sorted(result.words)},
                "refused": [f"0x{address:04X}" for address in result.refused],
                "left_out": [f"0x{address:04X}" for address in sorted(result.left_out)],
                "unknown": [list(pair) for pair in own.unknown],
                "silent": list(own.silent),
            }
        )
    device = client.layout.device
    return {
        "device": device.id,
        "version": device.version,
        "spaces": spaces,
        "versions": differences,
        "looks_like": list(alike),
    }


def _counts(counts: Sequence[int]) -> int | list[int]:
    return counts[0] if len(counts) == 1 else list(counts)


def _print(client: Client, results: Sequence[Scan], differences: dict[str, int], alike: Sequence[str]) -> None:
    blocks: list[Line | Table] = []
    for result in results:
        own = compared(client.layout, result)
        space_text = f"{result.space.name or 'registers'}: " if len(results) > 1 else ""
        blocks.append(Line(f"{space_text}{len(result.words)} of {len(result.asked)} addresses answer"))
        if result.left_out:
            blocks.append(Line(f"{len(result.left_out)} addresses are left out, because reading changes them"))
        if own.unknown:
            rows = tuple((f"0x{a:04X}", f"0x{b:04X}", str(b - a + 1)) for a, b in own.unknown)
            blocks += [
                Line("These answer, and the spec does not have them:", "bold"),
                Table(("first", "last", "words"), rows),
            ]
        if own.silent:
            blocks += [Line("The spec has these, and they do not answer:", "bold"), Line(", ".join(own.silent))]
    if len(differences) > 1:
        blocks.append(Line(f"This unit looks like {' or '.join(alike)}."))
        counts = tuple((version, str(count)) for version, count in differences.items())
        blocks.append(Table(("version", "differences"), counts))
    print_blocks(blocks)
