"""`fieldspec new`: the first file of a device, the file of a version, or the schema for editors."""

from __future__ import annotations

import argparse
import os
import re
from importlib import resources
from pathlib import Path
from string import Template

from fieldspec.command.console.streams import print_line
from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.files import regular_file
from fieldspec.command.files.storage import write
from fieldspec.command.sources import first_example, protocol_entries, spec_files, specs
from fieldspec.command.sources.spec_files import INSTALLED
from fieldspec.foundation.reserved import file_name_fault
from fieldspec.language.model.choice import PROJECT_FILE
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.findings import LARGEST_FILE, MAIN, PROTOCOLS, VERSIONS
from fieldspec.language.reading.nodes import Mapping, Scalar, identity, mappings
from fieldspec.language.reading.yaml_reader import decoded, parsed
from fieldspec.language.schema import PROJECT_ADDRESS, schema

SHAPES = ("packet", "text", "escapes", "status", "bytes", "can", "telegram")
"""The skeletons of devices without a protocol, by their kind of frame."""

_WITHOUT_EFFECT = {
    "device": ("based_on", "line"),
    "version": ("protocol",),
    "schema": ("name", "version", "based_on", "line", "protocol"),
}
"""The options of other kinds of files."""


def run(arguments: argparse.Namespace) -> int:
    """Writes the file, and overwrites only an older schema. Raises UsageError."""
    other = _WITHOUT_EFFECT[arguments.kind]
    for name in other:
        if getattr(arguments, name) is not None:
            raise UsageError(f"--{name.replace('_', '-')} has no effect on a new {arguments.kind}; leave it out")
    if arguments.kind == "schema":
        schema_folder = specs.writable_folder(arguments.specs)
        specs.bring_schema(schema_folder)
        specs.bring_project_schema(schema_folder)
        return 0
    if arguments.name is None:
        raise UsageError(f"name the device; see: fieldspec new {arguments.kind} --help")
    folder, path, text = _version(arguments) if arguments.kind == "version" else _device(arguments)
    if path.exists():
        raise UsageError(f"the file {path} already exists")
    specs.bring_schema(folder)
    if arguments.protocol is not None and arguments.protocol not in SHAPES:
        _bring_protocols(folder, arguments.protocol)
    if arguments.kind == "device":
        _bring_project_file(folder)
    write(path, text.encode("utf-8"), new=True)
    print_line(specs.relative_path(path))
    return 0


def _bring_project_file(folder: Path) -> None:
    """Writes the project file beside a folder of specs, unless it is there already, and its schema."""
    specs.bring_project_schema(folder)
    path = Path(os.path.abspath(folder)).parent / PROJECT_FILE
    if not os.path.lexists(path):
        line = f"# yaml-language-server: $schema={Path(os.path.abspath(folder)).name}/{PROJECT_ADDRESS}\n"
        write(path, (line + _fill_skeleton("project")).encode("utf-8"), new=True)
        print_line(specs.relative_path(path))


def _version(arguments: argparse.Namespace) -> tuple[Path, Path, str]:
    """The folder with the specs, the path of the file, and its text."""
    if arguments.version is None:
        raise UsageError("name the version; use: fieldspec new version DEVICE VERSION --based-on VERSION")
    spec, newest = specs.spec_at(arguments.specs, arguments.name)
    base = arguments.based_on or newest
    if not spec.lines.place:
        first = "versions: [{line: firmware, builds: true, members: [{id: '1.0', source: 1 L1}]}]"
        raise UsageError(f"{arguments.name} declares no version yet; declare the first in its device.yaml: {first}")
    if base not in spec.lines.place:
        raise unknown(f"version of {arguments.name}", base, spec.lines.place)
    if arguments.version in spec.lines.place:
        raise UsageError(f"{arguments.name} already has a version {arguments.version}")
    _fits(arguments.version, "version", "a version")
    line = arguments.line or _line_of(spec, base)
    known = [identity(version_line) or "" for version_line in mappings(spec.tree.values.get("versions"))]
    if line not in known:
        raise unknown(f"line of versions of {arguments.name}", line, known)
    after = ""
    if line != _line_of(spec, base):
        members = [
            version.id
            for version_line in spec.at(newest)[0].lines
            if version_line.name == line
            for version in version_line.versions
        ]
        after = f'  after: "{members[-1]}"\n'
    folder = specs.writable_folder(arguments.specs)
    path = folder / arguments.name / VERSIONS / f"{arguments.version}.yaml"
    return (
        folder,
        path,
        specs.editor_line(2)
        + _fill_skeleton(
            "version",
            device=arguments.name,
            version=arguments.version,
            base=base,
            line=line,
            after=after,
        ),
    )


