"""The errata that rows cite, and citations of the manual."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable

from fieldspec.foundation.caches import ByIdentity
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Citation
from fieldspec.language.model.link import Link
from fieldspec.language.model.record import Message
from fieldspec.language.model.texts import Erratum


def citations(sources: Iterable[Citation]) -> str:
    """`8.2 L1622; 9.1 L5`"""
    return "; ".join([citation.text() for citation in sources])


class _Errata:
    """The errata of one device, indexed by the paths that they are about, as every row looks them up."""

    def __init__(self, errata: tuple[Erratum, ...]) -> None:
        self.within: dict[str, list[str]] = {}
        self.of: dict[str, list[tuple[int, str]]] = {}
        for number, erratum in enumerate(errata):
            for path in (erratum.fact, *(erratum.fact[: slash.start()] for slash in re.finditer("/", erratum.fact))):
                self.within.setdefault(path, []).append(erratum.id)
            for path in {erratum.fact, erratum.fact.partition("/restated/")[0]}:
                self.of.setdefault(path, []).append((number, erratum.id))


_ERRATA: ByIdentity[tuple[Erratum, ...], _Errata] = ByIdentity(limit=8)
"""One device is explained at a time, with some of its other versions."""


def _errata(device: Device) -> _Errata:
    return _ERRATA.get_or_compute(device.errata, _Errata)


def errata_at(device: Device, path: str) -> tuple[str, ...]:
    """The ids of the errata of a fact and of the facts below it."""
    return tuple(_errata(device).within.get(path, ()))


def concerns_link(device: Device, erratum: Erratum, link: Link) -> bool:
    """Whether an erratum is about frames of a link, and not only about another one.

    An erratum of a fact that links share concerns the links whose facts cite one of its sections.
    """
    root, _, path = erratum.fact.partition("/")
    if root == "links":
        return path.partition("/")[0] == link.name
    sections = {source.section for source in erratum.sources}
    foreign = {section for own in device.links.values() if own.name != link.name for section in _sections(own)}
    return not sections <= foreign - _sections(link)


def _sections(link: Link) -> set[str]:
    """The sections of the manual that a link and its parts cite."""
    facts = (link, *link.request, *link.response)
    return {source.section for fact in facts for source in fact.sources}


def errata_of_message(device: Device, message: Message) -> tuple[str, ...]:
    """The ids of the errata of a message, without the errata of its fields."""
    path = message.place.path
    errata = errata_at(device, path)
    if not errata:
        return ()
    fields = (f"{path}/request/", f"{path}/response/")
    of_fields = {erratum.id for erratum in device.errata if erratum.fact.startswith(fields)}
    return tuple(erratum for erratum in errata if erratum not in of_fields)


def errata_of_words(device: Device, facts: Collection[str]) -> tuple[str, ...]:
    """The ids of the errata of enums, members and flags that gave a value its meaning, without errata of
    other members.
    """
    if not facts:
        return ()
    errata_by_fact = _errata(device).of
    return tuple(name for _, name in sorted({erratum for fact in facts for erratum in errata_by_fact.get(fact, ())}))
