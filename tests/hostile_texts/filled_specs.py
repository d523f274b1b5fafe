"""Specs of which every text is replaced: by poison, and by harmless texts of the same form."""

from __future__ import annotations

import random
from collections.abc import Callable
from functools import cache

import yaml

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.diagnostics import has_errors
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.project import read
from hostile_texts.poison import poison
from layouts import SPECS, TEST_SPECS, layout_at

TEXTS = {
    *("vendor", "title", "doc", "label", "printed_name", "edition", "reason", "clause", "how", "notes", "cause"),
    *("remedies", "problem", "zero", "one", "cells", "text", "not_applicable", "inferred", "allow", "assumed"),
}
"""The keys whose values are texts for people; below some of them are lists or mappings of texts."""
NAMED = {"device", "standard"}
"""The keys of mappings whose `name` is a text."""
SECTIONS = {"registers", "records", "messages", "links", "enums", "flags", "parameters", "tables", "signals"}
ADDED = ("label", "doc", "notes")
"""The texts that every fact of these sections may have."""


class Texts:
    """Texts in turn from a generator of pseudo-random numbers; no two are the same."""

    def __init__(self, seed: str, form: Callable[[str], str]) -> None:
        self.chance, self.form, self.count = random.Random(seed), form, 0

    def next(self) -> str:
        """The next text. Its number is in front of it or after, in letters, so that either end is poison at times."""
        self.count += 1
        number = "".join(chr(ord("a") + int(digit)) for digit in str(self.count))
        text = self.form(poison(self.chance))
        return f"{number} {text}" if self.count % 3 else f"{text} {number}"


class Filling:
    """Replaces the texts of a spec file, and adds those that facts of some sections may have and lack.

    It works on nodes of YAML, so that everything else stays as it is written.
    """

    def __init__(self, texts: Texts) -> None:
        self.texts, self.seen = texts, set[int]()

    def fill(self, node: yaml.Node, path: tuple[str, ...] = ()) -> None:
        """Replaces the texts of a node, once where it is at several places."""
        if id(node) in self.seen or (path[:1] == ("examples",) and "values" in path):
            return
        self.seen.add(id(node))
        if isinstance(node, yaml.SequenceNode):
            for item in node.value:
                self.fill(item, path)
        elif isinstance(node, yaml.MappingNode):
            keys = [key.value for key, _ in node.value]
            for key, value in node.value:
                is_name = key.value == "name" and path[-1:] and path[-1] in NAMED
                if is_name or (key.value in TEXTS and not _has_facts(value)):
                    self._replace(value)
                else:
                    self.fill(value, (*path, key.value))
            if path[:1] and path[0] in SECTIONS and {"name", "source"} <= {*keys} and path[-1] != "sentinels":
                node.value += [(_text(key), self._added(key)) for key in ADDED if key not in keys and "<<" not in keys]

    def _replace(self, node: yaml.Node) -> None:
        if id(node) in self.seen:
            return
        self.seen.add(id(node))
        if isinstance(node, yaml.ScalarNode):
            node.value, node.style = self.texts.next(), '"'
        elif isinstance(node, yaml.SequenceNode):
            for item in node.value:
                self._replace(item)
        elif isinstance(node, yaml.MappingNode):
            for _, value in node.value:
                self._replace(value)

    def _added(self, key: str) -> yaml.Node:
        text = _text(self.texts.next())
        return yaml.SequenceNode("tag:yaml.org,2002:seq", [text]) if key == "notes" else text


def _text(text: str) -> yaml.ScalarNode:
    return yaml.ScalarNode("tag:yaml.org,2002:str", text, style='"')


def _has_facts(node: yaml.Node) -> bool:
    """Whether a value is the section of notes, and not the notes of a fact."""
    return isinstance(node, yaml.SequenceNode) and any(isinstance(item, yaml.MappingNode) for item in node.value)


def filled_files(device: str, seed: int, form: Callable[[str], str]) -> dict[str, bytes]:
    """The files of a made-up device with other texts, and the protocols, by path."""
    texts = Texts(f"{seed} {device}", form)
    files = dict(_protocols())
    for path in sorted((TEST_SPECS / device).glob("*.yaml")):
        node = yaml.compose(path.read_text("utf-8"), Loader=yaml.BaseLoader)
        Filling(texts).fill(node)
        files[f"{device}/{path.name}"] = yaml.serialize(node, Dumper=yaml.BaseDumper, allow_unicode=True).encode()
    return files


@cache
def _protocols() -> dict[str, bytes]:
    paths = [path for root in (SPECS, TEST_SPECS) for path in sorted((root / "protocols").glob("*.yaml"))]
    return {f"protocols/{path.name}": path.read_bytes() for path in paths}


def spec(device: str, seed: int, form: Callable[[str], str] = str) -> DeviceSpec:
    """A made-up device with the texts of a seed, each in another form."""
    project = read(filled_files(device, seed, form), frozenset({device}))
    assert not has_errors(project.findings), [(finding.code, finding.message) for finding in project.findings][:5]
    return project.devices[device]


def layouts(device_spec: DeviceSpec) -> list[DeviceLayout]:
    """The layouts of all versions."""
    return [layout_at(device_spec, version) for version in device_spec.versions()]
