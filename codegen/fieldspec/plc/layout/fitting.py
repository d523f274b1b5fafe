"""Whether an image is in memory what its record is on the wire, byte by byte."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.classes import dataclass
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.fact import Fact
from fieldspec.plc.layout.memory import Placed, PlacedMember
from fieldspec.plc.routines.expressions import Elementary, innermost


@dataclass(frozen=True, slots=True)
class Misfit:
    """Where an image differs from the wire: what of it, why, and the fact that says where it lies."""

    path: str
    reason: str
    fact: Fact | None


def misfits(placed: Placed, before: str = "") -> Iterator[Misfit]:
    """All differences of places and sizes; none where the image is exact."""
    for one in placed.members:
        path = f"{before}{one.member.name}"
        wire = one.member.at
        bit = one.member.bit
        if wire != one.at or (one.bit or 0) != bit:
            yield Misfit(path, f"begins at byte {one.at}, on the wire at byte {wire}", one.member.fact)
        if one.inner is not None:
            yield from misfits(one.inner, f"{path}.")
        if one.inner is None and one.count > 1 and one.stride != one.size:
            yield Misfit(path, f"has its elements {one.stride} bytes apart, on the wire {one.size}", one.member.fact)
    if placed.struct.size is not None and placed.size != placed.struct.size:
        path = before.rstrip(".") or placed.struct.name
        yield Misfit(path, f"has {placed.size} bytes, on the wire {placed.struct.size}", placed.struct.fact)


def direct(placed: Placed, one: PlacedMember) -> bool:
    """Whether the controller reads a number as it lies there, with its own order of bytes."""
    kind = innermost(one.member.type)
    if not isinstance(kind, Elementary) or kind.size < 2:
        return True
    return one.member.order == placed.memory.order and not one.member.swapped


def readable(placed: Placed) -> bool:
    """Whether an image is exact, and each number in it is one that the controller reads as it lies."""
    return not any(True for _ in misfits(placed)) and all(direct(placed, one) for _, _, one in placed.rows())


def misfit_findings(placed: Placed) -> list[Diagnostic]:
    """The findings that forbid to take an image for what is on the wire."""
    made = []
    for one in misfits(placed):
        fact = one.fact or placed.struct.fact
        if fact is not None:
            made.append(
                Diagnostic(
                    "plc_images_exact",
                    f"in {placed.struct.key}, for {placed.memory.title}: {one.path} {one.reason}",
                    fact.place["name"],
                    help="convert the bytes by a function instead of laying the struct over them",
                )
            )
    return made
