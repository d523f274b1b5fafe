"""A broken package is one line that names it and exit code 2, whatever is wrong with it, and nothing is written."""

from __future__ import annotations

from pathlib import Path

import pytest

from package_site import DEVICE, EXAMPLE, Site, declare

PROTOCOL = "src/acme_fieldspec/protocols/acme_bus.yaml"
GOOD_OUTPUT = "TITLE = 'Lists'\ndef files(versions):\n    return {}\n"
WORKBOOK = f"""from fieldspec.extension import Workbook, Worksheet
{GOOD_OUTPUT.replace("{}", "{'x': Workbook((Worksheet('a', (('b',), (CELL,))),))}")}"""
GOOD_CHECK = '''"""What holds.

Why: because.

Example: this.

Fix: that.
"""
from fieldspec.extension import Diagnostic
def good(device):
    return iter(())
'''
BROKEN = {
    "name of an output": ("outputs", "python", "bad", GOOD_OUTPUT, "fieldspec has its own output python"),
    "name of a check": ("checks", "bits_unique", "bad:good", GOOD_CHECK, "fieldspec has its own check bits_unique"),
    "name of a rule of changes": ("checks", "register_moved", "bad:good", GOOD_CHECK, "its own check register_moved"),
    "name of a protocol": ("protocols", "modbus", "bad", "", "fieldspec has its own protocol modbus"),
    "malformed name": ("outputs", "A/../b", "bad", GOOD_OUTPUT, "a name begins with a small letter"),
    "no module": ("outputs", "extra", "absent", "", "there is no module absent"),
    "failing module": ("outputs", "extra", "bad", "1 / 0", "ZeroDivisionError: division by zero"),
    "module that exits": ("outputs", "extra", "bad", "raise ImportError('a\\nb')", "ImportError: a b"),
    "no title": (
        "outputs",
        "extra",
        "bad",
        "def files(versions): return {}",
        "needs a text TITLE of one line and a function files",
    ),
    "failing output": ("outputs", "extra", "bad", GOOD_OUTPUT.replace("{}", "{}['x']"), "KeyError: 'x'"),
    "path out": (
        "outputs",
        "extra",
        "bad",
        GOOD_OUTPUT.replace("{}", "{'../x': ''}"),
        "'../x' is not a path of a file",
    ),
    "absolute path": (
        "outputs",
        "extra",
        "bad",
        GOOD_OUTPUT.replace("{}", "{'/x': ''}"),
        "'/x' is not a path of a file",
    ),
    "bytes": ("outputs", "extra", "bad", GOOD_OUTPUT.replace("{}", "{'x': b''}"), "neither a text nor a workbook"),
    "exit of the module": ("outputs", "extra", "bad", "raise SystemExit(0)", "SystemExit: 0"),
    "unknown name of the door": (
        *("outputs", "extra", "bad", "from fieldspec.extension import Devices"),
        "ImportError: cannot import name 'Devices' from 'fieldspec.extension'",
    ),
    "unknown attribute": (
        *("outputs", "extra", "bad", GOOD_OUTPUT.replace("{}", "{versions[0].regs: ''}")),
        "AttributeError: 'DeviceLayout' object has no attribute 'regs'",
    ),
    "change of a layout": (
        *("outputs", "extra", "bad", GOOD_OUTPUT.replace("return {}", "versions[0].identity = ''")),
        "FrozenInstanceError: cannot assign to field 'identity'",
    ),
    "exit of an output": ("outputs", "extra", "bad", GOOD_OUTPUT.replace("{}", "exit(0)"), "SystemExit: 0"),
    "title of lines": (
        *("outputs", "extra", "bad", GOOD_OUTPUT.replace("'Lists'", "'a\\nb'")),
        "needs a text TITLE of one line and a function files",
    ),
    "shared that is not a function": ("outputs", "extra", "bad", GOOD_OUTPUT + "shared = 1\n", "is not callable"),
    "refusals that are none": (
        *("outputs", "extra", "bad", GOOD_OUTPUT + "def refusals(versions): pass\n"),
        "TypeError: 'NoneType' object is not iterable",
    ),
    "text without UTF-8": (
        *("outputs", "extra", "bad", GOOD_OUTPUT.replace("{}", "{'x': '\\ud800'}")),
        "the content of x is not a text in UTF-8",
    ),
    "paths that differ by case": (
        *("outputs", "extra", "bad", GOOD_OUTPUT.replace("{}", "{'a/x': '', 'A/X': ''}")),
        "'A/X' and 'a/x' are one file on some systems",
    ),
    "file that is a folder": (
        *("outputs", "extra", "bad", GOOD_OUTPUT.replace("{}", "{'a': '', 'a/x': ''}")),
        "'a' is a file and a folder",
    ),
    "cell of another type": (*("outputs", "extra", "bad", WORKBOOK.replace("CELL", "b''")), "packed: TypeError"),
    "huge cell": (*("outputs", "extra", "bad", WORKBOOK.replace("CELL", "10**400")), "packed: OverflowError"),
    "title of a sheet": (
        *("outputs", "extra", "bad", WORKBOOK.replace("'a'", "'a/b'").replace("CELL", "1")),
        "the workbook x cannot be packed: InvalidWorksheetName",
    ),
    "no dict": ("outputs", "extra", "bad", GOOD_OUTPUT.replace("{}", "[]"), "its files are not a dict"),
    "no documentation": ("checks", "extra", "bad:good", "def good(device): return ()", "has not the parts Why"),
    "no function": ("checks", "extra", "bad:other", GOOD_CHECK, "has no attribute 'other'"),
    "not callable": ("checks", "extra", "bad:__doc__", GOOD_CHECK, "bad:__doc__ is not a function"),
    "failing check": ("checks", "extra", "bad:good", GOOD_CHECK.replace("iter(())", "1 / 0"), "ZeroDivisionError"),
    "no findings": (
        "checks",
        "extra",
        "bad:good",
        GOOD_CHECK.replace("iter(())", "[1]"),
        "yields something that is not a Diagnostic",
    ),
    "exit of a check": ("checks", "extra", "bad:good", GOOD_CHECK.replace("iter(())", "exit(0)"), "SystemExit: 0"),
    "unknown attribute in a check": (
        *("checks", "extra", "bad:good", GOOD_CHECK.replace("iter(())", "(device.regs for _ in 'a')")),
        "AttributeError: 'Device' object has no attribute 'regs'",
    ),
    "finding without a place": (
        *("checks", "extra", "bad:good", GOOD_CHECK.replace("iter(())", "[Diagnostic('extra', '', None)]")),
        "the span of its finding is not a Span",
    ),
    "finding without a text": (
        *("checks", "extra", "bad:good", GOOD_CHECK.replace("iter(())", "[Diagnostic('extra', 1, device.place[''])]")),
        "the message of its finding is not a text",
    ),
    "two findings in place of labels": (
        *("checks", "extra", "bad:good"),
        GOOD_CHECK.replace("iter(())", "[Diagnostic('extra', '', device.place.whole, ('a',))]"),
        "the labels of its finding are not a tuple of Label objects",
    ),
    "another severity": (
        *("checks", "extra", "bad:good"),
        GOOD_CHECK.replace("iter(())", "[Diagnostic('extra', '', device.place.whole, severity='error')]"),
        "the severity of its finding is not a Severity",
    ),
    "another code": (
        *("checks", "extra", "bad:good"),
        GOOD_CHECK.replace("iter(())", "[Diagnostic('other', '', device.place.whole)]"),
        "its finding has the code other, and not extra",
    ),
    "no file": ("protocols", "acme_bus", "bad", "", "the package bad has no file acme_bus.yaml"),
}


