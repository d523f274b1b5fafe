"""`fieldspec diff`: what can be compared, in which forms, and with which exit codes."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import html5lib
import pytest

from command_line import SPECS, TEST_SPECS
from external_tools import require_tool
from fieldspec.cli import main

DEVICE = f'''device:
  id: gadget
  name: Gadget
  vendor: Maker
  manual: {{title: The manual, file: gadget.txt, sha256: "{"0" * 64}", lines: 999}}
versions:
  - line: firmware
    builds: true
    members: [{{id: "1.0", source: L1}}, {{id: "2.0", source: L1}}]
'''
SPEED = (
    '  - group: all\n    section: "1"\n    rows:\n      - {at: 0x10, name: speed, type: u16, range: 0..9, source: L2}\n'
)
MORE = '      - {at: 0x11, name: ramp, type: u16, since: "2.0", source: L3}\n'
REGISTERS = f"registers:\n{SPEED}{MORE}"
MOVED = REGISTERS.replace("0x10", "0x20")
ACCEPTS = "accepts:\n  - {rule: register_moved, path: registers/speed, reason: A slip of ours., date: 2026-05-03}\n"
OVERLAY = """overlay: {id: "2.1", line: firmware, based_on: "2.0"}
changes:
  - {fact: registers/speed, set: {at: {was: 0x10, is: 0x30}}, reason: It has moved., source: L9}
"""


class Run:
    """Runs `fieldspec diff` and keeps its output."""

    def __init__(self, capsys: pytest.CaptureFixture[str]) -> None:
        self.capsys = capsys
        self.out = self.err = ""

    def __call__(self, *arguments: str) -> int:
        code = main(["diff", *arguments])
        self.out, self.err = self.capsys.readouterr()
        return code

    def json(self, *arguments: str) -> Any:
        """The data of the JSON output."""
        assert self(*arguments, "--format", "json") == 0
        return json.loads(self.out)


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Run:
    return Run(capsys)


def write(root: Path, registers: str = REGISTERS, device: str = "gadget") -> Path:
    """A folder of specs with one device."""
    folder = root / device
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "device.yaml").write_text(DEVICE.replace("gadget\n", device + "\n", 1), "utf-8")
    (folder / "registers.yaml").write_text(registers, "utf-8")
    return root


@pytest.fixture
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A git repository with specs in two commits; the first one is tagged. It is the current folder."""
    require_tool("git")
    monkeypatch.chdir(tmp_path)
    git("init", "--quiet", "--initial-branch=main")
    (tmp_path / "README.md").write_text("no specs yet", "utf-8")
    git("add", ".")
    git("commit", "--quiet", "-m", "Begin")
    write(tmp_path / "specs")
    git("add", ".")
    git("commit", "--quiet", "-m", "Transcribe")
    git("tag", "released")
    write(tmp_path / "specs", MOVED)
    git("commit", "--quiet", "-am", "Move")
    return tmp_path


def git(*arguments: str) -> None:
    who = ["-c", "user.name=somebody", "-c", "user.email=somebody@example.invalid", "-c", "commit.gpgsign=false"]
    subprocess.run(["git", *who, *arguments], check=True, capture_output=True)


def rules(data: Any) -> list[tuple[str, str, str]]:
    return [
        (change["rule"], change["class"], change["path"]) for comparison in data for change in comparison["changes"]
    ]


@pytest.mark.parametrize(("fail_on", "code"), [("breaking", 0), ("behaviour", 1), ("any", 1), ("", 0)])
def test_a_comparison_fails_on_the_class_of_change_that_is_asked_for(run: Run, fail_on: str, code: int) -> None:
    options = ["--fail-on", fail_on] if fail_on else []
    assert run("tc100@before-2.0", "tc100@2.0", "--specs", str(SPECS), *options) == code
    assert "reserved_changed: acceleration_time was reserved" in run.out


def test_a_version_does_not_differ_from_itself(run: Run) -> None:
    assert run("tc100@2.0", "tc100", "--specs", str(SPECS), "--fail-on", "any") == 0
    assert run.out == "tc100@2.0 -> tc100@2.0: no differences\n"


@pytest.mark.parametrize("form", ["text", "json", "markdown", "html", "sarif", "github"])
def test_every_form_is_printed_with_the_same_exit_code(run: Run, tmp_path: Path, form: str) -> None:
    old, new = str(write(tmp_path / "old")), str(write(tmp_path / "new", MOVED))
    assert run(old, new, "--format", form, "--fail-on", "breaking") == 1
    assert "register_moved" in run.out.replace("\\_", "_")
    assert run.err == ""


