"""Installed packages add outputs, checks and protocols, and are judged before anything of them is used."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from fieldspec.command import rules
from package_site import DEVICE, EXAMPLE, HERE, Site

UNLIMITED = DEVICE.replace(", range: 1..100", "")


@pytest.fixture(scope="session")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The example package as pip installs it, without fetching anything."""
    folder = tmp_path_factory.mktemp("example")
    shutil.copytree(EXAMPLE, folder / "source", ignore=shutil.ignore_patterns("__pycache__"))
    options = ["--quiet", "--no-deps", "--no-index", "--no-build-isolation", "--disable-pip-version-check"]
    command = [
        sys.executable,
        "-m",
        "pip",
        "install",
        *options,
        "--target",
        str(folder / "site"),
        str(folder / "source"),
    ]
    subprocess.run(command, check=True)
    return folder / "site"


@pytest.fixture
def site(tmp_path: Path, installed: Path) -> Site:
    shutil.copytree(installed, tmp_path / "site")
    site = Site(tmp_path, tmp_path / "site")
    site.write("specs/pump/device.yaml", DEVICE)
    return site


def test_an_output_of_an_installed_package_is_built_with_the_others(site: Site) -> None:
    built = site.run("build")
    assert (built.code, built.err) == (0, "")
    table = (site.folder / "generated/address_list/pump_v1.csv").read_text("utf-8")
    assert table.splitlines() == ["address,name,words", "0x2000,state,1", "0x2001,speed,1"]
    assert (site.folder / "generated/address_list/README.txt").is_file()
    assert (site.folder / "generated/c/pump_v1.h").is_file()
    assert "address_list/pump_v1.csv" in site.manifest()["files"]
    assert site.run("build", "--check").out == "everything is fresh\n"
    assert site.run("build", "--to", "address_list").out == "2 files, 0 written, 0 removed\n"


def test_help_and_wrong_use_list_the_outputs_of_installed_packages(site: Site) -> None:
    assert "address_list: Addresses of registers as CSV" in site.run("build", "--help").out
    wrong = site.run("build", "--to", "adress_list")
    assert (wrong.code, wrong.err) == (2, "fieldspec: there is no output adress_list; did you mean address_list?\n")


def test_an_output_of_an_installed_package_refuses_what_it_cannot_express(site: Site) -> None:
    site.write(
        "specs/pump/device.yaml", DEVICE.replace("range: 1..100", "type: u64, checked: {words: 4}, range: 1..100")
    )
    refused = site.run("build", "--to", "address_list")
    assert (refused.code, "error[address_list_words]" in refused.out) == (1, True)
    assert not (site.folder / "generated").exists()


def test_a_check_of_an_installed_package_finds_and_is_explained_and_allowed(site: Site) -> None:
    assert site.run("check").code == 0
    site.write("specs/pump/device.yaml", UNLIMITED)
    checked = site.run("check")
    assert checked.code == 1
    assert "error[writable_ranges_present]: speed can be written, and has no range" in checked.out
    assert "specs/pump/device.yaml:17:" in checked.out
    refused = site.run("build")
    assert (refused.code, refused.err) == (1, "fieldspec: nothing is written\n")
    for _ in range(2):
        answer = site.run("show", "pump")
        assert (answer.code, "the spec of pump has 1 error; see them with" in answer.err) == (2, True)
    rule = site.run("rule", "writable_ranges_present")
    assert (rule.code, "Fix: Look the limits up in the manual" in rule.out) == (0, True)
    assert "writable_ranges_present" in site.run("rule").out
    allowed = UNLIMITED.replace("name: speed", 'name: speed, allow: {writable_ranges_present: "the manual has none"}')
    site.write("specs/pump/device.yaml", allowed)
    assert site.run("check").code == 0
    site.write("specs/pump/device.yaml", allowed.replace("access: rw", "access: rw, range: 1..100"))
    assert "error[allowances_used]" in site.run("check").out
    sarif = json.loads(site.run("check", "--format", "sarif").out)
    assert sarif["runs"][0]["results"]


def test_a_protocol_of_an_installed_package_is_used_and_its_findings_show_its_file(site: Site) -> None:
    assert "The device moves." in site.run("show", "pump", "state").out
    file = site.packages / "acme_fieldspec/protocols/acme_bus.yaml"
    file.write_text(file.read_text("utf-8").replace("value: 1", "value: x"), encoding="utf-8")
    for verb in ("check", "build"):
        result = site.run(verb)
        assert (result.code, f"{file}:" in result.out) == (1, True), result
    assert site.run("show", "pump").code == 2
    result = site.run("new", "device", "valve", "--protocol", "acme_bus")
    assert (result.code, result.out) == (2, "")
    assert "the protocol acme_bus has findings" in result.err


def test_a_new_device_may_use_a_protocol_of_an_installed_package(site: Site) -> None:
    result = site.run("new", "device", "valve", "--protocol", "acme_bus")
    schemas = "specs/fieldspec.schema.json\nspecs/fieldspec.project.schema.json\n"
    assert (result.code, result.out) == (0, f"{schemas}fieldspec.yaml\nspecs/valve/device.yaml\n")
    assert site.run("check", "valve").code == 0
    assert not (site.folder / "specs/protocols").exists()


