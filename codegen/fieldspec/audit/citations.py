"""Whether the lines that the spec cites hold what the facts say that they hold."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from fnmatch import fnmatchcase

from fieldspec.audit.agreement import byte_pairs, hold, in_order, numbers, readings, words
from fieldspec.audit.line_facts import lines_of
from fieldspec.audit.manual_lines import Aligned, index_line
from fieldspec.audit.plan import Plan, Unprinted
from fieldspec.checks.facts import facts
from fieldspec.checks.sources_present import cited_places
from fieldspec.classes import dataclass
from fieldspec.model.device import Device
from fieldspec.model.enums import Bit, Flags, Member
from fieldspec.model.fact import Citation, Fact, Place
from fieldspec.model.registers import Parameter, Register
from fieldspec.source import Span

NUMBERS = (
    "at",
    "decimal",
    "base",
    "value",
    "code",
    "refusal_code",
    "number",
    "wire_number",
    "bit",
    "bits",
    "word_span",
)
"""The keys of what is known by a number: each of them is printed where its fact is."""


_MOST_NUMBERS = {"elided": "frame"}
_FIGURES = re.compile(r"[0-9]+")


@dataclass(frozen=True, slots=True)
class Missing:
    """Something that the cited lines do not hold: the fact's path, what it is, and where the spec says it."""

    path: str
    what: str
    span: Span
    source: Citation


@dataclass(frozen=True, slots=True)
class Judged:
    """The citations that were looked up, those that fail, and exceptions that nothing needs.

    `numbered` are the facts that are known by a number, by path: where the spec says it, and where it is printed.
    """

    looked_up: int
    numbered: Mapping[str, tuple[Span, Citation]]
    missing: tuple[Missing, ...]
    excepted: int
    unused: tuple[Unprinted, ...]


@dataclass(frozen=True, slots=True)
class _Claimed:
    """What a fact, or another place that states it, says of itself, and where the manual prints it.

    `means` are the numbers that stand for it, whichever of them is printed.
    """

    path: str
    key: str
    text: str
    span: Span
    sources: tuple[Citation, ...]
    means: tuple[int, ...] = ()


def judged(devices: Sequence[Device], manual: Aligned, plan: Plan) -> Judged:
    """Looks up what the facts of a device at all its versions cite."""
    claims: dict[tuple[str, str, int], _Claimed] = {}
    corrected: dict[str, list[str]] = defaultdict(list)
    beside: dict[tuple[int, str], list[str]] = defaultdict(list)
    seen: set[int] = set()
    for device in devices:
        for claim in _claims(device, seen):
            claims.setdefault((claim.path, claim.key, claim.span.start), claim)
        for erratum in device.errata:
            if id(erratum) in seen:
                continue
            seen.add(id(erratum))
            corrected[erratum.fact] += [erratum.literal, *map(_put, erratum.printed.values())]
            for line in lines_of(erratum.sources):
                for key, printed in erratum.printed.items():
                    beside[line, key].append(_put(printed))
    looked_up, used, missing = 0, set(), []
    for claim in claims.values():
        also = [text for line in lines_of(claim.sources) for text in beside.get((line, claim.key), ())]
        found = [*_failing(claim, manual, plan, [*corrected.get(claim.path, ()), *also])]
        looked_up += 1
        for one in found:
            out = _excepted(plan, claim.path)
            if out is None:
                missing.append(one)
            else:
                used.add(id(out))
    missing += misplaced(devices, manual, plan)
    numbered: dict[str, tuple[Span, Citation]] = {}
    for claim in claims.values():
        if claim.key in NUMBERS:
            numbered.setdefault(claim.path.partition("/restated/")[0], (claim.span, claim.sources[0]))
    unused = tuple(one for one in plan.unprinted if id(one) not in used)
    excepted = sum(_excepted(plan, claim.path) is not None for claim in claims.values())
    return Judged(looked_up, numbered, tuple(missing), excepted, unused)


def misplaced(devices: Sequence[Device], manual: Aligned, plan: Plan) -> Iterator[Missing]:
    """Citations whose lines are blank at one of their ends, or lie in another section than the one that they name."""
    seen: set[tuple[str, Citation]] = set()
    for device in devices:
        for _, place, sources, _ in cited_places(device):
            key = "element_sources" if "element_sources" in place and "source" not in place else "source"
            if key not in place:
                continue  # the sources are those of what holds it
            for source in sources:
                if (place.path, source) not in seen:
                    seen.add((place.path, source))
                    yield from _misplaced(place, place[key], source, manual, plan)


def _misplaced(place: Place, span: Span, source: Citation, manual: Aligned, plan: Plan) -> Iterator[Missing]:
    for line in dict.fromkeys(line for interval in source.lines for line in interval):
        section = plan.section(line)
        if not manual.line(line):
            yield Missing(place.path, f"line {line}, on which nothing is printed", span, source)
        elif source.section and not _in_section(source.section, section):
            text = f"line {line}, which is in section {section or 'none'}, as one of section {source.section}"
            yield Missing(place.path, text, span, source)


def _put(printed: object) -> str:
    """What an erratum calls printed, as text; a number is put so that it has one reading."""
    whole = isinstance(printed, int) and not isinstance(printed, bool) and printed >= 0
    return f"0x{printed:X}" if whole else str(printed)