def test_json_has_class_values_and_both_places(run: Run, tmp_path: Path) -> None:
    data = run.json(str(write(tmp_path / "old")), str(write(tmp_path / "new", MOVED)))
    (change,) = data[0]["changes"]
    assert (change["class"], change["breaking"], change["old"], change["new"]) == ("wire", True, "0x10", "0x20")
    assert (change["before"]["line"], change["after"]["file"]) == (5, f"{tmp_path}/new/gadget/registers.yaml")
    assert change["versions"] == []


def test_a_change_at_some_versions_says_at_which(run: Run, tmp_path: Path) -> None:
    new = write(tmp_path / "new", REGISTERS.replace("0x11", "0x12"))
    data = run.json(str(write(tmp_path / "old")), str(new))
    assert [change["versions"] for change in data[0]["changes"]] == [["2.0"]]


def test_texts_of_specs_are_escaped_in_html_and_markdown(run: Run, tmp_path: Path) -> None:
    hostile = REGISTERS.replace("name: speed,", "name: speed, label: '</td><script>alert(1)</script> | *x* `y`',")
    folders = str(write(tmp_path / "old")), str(write(tmp_path / "new", hostile.replace("u16", "u32", 1)))
    assert run(*folders, "--format", "html") == 0
    page = html5lib.HTMLParser(strict=True, namespaceHTMLElements=False).parse(run.out)
    assert page.findall(".//script") == []
    assert len(page.findall(".//tbody/tr")) >= 2
    assert run(*folders, "--format", "markdown") == 0
    assert "<script>" not in run.out
    table = [line for line in run.out.splitlines() if line.startswith("|")]
    assert {line.replace("\\|", "").count("|") for line in table} == {5}


def test_a_removed_device_is_breaking_and_a_new_one_is_not(run: Run, tmp_path: Path) -> None:
    first, two = write(tmp_path / "one"), write(write(tmp_path / "two"), device="widget")
    assert rules(run.json(str(first), str(two))) == [("fact_added", "behaviour", "widget")]
    assert run(str(two), str(first), "--fail-on", "breaking") == 1


def test_a_folder_may_be_that_of_one_device_and_may_name_a_version(run: Run, tmp_path: Path) -> None:
    old, new = write(tmp_path / "old"), write(tmp_path / "new", MOVED)
    assert rules(run.json(f"{old}/gadget", f"{new}/gadget")) == [("register_moved", "wire", "registers/speed")]
    assert rules(run.json(f"{old}@1.0", f"{new}/gadget@2.0"))[1] == ("fact_added", "behaviour", "registers/ramp")


def test_revisions_are_compared_with_each_other_and_with_the_files(run: Run, repository: Path) -> None:
    moved = [("register_moved", "wire", "registers/speed")]
    assert rules(run.json("HEAD~1", "HEAD")) == moved
    assert rules(run.json("released", "specs")) == moved
    assert rules(run.json("released:specs", "main:specs/gadget")) == moved
    assert rules(run.json("released:specs/gadget@2.0", ".")) == moved
    assert rules(run.json("HEAD", ".")) == []
    assert rules(run.json("main@{0}", "released")) == moved


def test_a_revision_is_compared_with_a_version(run: Run, repository: Path) -> None:
    data = run.json("released", "gadget@1.0")
    assert (data[0]["old"], data[0]["new"]) == ("released gadget@1.0", "gadget@1.0")
    assert rules(data) == [("register_moved", "wire", "registers/speed")]


def test_paths_of_files_name_their_revision_except_in_reviews(run: Run, repository: Path) -> None:
    (change,) = run.json("released", "HEAD")[0]["changes"]
    assert change["before"]["file"] == "released:specs/gadget/registers.yaml"
    run("released", "HEAD", "--format", "github")
    assert run.out.startswith("::error file=specs/gadget/registers.yaml,line=5,")
    run("released", "HEAD", "--format", "sarif")
    (result,) = json.loads(run.out)["runs"][0]["results"]
    assert result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"] == "specs/gadget/registers.yaml"


def test_a_new_version_is_compared_with_the_one_it_is_based_on(run: Run, repository: Path) -> None:
    git("checkout", "--quiet", "released")
    (repository / "specs/gadget/versions").mkdir()
    (repository / "specs/gadget/versions/2.1.yaml").write_text(OVERLAY, "utf-8")
    data = run.json("HEAD", ".")
    assert [(comparison["old"], comparison["new"]) for comparison in data][1] == (". gadget@2.0", ". gadget@2.1")
    assert ("fact_added", "behaviour", "versions/firmware/2.1") in rules(data[:1])
    assert rules(data[1:]) == [("register_moved", "wire", "registers/speed")]


