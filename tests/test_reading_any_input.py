"""Whatever is in the files, reading gives findings and never raises, and so does each version of what was read."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

import random_specs
from example_counts import examples
from fieldspec.language.reading import yaml_reader
from fieldspec.language.reading.project import Project, read
from spec_files import DEVICE, codes

ROOT = Path(__file__).parent.parent
FOLDERS = [ROOT / "specs", ROOT / "tests" / "specs"]
SPECS = [path for folder in FOLDERS for path in sorted(folder.glob("*/*.yaml"))]
PROTOCOL = b"protocol: {id: wire, title: A protocol}\n"
ALLOWED = {"references_resolve", "version_never", "version_twice", "version_unknown", "wrong_form"}
"""The findings of reading that random specs have; the last one for enums that follow from absent numbers."""
SEEDS = 400
PARSERS = [yaml.Loader, *([yaml._yaml.CParser] if yaml.__with_libyaml__ else [])]

# Characters with a meaning in YAML, and words of the language.
MARKS = [*"-:,[]{}#&*!|>'\"%@`?~ \n\t\r\x85\u2028\ufeff", ": ", "- ", "\n  ", "---\n", "...\n", "&a ", "*a", "!!int "]
ESCAPES = ['"\\x', '"\\u', '"\\U0011', "%YAML 1.1\n", "%TAG ! x\n", "!<", "!%FF ", "<<: *a"]
KEYS = [
    "device: ",
    "registers: ",
    "rows: ",
    "name: ",
    "at: ",
    "0x10",
    "since: ",
    "uses: ",
    "protocol: ",
    "wire",
    "伺服",
]
WORDS = st.sampled_from([*MARKS, *ESCAPES, *KEYS])


def read_whole(files: dict[str, bytes]) -> Project:
    """Reads files and every version of their devices; all findings must be printable."""
    project = read(files)
    findings = list(project.findings)
    for spec in project.devices.values():
        for version in [*spec.versions(), "no such version"]:
            findings += spec.at(version)[1]
    for finding in findings:
        assert finding.code
        assert finding.message.encode()
        assert len(finding.message) < 1000
        for span in (finding.span, *(label.span for label in finding.labels)):
            assert 0 <= span.start <= span.end
            line, column = span.position()
            assert line >= 1
            assert column >= 1
            span.file.line(line)
    return project


def of_device(data: bytes) -> dict[str, bytes]:
    """A device with one more file, and that file alone as a device and as a protocol."""
    return {
        "gadget/device.yaml": DEVICE.encode() + b"uses: [{protocol: wire}, {protocol: other}]\n",
        "gadget/more.yaml": data,
        "gizmo/device.yaml": data,
        "protocols/wire.yaml": PROTOCOL,
        "protocols/other.yaml": data,
    }


@given(st.binary(max_size=300))
@examples(300)
def test_any_bytes_are_read(data: bytes) -> None:
    read_whole(of_device(data))


@given(st.text(max_size=200))
@examples(300)
def test_any_text_is_read(text: str) -> None:
    read_whole(of_device(text.encode("utf-8", "surrogatepass")))


@pytest.mark.parametrize("parser", PARSERS)
def test_anything_like_yaml_is_read(parser: object) -> None:
    @given(st.lists(st.one_of(WORDS, st.text(max_size=2)), max_size=40).map("".join))
    @examples(500)
    def is_read(text: str) -> None:
        read_whole(of_device(text.encode("utf-8", "surrogatepass")))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(yaml_reader, "_Parser", parser)
        is_read()


@given(st.sampled_from(SPECS), st.data())
@examples(150)
def test_any_damaged_spec_is_read(path: Path, data: st.DataObject) -> None:
    text = path.read_bytes()
    for _ in range(data.draw(st.integers(1, 3))):
        at = data.draw(st.integers(0, len(text)))
        size = data.draw(st.integers(0, 12))
        text = text[:at] + data.draw(st.binary(max_size=4)) + text[at + size :]
    read_whole({"gadget/device.yaml": DEVICE.encode(), f"{path.parent.name}/{path.name}": text})


@given(st.sampled_from(SPECS), st.data())
@examples(60)
def test_any_spec_whose_words_are_changed_is_read(path: Path, data: st.DataObject) -> None:
    words = path.read_text("utf-8").split(" ")
    for _ in range(data.draw(st.integers(1, 8))):
        at = data.draw(st.integers(0, len(words) - 1))
        words[at] = data.draw(st.one_of(WORDS, st.sampled_from(words)))
    folders = {path.parent.name, "protocols"}
    files = {f"{spec.parent.name}/{spec.name}": spec.read_bytes() for spec in SPECS if spec.parent.name in folders}
    read_whole(files | {f"{path.parent.name}/{path.name}": " ".join(words).encode()})


def test_any_spec_that_fits_the_schema_is_read() -> None:
    built = 0
    for seed in range(SEEDS):
        text = random_specs.spec(seed)
        files = {"gadget/device.yaml": text.encode(), "protocols/wire.yaml": PROTOCOL}
        project = read_whole(files)
        assert set(codes(project.findings)) <= ALLOWED, f"seed {seed}"
        built += "gadget" in project.devices
    assert built > SEEDS / 2
