"""Whether the cited lines print the addresses, codes and identifiers of the facts that cite them."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from fnmatch import fnmatchcase

from fieldspec.audit.agreement import byte_pairs, has_word, in_order, numbers, readings, words
from fieldspec.audit.line_facts import lines_of
from fieldspec.audit.manual_lines import AlignedManual, index_line
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
"""The keys of numbers that identify a fact: the manual prints them on the lines of the fact."""

_SPEC_KEYS = {"elided": "frame"}
"""The keys of a spec for those of claims, where they differ."""
_FIGURES = re.compile(r"[0-9]+")


@dataclass(frozen=True, slots=True)
class Missing:
    """A claim that the cited lines do not print: the path of the fact, the claim, and its place in the spec."""

    path: str
    what: str
    span: Span
    source: Citation


@dataclass(frozen=True, slots=True)
class CitationResults:
    """How many claims were looked up, which ones fail, how many are excepted, and the exceptions without use.

    `numbered` are the facts with an identifying number, by path: its place in the spec, and its place in the manual.
    """

    looked_up: int
    numbered: Mapping[str, tuple[Span, Citation]]
    missing: tuple[Missing, ...]
    excepted: int
    unused: tuple[Unprinted, ...]


@dataclass(frozen=True, slots=True)
class _Claim:
    """A key of a fact, or of another place that states it, with its text and the lines that should print it.

    `means` are the numbers of which the manual may print any.
    """

    path: str
    key: str
    text: str
    span: Span
    sources: tuple[Citation, ...]
    means: tuple[int, ...] = ()


def citation_results(devices: Sequence[Device], manual: AlignedManual, plan: Plan) -> CitationResults:
    """Looks up the claims of all facts of all versions of a device on the lines that they cite."""
    claims: dict[tuple[str, str, int], _Claim] = {}
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
            corrected[erratum.fact] += [erratum.literal, *map(_printed_text, erratum.printed.values())]
            for line in lines_of(erratum.sources):
                for key, printed in erratum.printed.items():
                    beside[line, key].append(_printed_text(printed))
    looked_up, used, missing = 0, set(), []
    for claim in claims.values():
        also = [text for line in lines_of(claim.sources) for text in beside.get((line, claim.key), ())]
        failing = [*_failing(claim, manual, plan, [*corrected.get(claim.path, ()), *also])]
        looked_up += 1
        for failure in failing:
            out = _excepted(plan, claim.path)
            if out is None:
                missing.append(failure)
            else:
                used.add(id(out))
    missing += misplaced(devices, manual, plan)
    numbered: dict[str, tuple[Span, Citation]] = {}
    for claim in claims.values():
        if claim.key in NUMBERS:
            numbered.setdefault(claim.path.partition("/restated/")[0], (claim.span, claim.sources[0]))
    unused = tuple(entry for entry in plan.unprinted if id(entry) not in used)
    excepted = sum(_excepted(plan, claim.path) is not None for claim in claims.values())
    return CitationResults(looked_up, numbered, tuple(missing), excepted, unused)


def misplaced(devices: Sequence[Device], manual: AlignedManual, plan: Plan) -> Iterator[Missing]:
    """Citations that begin or end with a blank line, or have lines outside the section that they name."""
    seen: set[tuple[str, Citation]] = set()
    for device in devices:
        for _, place, sources, _ in cited_places(device):
            key = "element_sources" if "element_sources" in place and "source" not in place else "source"
            if key not in place:
                continue  # the fact inherits its sources
            for source in sources:
                if (place.path, source) not in seen:
                    seen.add((place.path, source))
                    yield from _misplaced(place, place[key], source, manual, plan)


def _misplaced(place: Place, span: Span, source: Citation, manual: AlignedManual, plan: Plan) -> Iterator[Missing]:
    for line in dict.fromkeys(line for interval in source.lines for line in interval):
        section = plan.section(line)
        if not manual.line(line):
            yield Missing(place.path, f"line {line}, on which nothing is printed", span, source)
        elif source.section and not _in_section(source.section, section):
            text = f"line {line}, which is in section {section or 'none'}, as one of section {source.section}"
            yield Missing(place.path, text, span, source)


def _printed_text(printed: object) -> str:
    """A printed value of an erratum as text; a number in a form with a single reading."""
    whole = isinstance(printed, int) and not isinstance(printed, bool) and printed >= 0
    return f"0x{printed:X}" if whole else str(printed)


def _excepted(plan: Plan, path: str) -> Unprinted | None:
    return next((entry for entry in plan.unprinted if any(fnmatchcase(path, like) for like in entry.facts)), None)


def _claims(device: Device, seen: set[int]) -> Iterator[_Claim]:
    """The claims of the facts of a device, without facts that are `seen` already, as versions share facts."""
    bases = {
        parameter.place.path: parameter_set.base
        for parameter_set in device.parameters.values()
        for parameter in parameter_set.parameters
    }
    for fact in facts(device):
        if id(fact) in seen:
            continue
        seen.add(id(fact))
        path, place = fact.place.path, fact.place
        if fact.sources:
            for key in NUMBERS:
                if key in place and not (key == "bits" and isinstance(fact, Flags)):
                    yield _Claim(
                        path, key, _text(place[key]), place[key], fact.sources, _means(fact, key, bases.get(path, 0))
                    )
            if "printed_name" in place:
                yield _Claim(path, "printed_name", fact.printed_name, place["printed_name"], fact.sources)
        for claim in fact.restated:
            for key in (*NUMBERS, "printed_name"):
                value = claim.values.get(key)
                if value is not None and claim.sources:
                    yield _Claim(claim.place.path, key, str(value), claim.place[key], claim.sources)
        if isinstance(fact, Register):
            for number, source in enumerate(fact.element_sources):
                address = fact.address + number * fact.stride
                at = f"{path}/{fact.index_from + number}"
                yield _Claim(at, "at", str(address), place["at"], (source,), (address,))
    for table in device.tables.values():
        for element in table.elements:
            address = table.address(element.index)
            place = element.place
            yield _Claim(place.path, "at", str(address), place["at"], element.sources, (address,))
    for example in device.examples.values():
        if example.origin == "printed":
            key = "elided" if example.elided else "frame"
            span = example.place["frame"]
            yield _Claim(example.place.path, key, example.frame.hex(" "), span, example.sources)
    for erratum in device.errata:
        if erratum.literal:
            yield _Claim(erratum.place.path, "literal", erratum.literal, erratum.place["literal"], erratum.sources)


def _means(fact: Fact, key: str, base: int) -> tuple[int, ...]:
    """The numbers of which the manual may print any, where they are not those of the key itself.

    A parameter has a number in its set, and one on the wire, which is greater by `base`.
    """
    if isinstance(fact, Parameter) and key == "number":
        return fact.number, base + fact.number
    if isinstance(fact, Bit):
        return tuple(range(fact.first, fact.last + 1))
    return (fact.value,) if isinstance(fact, Member) and key == "value" else ()


def _text(span: Span) -> str:
    return span.file.text[span.start : span.end].strip("\"'")


def _failing(claim: _Claim, manual: AlignedManual, plan: Plan, printed: list[str]) -> Iterator[Missing]:
    """A finding where the cited lines print neither the claim nor what an erratum says is printed."""
    texts = [manual.line(line) for source in claim.sources for a, b in source.lines for line in range(a, b + 1)]
    if not _printed(claim, texts) and not any(_printed_as(text, claim, texts) for text in printed if text):
        yield Missing(
            claim.path, f"`{_SPEC_KEYS.get(claim.key, claim.key)}` {claim.text}", claim.span, claim.sources[0]
        )


def _in_section(cited: str, section: str) -> bool:
    return cited == section or section.startswith(f"{cited}.") or cited.startswith(f"{section}.")


def _printed(claim: _Claim, texts: list[str]) -> bool:
    """Whether lines print a claim, in any spelling."""
    if claim.key == "frame":
        return bytes.fromhex(claim.text) in bytes(pair for text in texts for pair in byte_pairs(text))
    if claim.key == "elided":
        return _elided(bytes.fromhex(claim.text), texts)
    if claim.key in ("printed_name", "literal"):
        return all(any(has_word(text, word) for text in texts) for word in words(index_line(claim.text)))
    values: tuple[int | Decimal, ...] = claim.means or readings(claim.text, "number")
    if not values:
        bounds = [int(digits) for digits in _FIGURES.findall(claim.text)]
        return all(any(numbers(text).holds(bound) for text in texts) for bound in bounds)
    masks = [1 << int(bit) for bit in values if bit < 64] if claim.key in ("bit", "bits") else []
    wanted = (*values, *masks)
    return any(numbers(text).holds(number) for text in texts for number in wanted)


def _elided(frame: bytes, texts: list[str]) -> bool:
    """Whether the bytes on some lines are those of a frame in the same order, with gaps."""
    printed = bytes(pair for text in texts for pair in byte_pairs(text))
    return bool(printed) and in_order(printed, frame)


def _printed_as(printed: str, claim: _Claim, texts: list[str]) -> bool:
    """Whether lines print what an erratum says is printed for a claim."""
    if claim.key == "elided":
        return _elided(bytes(byte_pairs(printed)), texts)
    if claim.key == "frame":
        return bytes(byte_pairs(printed)) in bytes(pair for text in texts for pair in byte_pairs(text))
    have = {word for text in texts for word in words(text)}
    printed_words = words(index_line(printed))
    if printed_words and set(printed_words) <= have:
        return True
    values = numbers(index_line(printed)).values
    return bool(values) and all(any(numbers(text).holds(value) for text in texts) for value in values)
