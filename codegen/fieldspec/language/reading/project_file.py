"""The project file: what is generated of which devices, read from YAML by its own schema."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from collections.abc import Mapping as Table

from fieldspec.foundation.classes import dataclass
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.choice import (
    ALL,
    DEFAULT_FOLDER,
    NEWEST,
    BlockChoice,
    Choice,
    OutputChoice,
    VersionChoice,
)
from fieldspec.language.reading.findings import bounded, near, quoted
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence
from fieldspec.language.reading.scalars import PROJECT_FILE, typed_at
from fieldspec.language.reading.yaml_reader import decoded, key_span, parsed

_WITH_TESTS = "c"


@dataclass(frozen=True, slots=True)
class ProjectFile:
    """The choices for all devices, and for single ones by id."""

    tree: Mapping | None = None

    def choice(self, device: str) -> Choice:
        """The chosen outputs of a device."""
        if self.tree is None:
            return Choice()
        values = dict(self.tree.values)
        single = values.pop("devices", None)
        own = single.values.get(device) if isinstance(single, Mapping) else None
        if isinstance(own, Mapping):
            values |= own.values
        versions = _versions(values.get("versions"), VersionChoice())
        outputs = values.get("outputs")
        choices = _outputs(outputs, versions) if isinstance(outputs, Mapping) else None
        folder = values.get("folder")
        return Choice(
            choices,
            versions,
            folder.text if isinstance(folder, Scalar) else DEFAULT_FOLDER,
            _blocks(values.get("blocks")),
        )

    def unknown_names(
        self, outputs: Iterable[str], devices: Iterable[str], with_blocks: Collection[str]
    ) -> Iterator[Diagnostic]:
        """The findings of outputs and devices that do not exist, where these do.

        Blocks have no effect on a device without an output `with_blocks`.
        """
        if self.tree is None:
            return
        output_names, device_names = list(outputs), list(devices)
        yield from _unknown_outputs(self.tree, output_names)
        for device, own in self._devices().items():
            if device not in device_names:
                single = self.tree.values["devices"]
                assert isinstance(single, Mapping)
                text = f"there is no device {quoted(device)}"
                yield Diagnostic("unknown_word", text, key_span(single, device), help=near(device, device_names))
            yield from _unknown_outputs(own, output_names)
            chosen = self.choice(device).outputs
            if "blocks" in own.values and chosen is not None and not chosen.keys() & with_blocks:
                help = f"add one of {', '.join(with_blocks)}, or remove the key"
                text = f"{device} has no output with blocks"
                yield Diagnostic("unknown_key", text, key_span(own, "blocks"), help=help)

    def unknown_versions(self, device: str, versions: Iterable[str]) -> Iterator[Diagnostic]:
        """The findings of versions that a device does not have, which has these."""
        own = self._devices().get(device)
        for node in _version_nodes(own) if own is not None else ():
            yield from _unknown_versions(node, device, list(versions))

    def unknown_blocks(self, device: str, known: Table[str, Collection[str]]) -> Iterator[Diagnostic]:
        """The findings of tasks, messages, registers and links that a device does not have, which has these."""
        own = self._devices().get(device)
        blocks = own.values.get("blocks") if own is not None else None
        for key, node in blocks.values.items() if isinstance(blocks, Mapping) else ():
            for item in _words(node):
                if item.text not in known[key]:
                    text = f"{device} has no {key.removesuffix('s')} {quoted(item.text)} that has a block"
                    yield Diagnostic("unknown_word", text, item.span, help=near(item.text, known[key]))

    def _devices(self) -> dict[str, Mapping]:
        """The choices of single devices."""
        single = self.tree.values.get("devices") if self.tree is not None else None
        entries = single.values.items() if isinstance(single, Mapping) else ()
        return {device: own for device, own in entries if isinstance(own, Mapping)}


def read_project_file(path: str, data: bytes) -> tuple[ProjectFile, list[Diagnostic]]:
    """The project file and what is wrong with its form; nothing is chosen where something is."""
    file, findings = decoded(path, data)
    if findings:
        return ProjectFile(), bounded(findings)
    node, findings = parsed(file)
    if node is None:
        return ProjectFile(), bounded(findings)  # an empty file chooses nothing
    tree, findings = typed_at(node, (PROJECT_FILE,))
    if findings or not isinstance(tree, Mapping):
        return ProjectFile(), bounded(findings)
    return ProjectFile(tree), []


def _versions(node: Node | None, otherwise: VersionChoice) -> VersionChoice:
    if isinstance(node, Scalar):
        return VersionChoice(node.text)
    if isinstance(node, Sequence):
        return VersionChoice("", tuple(item.text for item in node.items if isinstance(item, Scalar)))
    return otherwise


def _words(node: Node | None) -> list[Scalar]:
    items = node.items if isinstance(node, Sequence) else ()
    return [item for item in items if isinstance(item, Scalar)]


def _blocks(node: Node | None) -> BlockChoice | None:
    if not isinstance(node, Mapping):
        return None
    return BlockChoice(**{key: tuple(item.text for item in _words(own)) for key, own in node.values.items()})


def _outputs(node: Mapping, versions: VersionChoice) -> dict[str, OutputChoice]:
    choices = {}
    for name, own in node.values.items():
        values = own.values if isinstance(own, Mapping) else {}
        chosen = _versions(values.get("versions"), versions)
        choices[name] = OutputChoice(chosen, _versions(values.get("tests"), VersionChoice()))
    return choices


def _unknown_outputs(node: Mapping, known: list[str]) -> Iterator[Diagnostic]:
    outputs = node.values.get("outputs")
    for name, own in outputs.values.items() if isinstance(outputs, Mapping) else ():
        assert isinstance(outputs, Mapping)
        if name not in known:
            text = f"there is no output {quoted(name)}"
            yield Diagnostic("unknown_word", text, key_span(outputs, name), help=near(name, known))
        elif name != _WITH_TESTS and isinstance(own, Mapping) and "tests" in own.values:
            text = f"the output {name} has no self-tests and no fuzz targets"
            yield Diagnostic("unknown_key", text, key_span(own, "tests"), help=f"only {_WITH_TESTS} has them")


def _version_nodes(device: Mapping) -> Iterator[Node]:
    """Where a device states versions: for all outputs, and for single ones."""
    outputs = device.values.get("outputs")
    for holder in (device, *(outputs.values.values() if isinstance(outputs, Mapping) else ())):
        if isinstance(holder, Mapping) and "versions" in holder.values:
            yield holder.values["versions"]


def _unknown_versions(node: Node, device: str, known: list[str]) -> Iterator[Diagnostic]:
    words = [ALL, NEWEST] if isinstance(node, Scalar) else known
    for item in node.items if isinstance(node, Sequence) else (node,):
        if isinstance(item, Scalar) and item.text not in words:
            text = f"there is no version {quoted(item.text)} of {device}"
            if isinstance(node, Scalar):
                text = f"`versions` cannot be {quoted(item.text)}"
            hint = near(item.text, words, f"state `{ALL}`, `{NEWEST}`, or a list of {', '.join(known)}")
            yield Diagnostic("unknown_word", text, item.span, help=hint)
        elif not isinstance(item, Scalar):
            yield Diagnostic("wrong_type", "a version must be a text", item.span, help="write its identifier")