def test_a_protocol_among_the_specs_goes_before_one_that_is_installed(site: Site) -> None:
    own = "protocol: {id: acme_bus, title: Ours}\nenums: [{name: acme_state, members: [{value: 7, name: broken}]}]\n"
    site.write("specs/protocols/acme_bus.yaml", own)
    assert "broken" in site.run("show", "pump", "state").out


def test_a_change_of_an_installed_package_makes_outputs_anew(site: Site) -> None:
    build = ("build", "--to", "address_list,c")
    assert site.run(*build).code == 0
    assert [*site.manifest()["packages"]] == ["acme-fieldspec"]
    assert site.run(*build).out.endswith(", 0 written, 0 removed\n")
    module = site.packages / "acme_fieldspec/address_list.py"
    module.write_text(module.read_text("utf-8").replace('"words"', '"size"'), encoding="utf-8")
    stale = site.run(*build, "--check")
    assert stale.code == 1
    assert "not fresh: address_list/pump_v1.csv (changed: the package acme-fieldspec)\n" in stale.out
    assert site.run(*build).out.endswith(", 1 written, 0 removed\n")
    assert "address,name,size" in (site.folder / "generated/address_list/pump_v1.csv").read_text("utf-8")
    assert site.run(*build, "--check").out == "everything is fresh\n"
    protocol = site.packages / "acme_fieldspec/protocols/acme_bus.yaml"
    protocol.write_text(protocol.read_text("utf-8").replace("waits", "rests"), encoding="utf-8")
    assert "(changed: protocols/acme_bus.yaml)" in site.run(*build, "--check").out
    assert "rests" in site.run("show", "pump", "acme_state").out


def test_without_the_package_its_output_is_unknown_and_its_protocol_missing(site: Site) -> None:
    assert site.run("check").code == 0
    shutil.rmtree(site.packages)
    site.packages.mkdir()
    assert "there is no output address_list" in site.run("build", "--to", "address_list").err
    assert "error[file_missing]" in site.run("check").out


def test_the_documentation_of_rules_has_none_of_installed_packages(site: Site) -> None:
    code = (
        "from fieldspec.command.packages.plugin_loading import load_checks; load_checks(); "
        "from fieldspec.command import rules; "
    )
    code += "print(rules.page(), end=''); assert rules.rule('writable_ranges_present')"
    environment = {**os.environ, "PYTHONPATH": site.python_path, "PYTHONIOENCODING": "utf-8"}
    ran = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, check=True)
    assert ran.stdout.decode().replace("\r\n", "\n") == rules.page()


LAZY = """
import sys
from fieldspec.cli import main
main(sys.argv[1:])
loaded = {"importlib.metadata", "fieldspec.command.packages.plugin_loading", "fieldspec.extension"}
print(sorted(loaded & {*sys.modules}))
"""


@pytest.mark.parametrize("arguments", [["decode", "gadget", "00"], ["show", "gadget"]])
def test_a_verb_that_needs_no_plug_in_does_not_look_for_any(arguments: list[str], tmp_path: Path) -> None:
    environment = {**os.environ, "FIELDSPEC_CACHE": str(tmp_path)}
    command = [sys.executable, "-c", LAZY, *arguments, "--specs", str(HERE / "specs")]
    for _ in range(2):
        ran = subprocess.run(command, env=environment, capture_output=True, encoding="utf-8", check=True)
    assert ran.stdout.splitlines()[-1] == "[]"


def test_a_build_of_what_is_fresh_searches_no_packages(tmp_path: Path) -> None:
    environment = {**os.environ, "FIELDSPEC_CACHE": str(tmp_path / "cache")}
    options = ["--specs", str(HERE / "specs"), "--out", str(tmp_path / "out"), "--to", "vectors"]
    command = [sys.executable, "-c", LAZY, "build", "gadget", *options]
    for _ in range(2):
        ran = subprocess.run(command, env=environment, capture_output=True, encoding="utf-8", check=True)
    assert "importlib.metadata" not in ran.stdout.splitlines()[-1]


@pytest.mark.parametrize("verb", [["check"], ["decode", "pump", "01 03 20 00 00 01 8F CA"], ["build", "--to", "c"]])
def test_specs_without_the_protocols_of_fieldspec_can_use_them(tmp_path: Path, verb: list[str]) -> None:
    site = Site(tmp_path, tmp_path / "site")
    (tmp_path / "specs").mkdir()
    new = site.run("new", "device", "pump", "--protocol", "modbus", "--specs", "specs")
    project = "specs/fieldspec.project.schema.json\nfieldspec.yaml\n"
    assert new.out == f"specs/fieldspec.schema.json\nspecs/protocols/modbus.yaml\n{project}specs/pump/device.yaml\n"
    shutil.rmtree(tmp_path / "specs/protocols")
    ran = site.run(*verb)
    assert (ran.code, ran.err) == (0, "")
