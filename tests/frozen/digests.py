"""The digests of all answers about a layout: a line for each fact, and in it one for each aspect.

    registers/motion_command 371:5d2c1f7e values=cjpr:2f60b9c4 again=cjpr:90d1f5aa ..

These are the path of the fact, the number and the digest of its inputs, and for each aspect of the answers the letters
of the codecs (see `CODECS`) with the digest of what they say. Codecs that agree share a digest.
"""

from __future__ import annotations

import tempfile
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cache
from hashlib import sha256
from pathlib import Path

from fieldspec.codec.layout.device import DeviceLayout
from frozen.codecs import CODECS, Aspects
from frozen.inputs import Fact, Input, facts, inputs
from layouts import SPECS, TEST_SPECS, layouts

FOLDER = Path(__file__).parent / "digests"
_DIGITS = 8
INPUTS = "inputs", ""

Digests = dict[str, dict[tuple[str, str], str]]
"""By the path of a fact: the digests by aspect and letter of a codec, and under `INPUTS` that of the inputs."""


@dataclass
class Answered:
    """A fact with its inputs, and the answers of some codecs to each."""

    fact: Fact
    inputs: list[Input]
    answers: dict[str, list[Aspects]]


@dataclass
class Differences:
    """What differs from the recorded digests: a line for each fact. What is new was not recorded."""

    changed: list[str] = field(default_factory=list)
    new: list[str] = field(default_factory=list)


@cache
def distinct_layouts() -> dict[tuple[str, str], DeviceLayout]:
    """The layouts of the real and the made-up devices by device and version; of equal versions the first one."""
    distinct = {}
    for root in (SPECS, TEST_SPECS):
        for device, versions in layouts(root).items():
            for layout in {layout.identity: layout for layout in reversed(versions)}.values():
                distinct[device, layout.device.version] = layout
    return distinct


def digests_path(device: str, version: str) -> Path:
    """The file with the recorded digests of a layout."""
    return FOLDER / f"{device}_{version}.txt"


def answered(layout: DeviceLayout, chosen: Sequence[Fact], codecs: Iterable[str] = CODECS) -> Iterator[Answered]:
    """The answers about some facts of a layout."""
    inputs_of = [inputs(layout, fact) for fact in chosen]
    together = [item for items in inputs_of for item in items]
    with tempfile.TemporaryDirectory(prefix="fieldspec-answers-") as folder:
        answers = {name: iter(CODECS[name].answers(layout, Path(folder), together)) for name in codecs}
    for fact, items in zip(chosen, inputs_of, strict=True):
        yield Answered(fact, items, {name: [next(texts) for _ in items] for name, texts in answers.items()})


def digests(layout: DeviceLayout, chosen: Sequence[Fact] | None = None) -> Digests:
    """The digests of some facts of a layout, or of all."""
    results: Digests = {}
    for entry in answered(layout, list(facts(layout)) if chosen is None else chosen):
        texts = "".join(f"{item.text}\n" for item in entry.inputs)
        results[entry.fact.path] = {INPUTS: f"{len(entry.inputs)}:{_digest(texts)}"}
        for name, answers in entry.answers.items():
            for aspect in sorted({aspect for answer in answers for aspect in answer}):
                lines = "".join(f"{n} {answer[aspect]}\n" for n, answer in enumerate(answers) if aspect in answer)
                results[entry.fact.path][aspect, CODECS[name].letter] = _digest(lines)
    return results


def _digest(text: str) -> str:
    return sha256(text.encode("utf-8", "surrogatepass")).hexdigest()[:_DIGITS]


def text_of(digests: Digests) -> str:
    """Digests as the text of a file."""
    return "".join(f"{path} {_line(own)}\n" for path, own in sorted(digests.items()))


def _line(own: dict[tuple[str, str], str]) -> str:
    aspects: dict[str, dict[str, str]] = {}
    for (aspect, letter), digest in sorted(own.items()):
        if letter:
            codecs = aspects.setdefault(aspect, {})
            codecs[digest] = codecs.get(digest, "") + letter
    texts = [
        f"{aspect}=" + ",".join(f"{letters}:{digest}" for digest, letters in codecs.items())
        for aspect, codecs in aspects.items()
    ]
    return " ".join((own[INPUTS], *texts))


def recorded(path: Path) -> Digests:
    """The digests of a file; none where there is none."""
    results: Digests = {}
    for line in path.read_text("utf-8").splitlines() if path.exists() else ():
        fact, count, *aspects = line.split()
        results[fact] = {INPUTS: count}
        for aspect, _, codecs in (text.partition("=") for text in aspects):
            for letters, _, digest in (text.partition(":") for text in codecs.split(",")):
                results[fact] |= {(aspect, letter): digest for letter in letters}
    return results


def differences(old: Digests, new: Digests) -> Differences:
    """What differs between recorded digests and those of now, about the facts of either."""
    result = Differences()
    names = {codec.letter: name for name, codec in CODECS.items()}
    for path in sorted(old | new):
        before, now = old.get(path, {}), new.get(path, {})
        if not now:
            result.changed.append(f"{path}: there is no such fact any more")
        elif not before:
            result.new.append(path)
        elif before[INPUTS] != now[INPUTS]:
            result.changed.append(f"{path}: other inputs than those that were recorded, {now[INPUTS]}")
        else:
            result.new += [f"{path}: {aspect} of {names[letter]}" for aspect, letter in now.keys() - before.keys()]
            changed = [key for key in before if before[key] != now.get(key)]
            result.changed += [f"{path}: {aspect} of {names.get(letter, letter)}" for aspect, letter in sorted(changed)]
    return result