@pytest.mark.proof(7)
@pytest.mark.parametrize("case", BROKEN)
def test_a_broken_entry_point_is_one_line_that_names_the_package(tmp_path: Path, case: str) -> None:
    group, name, value, code, reason = BROKEN[case]
    site = Site(tmp_path, tmp_path / "site")
    declare(site.packages, "acme-broken", group, name, value, code)
    text = DEVICE if group == "protocols" else DEVICE.replace("{protocol: acme_bus}", "{protocol: own}")
    site.write("specs/pump/device.yaml", text)
    site.write("specs/protocols/own.yaml", (EXAMPLE / PROTOCOL).read_text("utf-8").replace("acme_bus", "own"))
    ran = site.run("build", "--to", name if group == "outputs" else "c")
    assert ran.code == 2, ran
    assert ran.err.startswith(f"fieldspec: the {group[:-1]} {name} of the installed package acme-broken 1.0 cannot")
    assert reason in ran.err
    assert ran.err.count("\n") == 1
    assert ran.out == ""
    assert not (tmp_path / "generated").exists()


def test_two_packages_with_the_same_name_are_refused(tmp_path: Path) -> None:
    site = Site(tmp_path, tmp_path / "site")
    for package in ("acme-one", "acme-two"):
        declare(site.packages, package, "outputs", "extra", "bad", GOOD_OUTPUT)
    ran = site.run("build")
    assert (ran.code, "the package acme-one has one of this name" in ran.err) == (2, True)


