"""Whether the cited lines print the addresses, codes, identifiers and values of the facts that cite them."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from fnmatch import fnmatchcase

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.source import Span
from fieldspec.language.checks.sources_present import cited_places
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Citation, Place
from fieldspec.tools.audit.agreement import byte_pairs, has_word, in_order, numbers, readings, words
from fieldspec.tools.audit.claims import NUMBERS, SIGN, VALUES, Claim, claims_of
from fieldspec.tools.audit.line_facts import lines_of
from fieldspec.tools.audit.manual_lines import AlignedManual, index_line
from fieldspec.tools.audit.plan import Plan, Unprinted

_SPEC_KEYS = {"elided": "frame"}
"""The keys of a spec for the keys of claims, where they differ."""
_FIGURES = re.compile(r"[0-9]+")
_SIGN = re.compile(
    r"\b(?:S?INT|I|L|INTEGER|DINT|LINT)(?:8|16|32|64)?\b|\bsigned\b|(?<![^\s(\[|~,:])-\s?[0-9]|±|\+/-", re.IGNORECASE
)
"""The printed form of a signed number: a type, or a negative number. A scan has `l16` for `I16`."""


@dataclass(frozen=True, slots=True)
class Missing:
    """A claim that the cited lines do not print: the path of the fact, the claim, and its place in the spec."""

    path: str
    what: str
    span: Span
    source: Citation


@dataclass(frozen=True, slots=True)
class CitationResults:
    """How many claims were looked up, which ones fail, and the exceptions without use.

    `numbered` are the facts with an identifying number, by path: its place in the spec, and its place in the manual.
    """

    looked_up: int
    numbered: Mapping[str, tuple[Span, Citation]]
    missing: tuple[Missing, ...]
    unused: tuple[Unprinted, ...]


def citation_results(devices: Sequence[Device], manual: AlignedManual, plan: Plan) -> CitationResults:
    """Looks up the claims of all facts of all versions of a device on the lines that they cite."""
    claims: dict[tuple[str, str, int, str], Claim] = {}
    corrected: dict[str, list[str]] = defaultdict(list)
    corrected_values: dict[tuple[str, str], list[str]] = defaultdict(list)
    printed_beside: dict[tuple[int, str], list[str]] = defaultdict(list)
    visited: set[int] = set()
    for device in devices:
        for claim in claims_of(device, visited):
            claims.setdefault((claim.path, claim.key, claim.span.start, claim.text), claim)
        for erratum in device.errata:
            if id(erratum) in visited:
                continue
            visited.add(id(erratum))
            corrected[erratum.fact] += [erratum.literal, *map(_printed_text, erratum.printed.values())]
            for key, printed in erratum.printed.items():
                corrected_values[erratum.fact, key] += [erratum.literal, _printed_text(printed)]
            for line in lines_of(erratum.sources):
                for key, printed in erratum.printed.items():
                    printed_beside[line, key].append(_printed_text(printed))
    looked_up, used, missing = 0, set(), []
    for claim in claims.values():
        also = [text for line in lines_of(claim.sources) for text in printed_beside.get((line, claim.key), ())]
        # Of a value, an erratum about another key of the fact says nothing.
        own = corrected_values.get((claim.path, claim.key)) if claim.is_of_value else corrected.get(claim.path)
        failing = [*_failing(claim, manual, plan, [*(own or ()), *also])]
        looked_up += 1
        for failure in failing:
            exception = _excepted(plan, claim.path)
            if exception is None:
                missing.append(failure)
            else:
                used.add(id(exception))
    missing += misplaced(devices, manual, plan)
    numbered: dict[str, tuple[Span, Citation]] = {}
    for claim in claims.values():
        if claim.key in NUMBERS:
            numbered.setdefault(claim.path.partition("/restated/")[0], (claim.span, claim.sources[0]))
    unused = tuple(entry for entry in plan.unprinted if id(entry) not in used)
    return CitationResults(looked_up, numbered, tuple(missing), unused)


def misplaced(devices: Sequence[Device], manual: AlignedManual, plan: Plan) -> Iterator[Missing]:
    """Citations that begin or end with a blank line, or have lines outside the section that they name."""
    visited: set[tuple[str, Citation]] = set()
    for device in devices:
        for _, place, sources, _ in cited_places(device):
            key = "element_sources" if "element_sources" in place and "source" not in place else "source"
            if key not in place:
                continue  # the fact inherits its sources
            for source in sources:
                if (place.path, source) not in visited:
                    visited.add((place.path, source))
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


def _failing(claim: Claim, manual: AlignedManual, plan: Plan, printed: list[str]) -> Iterator[Missing]:
    """A finding where the cited lines print neither the claim nor what an erratum says is printed."""
    texts = [manual.line(line) for source in claim.sources for a, b in source.lines for line in range(a, b + 1)]
    if not _printed(claim, texts) and not any(_printed_as(text, claim, texts) for text in printed if text):
        yield Missing(
            claim.path, f"`{_SPEC_KEYS.get(claim.key, claim.key)}` {claim.text}", claim.span, claim.sources[0]
        )


def _in_section(cited: str, section: str) -> bool:
    return cited == section or section.startswith(f"{cited}.") or cited.startswith(f"{section}.")


def _printed(claim: Claim, texts: list[str]) -> bool:
    """Whether lines print a claim, in any spelling."""
    if claim.key == "frame":
        return bytes.fromhex(claim.text) in bytes(pair for text in texts for pair in byte_pairs(text))
    if claim.key == "elided":
        return _elided(bytes.fromhex(claim.text), texts)
    if claim.key in VALUES:
        return any(not numbers(text).values.isdisjoint(claim.means) for text in texts)
    if claim.key == SIGN:
        return any(_SIGN.search(text) for text in texts)
    if claim.key in ("printed_name", "literal"):
        return all(any(has_word(text, word) for text in texts) for word in words(index_line(claim.text)))
    values: tuple[int | Decimal, ...] = claim.means or readings(claim.text, "number")
    if not values:
        bounds = [int(digits) for digits in _FIGURES.findall(claim.text)]
        return all(any(numbers(text).holds(bound) for text in texts) for bound in bounds)
    masks = [1 << int(bit) for bit in values if bit < 64] if claim.key in ("bit", "bits") else []
    means = (*values, *masks)
    return any(numbers(text).holds(number) for text in texts for number in means)


def _elided(frame: bytes, texts: list[str]) -> bool:
    """Whether the bytes on some lines are the bytes of a frame in the same order, with gaps."""
    printed = bytes(pair for text in texts for pair in byte_pairs(text))
    return bool(printed) and in_order(printed, frame)


def _printed_as(printed: str, claim: Claim, texts: list[str]) -> bool:
    """Whether lines print what an erratum says is printed for a claim."""
    if claim.key == "elided":
        return _elided(bytes(byte_pairs(printed)), texts)
    if claim.key == "frame":
        return bytes(byte_pairs(printed)) in bytes(pair for text in texts for pair in byte_pairs(text))
    line_words = {word for text in texts for word in words(text)}
    printed_words = words(index_line(printed))
    if printed_words and set(printed_words) <= line_words:
        return True
    values = numbers(index_line(printed)).values
    return bool(values) and all(any(numbers(text).holds(value) for text in texts) for value in values)
