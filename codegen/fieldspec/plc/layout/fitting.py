"""Whether an image is in memory what its record is on the wire, byte by byte."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.classes import dataclass
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.fact import Fact
from fieldspec.plc.layout.memory import Placed, PlacedMember
from fieldspec.plc.routines.expressions import Elementary, innermost

CONVERT = "convert the bytes by a function instead of laying a struct over them"
"""What to do without an image."""


@dataclass(frozen=True, slots=True)
class Misfit:
    """A difference between an image and the wire: the path of the member, the reason, and its fact."""

    path: str
    reason: str
    fact: Fact | None


def misfits(placed: Placed, before: str = "") -> Iterator[Misfit]:
    """The differences between an image and the wire in offsets and sizes; none where the image is exact."""
    for placed_member in placed.members:
        path = f"{before}{placed_member.member.name}"
        wire = placed_member.member.at
        bit = placed_member.member.bit
        if wire != placed_member.at or (placed_member.bit or 0) != bit:
            yield Misfit(
                path, f"begins at byte {placed_member.at}, on the wire at byte {wire}", placed_member.member.fact
            )
        if placed_member.inner is not None:
            yield from misfits(placed_member.inner, f"{path}.")
        if placed_member.inner is None and placed_member.count > 1 and placed_member.stride != placed_member.size:
            yield Misfit(
                path,
                f"has its elements {placed_member.stride} bytes apart, on the wire {placed_member.size}",
                placed_member.member.fact,
            )
    if placed.struct.size is not None and placed.size != placed.struct.size:
        path = before.rstrip(".") or placed.struct.name
        yield Misfit(path, f"has {placed.size} bytes, on the wire {placed.struct.size}", placed.struct.fact)


def direct(placed: Placed, placed_member: PlacedMember) -> bool:
    """Whether the controller reads a number as it lies there, with its own order of bytes."""
    kind = innermost(placed_member.member.type)
    if not isinstance(kind, Elementary) or kind.size < 2:
        return True
    return placed_member.member.order == placed.memory.order and not placed_member.member.swapped


def readable(placed: Placed) -> bool:
    """Whether an image is exact, and each number in it is one that the controller reads as it lies."""
    return not any(True for _ in misfits(placed)) and all(
        direct(placed, placed_member) for _, _, placed_member in placed.rows()
    )


def misfit_findings(placed: Placed) -> list[Diagnostic]:
    """The findings that forbid to take an image for what is on the wire."""
    findings = []
    for misfit in misfits(placed):
        fact = misfit.fact or placed.struct.fact
        if fact is not None:
            findings.append(
                Diagnostic(
                    "plc_images_exact",
                    f"in {placed.struct.key}, for {placed.memory.title}: {misfit.path} {misfit.reason}",
                    fact.place["name"],
                    help=CONVERT,
                )
            )
    return findings