PER_DEVICE = GOOD_OUTPUT.replace("{}", "{versions[0].device.id: ''}")
TWICE = {
    "pump and for valve": GOOD_OUTPUT.replace("{}", "{'list': ''}"),
    "no device and for valve": PER_DEVICE + "def shared():\n    return {'Valve': ''}\n",
}


@pytest.mark.parametrize("owners", TWICE)
def test_an_output_that_gives_one_file_twice_is_refused(tmp_path: Path, owners: str) -> None:
    site = Site(tmp_path, tmp_path / "site")
    declare(site.packages, "acme-broken", "outputs", "extra", "bad", TWICE[owners])
    text = DEVICE.replace("{protocol: acme_bus}", "{protocol: own}")
    for device in ("pump", "valve"):
        site.write(f"specs/{device}/device.yaml", text.replace("id: pump", f"id: {device}"))
    site.write("specs/protocols/own.yaml", (EXAMPLE / PROTOCOL).read_text("utf-8").replace("acme_bus", "own"))
    ran = site.run("build", "--to", "extra")
    assert (ran.code, ran.out, ran.err.count("\n")) == (2, "", 1)
    assert f" for {owners}; each needs a path of its own" in ran.err
    assert not (tmp_path / "generated").exists()


@pytest.mark.parametrize("verb", ["check", "show", "decode", "audit", "rule"])
def test_every_verb_that_uses_a_check_stops_at_a_broken_one(tmp_path: Path, verb: str) -> None:
    site = Site(tmp_path, tmp_path / "site")
    declare(site.packages, "acme-broken", "checks", "extra", "bad:good", "raise SystemExit(0)")
    assert site.run("new", "device", "pump", "--protocol", "modbus").code == 0
    words = {"show": ["pump"], "decode": ["pump", "01 03 20 00 00 01 8F CA"], "audit": ["pump"]}
    ran = site.run(verb, *words.get(verb, []))
    assert (ran.code, ran.out) == (2, "")
    expected = "fieldspec: the check extra of the installed package acme-broken 1.0 cannot be used: SystemExit: 0\n"
    assert ran.err == expected


UNREADABLE = "fieldspec: the entry points of the installed package acme-broken 1.0 cannot"


@pytest.mark.parametrize(("group", "code", "error"), [("fieldspec.outputs", 2, UNREADABLE), ("console_scripts", 0, "")])
def test_entry_points_that_cannot_be_read_are_refused_where_they_are_for_fieldspec(
    tmp_path: Path, group: str, code: int, error: str
) -> None:
    site = Site(tmp_path, tmp_path / "site")
    assert site.run("new", "device", "pump", "--protocol", "packet").code == 0
    declare(site.packages, "acme-broken", "outputs", "extra", "bad")
    entry_points = site.packages / "acme-broken-1.0.dist-info" / "entry_points.txt"
    entry_points.write_text(f"[{group}]\nextra\n", encoding="utf-8")
    ran = site.run("build", "--to", "vectors")
    assert (ran.code, ran.err[: len(UNREADABLE)]) == (code, error)
