"""The verbs about versions: which there are, what one of them states and which file says so, and how they differ."""

from __future__ import annotations

import csv
import io
import shutil
from pathlib import Path
from typing import NamedTuple

import pytest

from command_line import SPECS, TEST_SPECS
from fieldspec.cli import main
from fieldspec.codec.layout.device import device_layout
from fieldspec.language.diagnostics import has_errors
from fieldspec.language.reading.project import read
from fieldspec.tools.facts.matrix import matrix
from fieldspec.tools.facts.row import row
from layouts import layouts

OVERLAY = """
overlay: {id: "1.2", line: firmware, based_on: "1.1", doc: Turns faster.}
changes:
  - {fact: parameters/servo/reference_speed, set: {range: {was: 1..65535, is: 1..6000}}, reason: A smaller motor.}
adds:
  - {in: enums/path, item: {value: 4, name: nowhere}, reason: New.}
"""


class Done(NamedTuple):
    """The exit code and the output of a run."""

    code: int
    out: str
    err: str


def ran(capsys: pytest.CaptureFixture[str], folder: Path, *words: str) -> Done:
    """Runs a verb on a folder of specs."""
    code = main([*words, "--specs", str(folder)])
    return Done(code, *capsys.readouterr())


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """The made-up devices, one of them with a version that is a file."""
    specs = tmp_path / "specs"
    shutil.copytree(TEST_SPECS, specs)
    (specs / "glider-x/versions").mkdir()
    (specs / "glider-x/versions/1.2.yaml").write_text(OVERLAY, "utf-8")
    return specs


def test_versions_are_listed_by_line_with_the_facts_that_depend_on_them(
    capsys: pytest.CaptureFixture[str], folder: Path
) -> None:
    done = ran(capsys, folder, "versions", "glider-x")
    assert done.code == 0
    rows = [line.split() for line in done.out.splitlines()]
    assert ["1.0", "yes"] in rows
    assert ["1.1", "yes", "2"] in rows
    assert ["1.2", "yes", "1.1", "Turns", "faster."] in rows
    assert ["X", "1"] in rows


def test_a_device_without_versions_has_one(capsys: pytest.CaptureFixture[str]) -> None:
    assert ran(capsys, TEST_SPECS, "versions", "gadget").out.startswith("Gadget has one version, 1: ")


@pytest.mark.parametrize("root", [TEST_SPECS, SPECS], ids=["made up", "real"])
def test_a_resolved_spec_is_the_device_at_that_version(
    capsys: pytest.CaptureFixture[str], root: Path, tmp_path: Path
) -> None:
    for name, versions in layouts(root).items():
        for layout in versions:
            done = ran(capsys, root, "resolve", f"{name}@{layout.device.version}")
            assert done.code == 0
            project = read({f"{name}/device.yaml": done.out.encode()})
            assert not has_errors(project.findings), (name, project.findings[0].message)
            device, findings = project.devices[name].at(layout.device.version)
            assert not has_errors(findings)
            assert device_layout(device).identity == layout.identity


def test_each_value_of_a_resolved_spec_has_its_place(capsys: pytest.CaptureFixture[str], folder: Path) -> None:
    lines = ran(capsys, folder, "resolve", "glider-x@1.2").out.splitlines()
    (line,) = (line for line in lines if "1..6000" in line)
    assert line.strip().startswith("range: 1..6000 ")
    assert line.endswith("glider-x/versions/1.2.yaml:4")
    assert all("  # " in line for line in lines if not line.rstrip().endswith(":"))


def test_blame_says_which_file_set_an_attribute(capsys: pytest.CaptureFixture[str], folder: Path) -> None:
    path = "parameters/servo/reference_speed"
    old = ran(capsys, folder, "blame", "glider-x@1.1", path).out
    new = ran(capsys, folder, "blame", "glider-x@1.2", path).out
    assert "range" in old
    assert "versions/1.2.yaml" not in old
    (line,) = (line for line in new.splitlines() if line.startswith("range"))
    assert line.split()[1] == "1..6000"
    assert "versions/1.2.yaml:4:" in line


def test_blame_says_what_a_group_gives_its_rows(capsys: pytest.CaptureFixture[str]) -> None:
    out = ran(capsys, SPECS, "blame", "tc100", "registers/servo").out
    (line,) = (line for line in out.splitlines() if line.startswith("type"))
    assert line.endswith(", a default")


def test_a_matrix_has_the_facts_that_differ(capsys: pytest.CaptureFixture[str], folder: Path) -> None:
    done = ran(capsys, folder, "matrix", "glider-x", "--format", "csv")
    head, *rows = csv.reader(io.StringIO(done.out))
    assert head == ["path", "kind", "1.0", "1.1", "1.2", "1.2+X", "1.2+Y"]
    cells = {row[0]: row[2:] for row in rows}
    assert cells["enums/path/nowhere"] == ["", "", "4", "same", "same"]
    assert cells["parameters/servo/reference_speed"][2] == "max 6000, ranges 1..6000"
    assert cells["parameters/monitor/alarm_code"][3:] == ["same", ""]
    assert "signals/speed_setpoint" not in cells


def test_a_renamed_fact_is_one_row_of_a_matrix(capsys: pytest.CaptureFixture[str], folder: Path) -> None:
    overlay = folder / "glider-x/versions/1.2.yaml"
    renamed = "renames: [{fact: parameters/servo/reference_speed, to: top_speed, reason: The notes call it so.}]\n"
    overlay.write_text(OVERLAY + renamed, "utf-8")
    done = ran(capsys, folder, "matrix", "glider-x", "--format", "csv")
    cells = {row[0]: row[2:] for row in csv.reader(io.StringIO(done.out))}
    assert "parameters/servo/reference_speed" not in cells
    assert cells["parameters/servo/top_speed"][2] == "name top_speed, max 6000, ranges 1..6000"


def test_a_matrix_prints_addresses_in_hexadecimal_and_decimal() -> None:
    rows = {version: [row("register", "registers/a", (), address=at)] for version, at in (("1", 16), ("2", 8193))}
    assert matrix(rows, False).rows[0].cells == ("there", "address 0x2001 (8193)")


def test_a_matrix_of_everything_has_the_facts_that_are_the_same(
    capsys: pytest.CaptureFixture[str], folder: Path
) -> None:
    done = ran(capsys, folder, "matrix", "glider-x", "--format", "csv", "--all")
    assert "registers/resolution," in done.out


def test_the_html_matrix_escapes_hostile_texts(capsys: pytest.CaptureFixture[str]) -> None:
    page = ran(capsys, TEST_SPECS, "matrix", "hostile", "--all", "--format", "html").out
    assert page.startswith("<!doctype html>")
    assert "</script>" not in page


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (("versions", "glider"), "there is no device glider; did you mean glider-x?"),
        (("resolve", "glider-x@9"), "there is no version of glider-x 9"),
        (("resolve", "glider-x@1.0+9"), "there is no version of glider-x 9"),
        (("blame", "glider-x", "registers/nothing"), "glider-x has no fact registers/nothing at 1.1"),
        (("blame", "glider-x", "registers"), "glider-x has no fact registers at 1.1, only a list"),
        (("matrix", "glider-x@1.0"), "the matrix shows all versions; leave out @1.0"),
    ],
)
def test_an_unknown_device_or_version_is_wrong_use(
    capsys: pytest.CaptureFixture[str], words: tuple[str, ...], text: str
) -> None:
    done = ran(capsys, TEST_SPECS, *words)
    assert done.code == 2
    assert text in done.err