def test_an_accepted_change_hurts_nobody(run: Run, tmp_path: Path) -> None:
    folders = str(write(tmp_path / "old")), str(write(tmp_path / "new", MOVED + ACCEPTS))
    assert run(*folders, "--fail-on", "any") == 0
    assert "accepted 2026-05-03: A slip of ours." in run.out
    assert run(*folders, "--format", "github") == 0
    assert run.out == ""


def test_a_change_that_the_old_version_accepts_no_longer_counts(run: Run, tmp_path: Path) -> None:
    old = write(tmp_path / "old", REGISTERS + ACCEPTS)
    assert run(str(old), str(write(tmp_path / "new", MOVED + ACCEPTS)), "--fail-on", "breaking") == 1
    assert run(str(old), str(write(tmp_path / "same", REGISTERS + ACCEPTS)), "--fail-on", "any") == 0


@pytest.mark.parametrize(
    ("accepts", "message"),
    [
        (ACCEPTS.replace("registers/speed", "registers/sped"), "finds no change at `registers/sped`"),
        (ACCEPTS.replace("register_moved", "scale_changed"), "`scale_changed` finds no change"),
        (ACCEPTS.replace("register_moved", "register_move"), "there is no rule of changes `register_move`"),
    ],
)
def test_accepting_what_has_not_happened_is_an_error(run: Run, tmp_path: Path, accepts: str, message: str) -> None:
    folders = str(write(tmp_path / "old")), str(write(tmp_path / "new", MOVED + accepts))
    assert run(*folders) == 1
    assert "accepts_used" in run.err
    assert message in run.err
    assert run(*folders, "--format", "sarif") == 1
    assert "accepts_used" in run.out


def test_an_overlay_accepts_the_changes_of_its_version(run: Run, tmp_path: Path) -> None:
    specs = write(tmp_path / "specs", f"registers:\n{SPEED}")
    (specs / "gadget/versions").mkdir()
    (specs / "gadget/versions/2.1.yaml").write_text(OVERLAY + ACCEPTS, "utf-8")
    assert run("gadget@2.0", "gadget@2.1", "--specs", str(specs), "--fail-on", "breaking") == 0
    assert run("gadget@1.0", "gadget@2.1", "--specs", str(specs), "--fail-on", "breaking") == 0
    assert main(["check", "--specs", str(specs)]) == 0
    (specs / "gadget/versions/2.1.yaml").write_text(OVERLAY + ACCEPTS.replace("moved", "removed"), "utf-8")
    assert run("gadget@2.0", "gadget@2.1", "--specs", str(specs), "--fail-on", "breaking") == 1
    assert main(["check", "--specs", str(specs)]) == 1


REASONED = """overlay: {id: "2.1", line: firmware, based_on: "2.0"}
changes:
  - {fact: registers/speed, set: {at: {was: 0x10, is: 0x30}}, reason: It has moved.}
adds:
  - {in: registers/all, item: {at: 0x40, name: torque, type: u16}, reason: It measures its torque.}
renames:
  - {fact: registers/speed, to: velocity, reason: The notes call it so.}
"""


def test_a_change_has_the_reason_of_its_version(run: Run, tmp_path: Path) -> None:
    specs = write(tmp_path / "specs", f"registers:\n{SPEED}")
    (specs / "gadget/versions").mkdir()
    (specs / "gadget/versions/2.1.yaml").write_text(REASONED, "utf-8")
    (comparison,) = run.json("gadget@2.0", "gadget@2.1", "--specs", str(specs))
    reasons = {change["rule"]: (change["path"], change["reason"]) for change in comparison["changes"]}
    assert reasons == {
        "renamed": ("registers/velocity", "It has moved. The notes call it so."),
        "register_moved": ("registers/velocity", "It has moved. The notes call it so."),
        "fact_added": ("registers/torque", "It measures its torque."),
    }
    assert run("gadget@2.0", "gadget@2.1", "--specs", str(specs)) == 0
    assert "because: It measures its torque." in run.out
    assert run("gadget@2.1", "gadget@2.0", "--specs", str(specs)) == 0
    assert "because" not in run.out


def refused(run: Run, *arguments: str) -> str:
    """The one line of output that says why a comparison is not possible."""
    assert run(*arguments) == 2
    assert run.out == ""
    (line,) = run.err.splitlines()
    assert line.startswith("fieldspec: ")
    return line


@pytest.mark.parametrize(
    ("old", "message"),
    [
        ("tc100@9.9", "there is no version of tc100 9.9"),
        ("tc10@2.0", "did you mean tc100?"),
        ("esc11@1.17", "are different devices"),
        ("nothing-like-it", "no device, no folder and no git revision nothing-like-it"),
        ("", "there is no device, no folder and no git revision"),
    ],
)
def test_what_cannot_be_compared_is_wrong_use(run: Run, repository: Path, old: str, message: str) -> None:
    assert message in refused(run, old, "tc100@2.0", "--specs", str(SPECS)).replace(str(SPECS), "")


