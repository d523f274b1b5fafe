"""The texts about a fact that comments of generated code have."""

from __future__ import annotations

import re
from collections.abc import Iterable

from fieldspec.language.model.device import Detection, Manual
from fieldspec.language.model.fact import Citation, Fact
from fieldspec.language.model.units import standard_unit


def sentence(text: str) -> str:
    """A text with a full stop, if it lacks one."""
    return text if not text or text.rstrip()[-1:] in ".!?:。" else f"{text.rstrip()}."


def manual_remark(manual: Manual) -> str:
    """The title of a manual, and how a citation of it is read."""
    title = f"{manual.title} {manual.edition}".strip()
    if not manual.mark:
        return f"Manual: {title}. A note such as [8.2] is a section of it."
    number = "1622" if manual.lines else "17"
    return f"Manual: {title}. A note such as [8.2 {manual.mark}{number}] is a section and a {manual.unit[:-1]} of it."


def places(sources: Iterable[Citation]) -> str:
    """`8.2 L1622; 5.1 L1160-1163`, or nothing."""
    return "; ".join(citation.text() for citation in sources)


def cited(sources: Iterable[Citation]) -> str:
    """`Source: 8.2 L1622; 5.1 L1160-1163.`, or nothing."""
    text = places(sources)
    return f"Source: {text}." if text else ""


def printed(fact: Fact) -> str:
    """The names of a fact in the manual, in parentheses: `(SrvCmd, 伺服ON/OFF)`, or an empty text."""
    names = [text for text in (fact.printed_name, fact.label) if text]
    return f"({', '.join(names)})" if names else ""


def availability(fact: Fact) -> str:
    """`Only E2. Since 2.8.16.`, or nothing."""
    known = (("Only", fact.only), ("Since", fact.since), ("Until", fact.until))
    return " ".join(f"{word} {', '.join(versions)}." for word, versions in known if versions)


def described(head: str, fact: Fact, *paragraphs: str) -> list[str]:
    """The paragraphs of a fact's docstring: a head with the manual's words, the doc, more, notes, sources."""
    first = f"{head} {printed(fact)}".strip()
    notes = [f"Note: {sentence(note)}" for note in fact.notes]
    inferred = [f"Inferred ({key}): {sentence(reason)}" for key, reason in fact.inferred.items()]
    doubt = "Not compared with the manual yet." if fact.unverified else ""
    caveats = (availability(fact), doubt, *notes, *inferred)
    return [sentence(first), sentence(fact.doc), *paragraphs, *caveats, cited(fact.sources)]


def detection_text(detection: Detection) -> str:
    """The value that identifies the version of a device, and the interpretation of its number."""
    return f"The device tells its version in `{detection.fact}`. {number_text(detection)}".strip()


def number_text(detection: Detection) -> str:
    """How a number is read, as a sentence; empty where the manual does not print it."""
    if detection.form == "bytes":
        return "Each byte of the number is a number of the version."
    if not detection.form:
        return ""
    point = f", with a point before the last {detection.places}" if detection.places else ""
    return f"The {detection.form} digits of the number are the version{point}."


def unit_word(unit: str) -> str:
    """The suffix of a scaled property: `mm`, `percent`, `per_s`; `scaled` where there is no unit."""
    known = standard_unit(unit)
    above, _, below = ((known.word if known else "") or unit.lower() or "scaled").partition("/")
    words = f"{above if above != '1' else ''}_per_{below}".strip("_") if below else above
    return re.sub(r"[^a-z0-9]+", "_", words).strip("_") or "scaled"
