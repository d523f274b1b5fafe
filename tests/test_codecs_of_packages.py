"""Codecs that packages give: judged before they are used, printed where they have a text, and left out by name."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.command.editor.completion import suggestions
from fieldspec.command.editor.projects import EditedProject
from fieldspec.command.editor.typed_word import typed_word
from fieldspec.command.packages import codec_loading
from fieldspec.command.packages.codec_loading import judged_codec
from fieldspec.command.packages.plugins import CODECS, Plugin
from fieldspec.foundation.classes import replace
from fieldspec.foundation.source import SourceFile
from fieldspec.language.changes.table import changes
from fieldspec.language.model.codecs import ChecksumCodec, InstalledCodec, NumberCodec, provide
from fieldspec.language.model.device import Device
from fieldspec.language.reading.project import read
from fieldspec.targets import OUTPUTS
from fieldspec.tools.lists.value_forms import type_parts, type_text
from package_site import Site, declare, example_codecs

SCALE = """
device:
  {id: scale, name: Scale, vendor: Acme, manual: {title: Manual, file: scale.txt, sha256: "%s", lines: 99}}
links:
  - name: line
    source: 1 L1
    byte_order: big
    request: &frame
      - {name: code, role: code, type: u8}
      - {name: body, role: body}
      - {name: sum, role: checksum, algorithm: {method: codec, codec: acme_rolling, width: 16}, byte_order: big}
    response: *frame
messages:
  - name: read_weight
    code: 1
    source: 1 L2
    request: []
    response: [{name: weight, type: i32, codec: acme_float, length: 3, scale: 0.001, unit: kg, source: 1 L3}]
  - {name: reset, code: 2, source: 1 L4, request: [], response: []}