def _line_of(spec: DeviceSpec, version: str) -> str:
    """The name of the line on which a version is."""
    lines = list(mappings(spec.tree.values.get("versions")))
    return identity(lines[spec.lines.place[version][0]]) or ""


def _device(arguments: argparse.Namespace) -> tuple[Path, Path, str]:
    """The same of a device."""
    if arguments.version is not None:
        raise UsageError("a new device has no version yet; use: fieldspec new device NAME --protocol PROTOCOL")
    name = arguments.name
    _fits(name, "device_id", "a device")
    folder = _folder(arguments.specs)
    places = {name: Path(path) for name, path in spec_files.installed_protocols().items()}
    places |= {path.stem: path for path in (folder / PROTOCOLS).glob("*.yaml")}
    protocols = sorted(places)
    if not arguments.protocol:
        kinds = f"a kind of frame where there is none: {', '.join(SHAPES)}"
        raise UsageError(f"name the protocol with --protocol: {', '.join(protocols)}; or {kinds}")
    if arguments.protocol not in (*SHAPES, *protocols):
        raise unknown("protocol", arguments.protocol, [*protocols, *SHAPES])
    path = folder / name / MAIN
    text = specs.editor_line() + _fill_skeleton("device", name=name)
    if arguments.protocol in SHAPES:
        return folder, path, text + _fill_skeleton(arguments.protocol)
    return folder, path, text + _with_protocol(folder, name, text, places[arguments.protocol])


def _with_protocol(folder: Path, name: str, head: str, protocol: Path) -> str:
    """The rest of the spec of a device with a protocol: what it cites, a first register, and frames that read it."""
    overlays = "\n".join(protocol_entries.entries(protocol))
    words = protocol_entries.first_words(protocol)
    rest = _fill_skeleton("protocol", protocol=protocol.stem, overlays=overlays)
    if words is not None:
        space, access = words
        rest += _fill_skeleton("registers", access=access, space=f"    space: {space}\n" if space else "")
    paths = (folder / PROTOCOLS).glob("*.yaml")
    own = {f"{PROTOCOLS}/{path.name}": regular_file.content(path, LARGEST_FILE) for path in paths}
    files = spec_files.with_protocols({**own, f"{name}/{MAIN}": (head + rest).encode("utf-8")})
    return rest + "".join(f"{line}\n" for line in first_example.examples(name, files))


def _folder(specs_option: str | None) -> Path:
    """The folder of the new device: the one that the option names, or `specs` here, also while it is empty or missing.

    Specs of a parent folder are taken where there is no `specs` here.
    """
    stated_folder = specs_option or os.environ.get(specs.VARIABLE)
    if stated_folder and not Path(stated_folder).exists():
        return Path(stated_folder)
    if not stated_folder and Path(specs.FOLDER).is_dir():
        return Path(specs.FOLDER)
    folder = spec_files.folder_or_none(specs_option)
    return Path(specs.FOLDER if folder in (None, INSTALLED) else folder)


def _bring_protocols(folder: Path, name: str) -> None:
    """Copies a protocol of fieldspec, and those that it uses, unless they are there already."""
    own = spec_files.bundled_protocols()
    waiting = [name]
    for protocol in waiting:
        path = f"{PROTOCOLS}/{protocol}.yaml"
        if (folder / path).exists() or protocol not in own:
            continue
        data = regular_file.content(own[protocol], LARGEST_FILE)
        tree, _ = parsed(decoded(path, data)[0])
        if isinstance(tree, Mapping):
            used = (use.values.get("protocol") for use in mappings(tree.values.get("uses")))
            waiting += [use.text for use in used if isinstance(use, Scalar) and use.text not in waiting]
        write(folder / path, data, new=True)
        print_line(specs.relative_path(folder / path))


_FORMS = {
    "device_id": "use lower-case words joined by single hyphens or underscores",
    "version": "use letters and digits, joined by single dots, hyphens or underscores, such as 2.1",
}


def _fits(text: str, form: str, subject: str) -> None:
    part = schema()["$defs"][form]
    if fault := file_name_fault(text):
        raise UsageError(f"{text} is not a valid name of {subject}: it {fault}; choose another one")
    if not re.fullmatch(part["pattern"], text) or len(text) > part["maxLength"]:
        raise UsageError(f"{text} is not a valid name of {subject}: {_FORMS[form]}")


def _fill_skeleton(skeleton: str, **words: str) -> str:
    text = resources.files("fieldspec.command.skeletons").joinpath(f"{skeleton}.yaml").read_text("utf-8")
    return Template(text).substitute(words)