@pytest.mark.parametrize(
    ("old", "message"),
    [
        ("no-such-branch", "there is no device, no folder and no git revision no-such-branch"),
        ("HEAD~99", "no git revision HEAD~99"),
        ("HEAD~2", "the revision HEAD~2 has no folder specs"),
        ("HEAD:nowhere", "the revision HEAD has no folder nowhere"),
        ("HEAD~2:", "HEAD~2 contains no specs"),
        ("HEAD:README.md", "the revision HEAD has no folder README.md"),
        ("HEAD@9.9", "there is no version of gadget 9.9"),
        (":specs", "no git revision"),
    ],
)
def test_a_revision_that_is_not_there_or_holds_no_specs_is_wrong_use(
    run: Run, repository: Path, old: str, message: str
) -> None:
    assert message in refused(run, old, "specs")


def test_a_folder_that_holds_no_specs_is_wrong_use(run: Run, repository: Path) -> None:
    (repository / "empty").mkdir()
    assert "the folder empty contains no specs" in refused(run, "empty", "specs")


def test_specs_that_cannot_be_read_are_wrong_use(run: Run, repository: Path) -> None:
    write(repository / "specs", "registers: [")
    git("commit", "--quiet", "-am", "Break")
    assert "the specs of HEAD cannot be read: HEAD:specs/gadget/registers.yaml:1" in refused(run, "HEAD", "released")
    assert "cannot be read" in refused(run, "released", "specs")


def test_outside_of_a_repository_there_are_no_revisions(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    require_tool("git")
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(tmp_path.parent))
    monkeypatch.chdir(write(tmp_path / "specs").parent)
    assert "is in no git repository" in refused(run, "HEAD", "specs")


def test_links_hidden_files_and_other_kinds_of_a_revision_are_no_specs(run: Run, repository: Path) -> None:
    folder = repository / "specs" / "gadget"
    (folder / "link.yaml").symlink_to("registers.yaml")
    (folder / ".hidden.yaml").write_text("registers: {}\n", "utf-8")
    (folder / "notes.txt").write_text("registers: {}\n", "utf-8")
    git("add", ".")
    git("commit", "--quiet", "-m", "Add what is not a spec")
    assert run("released", "HEAD", "--fail-on", "breaking") == 1
    assert run.err == ""
    assert run("HEAD~1", "HEAD", "--fail-on", "any") == 0


def test_an_acceptance_of_one_step_is_not_missed_between_versions_that_are_further_apart(
    run: Run, tmp_path: Path
) -> None:
    at_times = "".join(
        f"      - {{at: {address}, name: speed, type: u16, only: [{versions}], source: L2}}\n"
        for address, versions in (("0x10", '"1.0", "3.0"'), ("0x20", '"2.0"'))
    )
    registers = f'registers:\n  - group: all\n    section: "1"\n    rows:\n{at_times}'
    specs = write(tmp_path / "specs", registers + ACCEPTS.replace("date:", 'since: ["3.0"], date:'))
    device = specs / "gadget" / "device.yaml"
    device.write_text(
        device.read_text("utf-8").replace(
            '{id: "2.0", source: L1}', '{id: "2.0", source: L1}, {id: "3.0", source: L1}'
        ),
        "utf-8",
    )
    assert run("gadget@2.0", "gadget@3.0", "--specs", str(specs), "--fail-on", "breaking") == 0
    assert "A slip of ours." in run.out
    assert run("gadget@1.0", "gadget@3.0", "--specs", str(specs), "--fail-on", "any") == 0
    assert (run.out, run.err) == ("gadget@1.0 -> gadget@3.0: no differences\n", "")


def test_without_git_there_are_no_revisions(run: Run, repository: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "")
    assert "git is not installed" in refused(run, "HEAD", "specs")


def test_the_made_up_devices_do_not_differ_from_themselves(run: Run) -> None:
    assert run(str(TEST_SPECS), str(TEST_SPECS), "--fail-on", "any") == 0


def test_a_rule_of_changes_is_explained(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["rule", "register_moved"]) == 0
    out = capsys.readouterr().out
    assert "Class: wire" in out
    assert main(["rule"]) == 0
    assert "register_moved" in capsys.readouterr().out


def test_what_stands_behind_two_dashes_is_no_option(run: Run) -> None:
    assert run("--specs", str(SPECS), "--", "tc100", "--help") == 2
    assert "no git revision --help" in run.err