def _excepted(plan: Plan, path: str) -> Unprinted | None:
    return next((one for one in plan.unprinted if any(fnmatchcase(path, like) for like in one.facts)), None)


def _claims(device: Device, seen: set[int]) -> Iterator[_Claimed]:
    """What the facts of a device say of themselves, but for those that other versions share, which have been `seen`."""
    bases = {parameter.place.path: held.base for held in device.parameters.values() for parameter in held.parameters}
    for fact in facts(device):
        if id(fact) in seen:
            continue
        seen.add(id(fact))
        path, place = fact.place.path, fact.place
        if fact.sources:
            for key in NUMBERS:
                if key in place and not (key == "bits" and isinstance(fact, Flags)):
                    yield _Claimed(
                        path, key, _text(place[key]), place[key], fact.sources, _means(fact, key, bases.get(path, 0))
                    )
            if "printed_name" in place:
                yield _Claimed(path, "printed_name", fact.printed_name, place["printed_name"], fact.sources)
        for claim in fact.restated:
            for key in (*NUMBERS, "printed_name"):
                held = claim.values.get(key)
                if held is not None and claim.sources:
                    yield _Claimed(claim.place.path, key, str(held), claim.place[key], claim.sources)
        if isinstance(fact, Register):
            for number, source in enumerate(fact.element_sources):
                address = fact.address + number * fact.stride
                at = f"{path}/{fact.index_from + number}"
                yield _Claimed(at, "at", str(address), place["at"], (source,), (address,))
    for table in device.tables.values():
        for element in table.elements:
            address = table.address(element.index)
            place = element.place
            yield _Claimed(place.path, "at", str(address), place["at"], element.sources, (address,))
    for example in device.examples.values():
        if example.origin == "printed":
            key = "elided" if example.elided else "frame"
            span = example.place["frame"]
            yield _Claimed(example.place.path, key, example.frame.hex(" "), span, example.sources)
    for erratum in device.errata:
        if erratum.literal:
            yield _Claimed(erratum.place.path, "literal", erratum.literal, erratum.place["literal"], erratum.sources)


def _means(fact: Fact, key: str, base: int) -> tuple[int, ...]:
    """The numbers of a fact that may be printed for it, where they are not simply what the key says.

    A parameter has one in its set, and one on the wire, which is greater by `base`.
    """
    if isinstance(fact, Parameter) and key == "number":
        return fact.number, base + fact.number
    if isinstance(fact, Bit):
        return tuple(range(fact.first, fact.last + 1))
    return (fact.value,) if isinstance(fact, Member) and key == "value" else ()


def _text(span: Span) -> str:
    return span.file.text[span.start : span.end].strip("\"'")


def _failing(claim: _Claimed, manual: Aligned, plan: Plan, printed: list[str]) -> Iterator[Missing]:
    """What is wrong with a citation: the section, or that none of its lines hold what the fact says."""
    texts = [manual.line(line) for source in claim.sources for a, b in source.lines for line in range(a, b + 1)]
    if not _printed(claim, texts) and not any(_printed_as(text, claim, texts) for text in printed if text):
        yield Missing(
            claim.path, f"`{_MOST_NUMBERS.get(claim.key, claim.key)}` {claim.text}", claim.span, claim.sources[0]
        )


def _in_section(cited: str, section: str) -> bool:
    return cited == section or section.startswith(f"{cited}.") or cited.startswith(f"{section}.")


def _printed(claim: _Claimed, texts: list[str]) -> bool:
    """Whether lines hold what a fact says of itself, in any spelling."""
    if claim.key == "frame":
        return bytes.fromhex(claim.text) in bytes(pair for text in texts for pair in byte_pairs(text))
    if claim.key == "elided":
        return _elided(bytes.fromhex(claim.text), texts)
    if claim.key in ("printed_name", "literal"):
        return all(any(hold(text, word) for text in texts) for word in words(index_line(claim.text)))
    spelled: tuple[int | Decimal, ...] = claim.means or readings(claim.text, "number")
    if not spelled:
        bounds = [int(one) for one in _FIGURES.findall(claim.text)]
        return all(any(numbers(text).holds(bound) for text in texts) for bound in bounds)
    masks = [1 << int(bit) for bit in spelled if bit < 64] if claim.key in ("bit", "bits") else []
    wanted = (*spelled, *masks)
    return any(numbers(text).holds(one) for text in texts for one in wanted)


def _elided(frame: bytes, texts: list[str]) -> bool:
    """Whether the bytes in some lines are those of a frame, in their order, with some left out."""
    printed = bytes(pair for text in texts for pair in byte_pairs(text))
    return bool(printed) and in_order(printed, frame)


def _printed_as(printed: str, claim: _Claimed, texts: list[str]) -> bool:
    """Whether lines hold what an erratum calls the print of a fact."""
    if claim.key == "elided":
        return _elided(bytes(byte_pairs(printed)), texts)
    if claim.key == "frame":
        return bytes(byte_pairs(printed)) in bytes(pair for text in texts for pair in byte_pairs(text))
    have = {word for text in texts for word in words(text)}
    said = words(index_line(printed))
    if said and set(said) <= have:
        return True
    values = numbers(index_line(printed)).values
    return bool(values) and all(any(numbers(text).holds(value) for text in texts) for value in values)