examples:
""" % ("0" * 64)
FRAMES = {
    "light": ("01 00 30 39 59 63", "12.345 kg"),
    "heavy": ("01 02 61 A8 5B DA", "2500 kg"),
    "below": ("01 80 01 F4 78 A6", "-0.5 kg"),
}
SCALE += "".join(
    f"  - {{id: {name}, source: 2 L1, link: line, direction: response, message: read_weight, frame: {frame}, "
    f"values: {{weight: {weight}}}}}\n"
    for name, (frame, weight) in FRAMES.items()
)


def device_of(text: str = SCALE) -> Device:
    spec = read({"scale/device.yaml": text.encode()}).devices["scale"]
    return spec.at(spec.versions()[-1])[0]


@pytest.fixture
def replace_codecs() -> Iterator[Callable[..., None]]:
    """Gives other codecs in place of those of the example package, until the test ends."""

    def replaced(**changed: str) -> None:
        codecs = example_codecs()
        provide(lambda: {name: replace(own, codec=replace(own.codec, **changed)) for name, own in codecs.items()})

    yield replaced
    provide(example_codecs)


@pytest.fixture
def site(tmp_path: Path) -> Site:
    site = Site(tmp_path, tmp_path / "site")
    folder = Path(__file__).parent / "example_package/src/acme_fieldspec"
    declare(site.packages, "acme", "codecs", "acme_float", "acme_fieldspec.codecs:FLOAT")
    with (site.packages / "acme-1.0.dist-info/entry_points.txt").open("a") as entries:
        entries.write("acme_rolling = acme_fieldspec.codecs:ROLLING\n")
    for path in [folder / "__init__.py", *(folder / "codecs").glob("acme_*"), folder / "codecs/__init__.py"]:
        site.write(f"site/acme_fieldspec/{path.relative_to(folder)}", path.read_text("utf-8"))
    site.write("specs/scale/device.yaml", SCALE)
    return site


def test_a_device_with_codecs_of_an_installed_package_is_checked_built_and_decoded(site: Site) -> None:
    assert site.run("check").out == "no findings in scale\n"
    built = site.run("build")
    assert built.code == 0
    assert "acme_rolling, which has no text for the dissector" in built.out
    assert (site.folder / "generated/c/scale_v1.h").is_file()
    assert not (site.folder / "generated/wireshark").exists()
    assert "-0.500 kg" in site.run("decode", "scale", "01 80 01 F4 78 A6").out
    assert site.run("encode", "scale", "reset", "--format", "hex").out.strip() == "02 D5 2C"


def test_an_output_without_a_text_that_is_named_is_an_error(site: Site) -> None:
    built = site.run("build", "--to", "wireshark")
    assert (built.code, "error[output_has_codec]" in built.out) == (1, True)


def test_outputs_are_built_anew_when_the_package_changes(site: Site) -> None:
    assert site.run("build").code == 0
    assert site.run("build", "--check").code == 0
    text = (site.packages / "acme_fieldspec/codecs/acme_float.h").read_text("utf-8")
    site.write("site/acme_fieldspec/codecs/acme_float.h", text + "/* another one */\n")
    assert "acme" in site.run("build", "--check").out
    assert site.run("build").code == 0
    assert "another one" in (site.folder / "generated/c/scale_v1.h").read_text("utf-8")


GOOD = "def decode(data): return data[0]\ndef encode(number): return bytes([number])\n"
FAULTS = {
    "no text of Python": ("def decode(data)", "SyntaxError"),
    "no function": ("def decode(data): return 0", "KeyError: 'encode'"),
    "one that raises": (GOOD.replace("data[0]", "data[1]"), "IndexError"),
    "one that ends the program": (GOOD.replace("return data[0]", "raise SystemExit(0)"), "SystemExit: 0"),
    "one that does not end": (GOOD.replace("return data[0]", "\n while True: pass"), "has not ended"),
    "a wrong size": (GOOD.replace("[number]", "[number, 0]"), "and not 1 bytes"),
    "another inverse": (GOOD.replace("[number]", "[number ^ 1]"), "and another number for the bytes"),
    "one that forgets": (GOOD.replace("data[0]", "data[0] or None").replace("number]", "number]"), "decode None"),
    "a number beyond the bounds": (GOOD.replace("data[0]", "data[0] + 256"), "a whole number from 0 to 255"),
    "a text for a number": (GOOD.replace("data[0]", "chr(data[0])"), "a whole number from 0 to 255"),
    "a truth value for a number": (GOOD.replace("data[0]", "bool(data[0])"), "a whole number from 0 to 255"),
}


def judged(folder: Path, monkeypatch: pytest.MonkeyPatch, expression: str, python: str) -> InstalledCodec:
    """A codec of a package that a folder has."""
    name = f"codec_of_{folder.name}"
    head = "from fieldspec.extension import ChecksumCodec, NumberCodec\n"
    (folder / f"{name}.py").write_text(f"{head}CODEC = {expression.replace('PYTHON', repr(python))}\n", "utf-8")
    monkeypatch.syspath_prepend(str(folder))
    monkeypatch.setattr(codec_loading, "_SECONDS", 1.0)
    return judged_codec(Plugin(CODECS, "own", f"{name}:CODEC", "bad", "1.0"))


@pytest.mark.parametrize("fault", FAULTS)
def test_a_codec_with_a_fault_is_known_by_it(fault: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    python, text = FAULTS[fault]
    assert text in judged(tmp_path, monkeypatch, "NumberCodec('1', 1, 0, 255, PYTHON)", python).fault


def test_a_codec_without_a_fault_has_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert judged(tmp_path, monkeypatch, "NumberCodec('1', 1, 0, 255, PYTHON)", GOOD).fault == ""


@pytest.mark.parametrize("result", ["'1'", "256", "-1", "id(data)"])
def test_a_checksum_is_a_number_of_its_bytes(result: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    python = f"def checksum(data): return {result}"
    assert "checksum gives" in judged(tmp_path, monkeypatch, "ChecksumCodec('1', 1, PYTHON)", python).fault


@pytest.mark.parametrize("bounds", ["1, 3, 0", "0, 0, 1", "65, 0, 1", "1, 0, 1 << 53", "1, 0, 1.5"])
def test_sizes_and_bounds_are_what_all_targets_have(
    bounds: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert "it has no 1 to 64 bytes" in judged(tmp_path, monkeypatch, f"NumberCodec('1', {bounds}, PYTHON)", GOOD).fault


def test_a_faulty_codec_is_a_finding_and_no_traceback(tmp_path: Path) -> None:
    site = Site(tmp_path, tmp_path / "site")
    code = f"from fieldspec.extension import NumberCodec\nCODEC = NumberCodec('1', 3, 0, 9, {GOOD!r})\n"
    declare(site.packages, "bad", "codecs", "acme_float", "bad:CODEC", code)
    site.write("specs/scale/device.yaml", SCALE)
    checked = site.run("check")
    assert (checked.code, checked.err) == (1, "")
    assert "error[codec_usable]: the codec acme_float cannot be used: decode gives" in checked.out


def test_what_is_no_codec_is_one_line_that_names_the_package(tmp_path: Path) -> None:
    site = Site(tmp_path, tmp_path / "site")
    declare(site.packages, "bad", "codecs", "acme_float", "bad:CODEC", "CODEC = 3\n")
    site.write("specs/scale/device.yaml", SCALE)
    checked = site.run("check")
    reason = "bad:CODEC is neither a NumberCodec nor a ChecksumCodec"
    text = f"fieldspec: the codec acme_float of the installed package bad 1.0 cannot be used: {reason}\n"
    assert (checked.code, checked.err) == (2, text)


def layout() -> DeviceLayout:
    return device_layout(device_of())


@pytest.mark.parametrize(
    ("output", "key", "title"), [("c", "c", "C"), ("js", "javascript", "JavaScript")], ids=["c", "js"]
)
def test_an_output_leaves_out_the_values_and_the_device_without_its_text(
    output: str, key: str, title: str, replace_codecs: Callable[..., None]
) -> None:
    replace_codecs(**{key: ""})
    findings = OUTPUTS[output].refusals([layout()])
    assert {(finding.severity.value, finding.message) for finding in findings} == {
        ("error", f"the checksum sum has the codec acme_rolling, which has no text for {title}"),
        ("warning", f"weight is sent by the codec acme_float, which has no text for {title}"),
    }


def test_files_say_what_they_leave_out(replace_codecs: Callable[..., None]) -> None:
    replace_codecs(c="", javascript="")
    text = SCALE.replace("algorithm: {method: codec, codec: acme_rolling, width: 16}", "algorithm: sum16")
    versions = [device_layout(device_of(text))]
    header, module = (
        str(OUTPUTS["c"].files(versions)["scale_v1.h"]),
        str(OUTPUTS["js"].files(versions)["scale/v1.js"]),
    )
    assert "read_weight" not in header.replace(line := "message read_weight: weight is sent by the codec", "")
    assert (line in header, line in module, "reset" in header, "Reset" in module) == (True, True, True, True)
    page = str(OUTPUTS["docs"].files(versions)["scale/lab-1.js"])
    assert "These are the bytes of the codec acme_float, which has no JavaScript." in page


def test_there_is_no_frame_lab_of_checksums_without_a_text(replace_codecs: Callable[..., None]) -> None:
    assert "scale/lab.html" in OUTPUTS["docs"].files([layout()])
    replace_codecs(javascript="")
    assert "scale/lab.html" not in OUTPUTS["docs"].files([layout()])
    assert {finding.help for finding in OUTPUTS["docs"].refusals([layout()])} == {
        "it is left out",
        "it shows weight as bytes",
    }


def test_the_identity_tells_versions_of_a_codec_apart(replace_codecs: Callable[..., None]) -> None:
    before = layout().identity
    replace_codecs(version="2")
    assert layout().identity != before


def test_a_comparison_names_the_codec() -> None:
    old, new = device_of(), device_of(SCALE.replace("codec: acme_float, length: 3", "digits: decimal, length: 8"))
    texts = [change.message for change in changes(old, new)]
    assert any("i32 by the codec acme_float" in text for text in texts)


@pytest.mark.parametrize(
    ("typed", "names"), [("acme_float", ["acme_float", "acme_gray"]), ("acme_rolling", ["acme_rolling"])]
)
def test_the_names_of_codecs_are_offered_where_they_fit(typed: str, names: list[str], tmp_path: Path) -> None:
    path = tmp_path / "scale/device.yaml"
    path.parent.mkdir()
    path.write_text(SCALE, "utf-8")
    project = EditedProject(tmp_path)
    project.read({})
    offset = SCALE.index(f"codec: {typed}") + len("codec: ")
    text = SCALE[:offset] + SCALE[offset + len(typed) :]
    word = typed_word(project, SourceFile("scale/device.yaml", text), offset)
    assert word is not None
    assert [suggestion.text for suggestion in suggestions(word)] == names


def test_a_list_says_the_codec_and_takes_it_back() -> None:
    value = next(field.value for field in layout().messages["read_weight"].response.fields)
    assert value is not None
    assert type_text(value) == "i32 codec acme_float"
    assert type_parts("i32 codec acme_float") == ("i32", {"codec": "acme_float"})


def test_bytes_that_are_no_number_of_a_codec_are_refused() -> None:
    data = bytes.fromhex("01 05 00 00")
    frame = data + example_codecs()["acme_rolling"].functions["checksum"](data).to_bytes(2, "big")  # type: ignore[attr-defined]
    assert explained(layout(), "line", "response", frame).reasons == ("unknown_value",)


def test_all_that_packages_need_is_in_the_door() -> None:
    assert {NumberCodec.__name__, ChecksumCodec.__name__} <= {*sys.modules["fieldspec.extension"].__all__}
