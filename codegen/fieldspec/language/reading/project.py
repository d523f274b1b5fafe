"""All specs of a folder: protocols, and devices with their versions."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from collections.abc import Mapping as Table

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.names import Name, folded
from fieldspec.foundation.reserved import file_name_fault
from fieldspec.foundation.source import Refused, Span
from fieldspec.language.diagnostics import Diagnostic, Label
from fieldspec.language.reading.building.context import Reused
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.expansion import expanded
from fieldspec.language.reading.findings import MAIN, PROTOCOLS, VERSIONS, bounded, near, quoted
from fieldspec.language.reading.frames import overlay_with_directions, with_directions
from fieldspec.language.reading.joining import joined, merged_over
from fieldspec.language.reading.memory import DeviceRead, Memory, file_read
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence
from fieldspec.language.reading.overlays import applied
from fieldspec.language.reading.unchanged_nodes import with_unchanged
from fieldspec.language.reading.versions import Lines, overlays, unportable
from fieldspec.language.reading.yaml_reader import key_span

_OF_A_VERSION = ("overlay", "adds", "changes", "removes", "renames")
_NOT_OF_A_DEVICE = ("protocol", *_OF_A_VERSION)
_NOT_OF_A_PROTOCOL = ("device", "versions", "accepts", "audit", "reviews", *_OF_A_VERSION)


DEEPEST_USE = 16
"""How many protocols may are in one chain of uses."""
MOST_USES = 100
"""Protocols that a device or a protocol may use."""
MOST_OVERLAYS = 250
"""Versions of a device that may be written as changes of others, one file per version."""
LARGEST_VERSIONS = 32 * 1024 * 1024
"""Bytes of the files of a device, once for each of its versions: what reading all versions takes grows with it."""

_SHARED = f"{PROTOCOLS}/"


@dataclass(frozen=True, slots=True)
class Project:
    """The devices by id, and what is wrong with the files.

    `broken` are the folders and ids of devices with an error in their files, or in the files of a protocol that they
    use.
    """

    devices: Table[str, DeviceSpec]
    findings: list[Diagnostic]
    broken: frozenset[str] = frozenset()


def read(
    files: Table[str, bytes],
    only: frozenset[str] = frozenset(),
    folder: str = "",
    origins: Table[str, str] | None = None,
    installed: Callable[[], Iterable[str]] = tuple,
    memory: Memory | None = None,
) -> Project:
    """Reads spec files, given by path relative to the specs' folder; of all devices, or of `only` these folders.

    Findings show the files below `folder`, but those that `origins` gives other paths, and name `installed` protocols.
    A project that is read again is read with the `memory` of the last time.
    """
    return _Reader(files, folder, origins or {}, installed, memory).project(only)


def _is_of_a_version(path: str) -> bool:
    return path.split("/")[1] == VERSIONS


class _Reader:
    def __init__(
        self,
        files: Table[str, bytes],
        folder: str,
        origins: Table[str, str],
        installed: Callable[[], Iterable[str]],
        memory: Memory | None,
    ) -> None:
        self.files, self.folder, self.origins, self.installed = files, folder, origins, installed
        self.memory = memory
        self.findings: list[Diagnostic] = []
        self.protocols: dict[str, Mapping | None] = {}
        self.uses: dict[str, set[str]] = {}
        self.folded: dict[str, str] = {}
        """The files that were read, by their paths without the distinctions that some file systems ignore."""
        self.incomplete: set[str] = set()
        """The protocols that lack a protocol that they use; the empty name stands for the last device."""
        self.trees: dict[str, Mapping | None] = {}
        """The results of the files of the last device."""
        self.own_findings = 0
        """How many findings there were when its files had been read."""
        self.faulty: set[str] = set()
        """The protocols in whose files something is wrong."""

    def project(self, only: frozenset[str]) -> Project:
        folders: dict[str, list[str]] = {}
        for path in sorted(self.files):
            folder, _, name = path.partition("/")
            subfolder, _, file = name.rpartition("/")
            if name.endswith(".yaml") and subfolder in ("", VERSIONS) and folder != PROTOCOLS and file:
                folders.setdefault(folder, []).append(path)
        specs: dict[str, DeviceSpec] = {}
        broken: set[str] = set()
        for folder, paths in folders.items():
            if only and folder not in only:
                continue
            remembered = self.memory is not None
            spec, is_broken = self._remembered(folder, paths) if remembered else self._judged(folder, paths)
            if is_broken:
                broken.add(folder)
            if spec is not None:
                specs[folder] = spec
        devices: dict[str, DeviceSpec] = {}
        # An id belongs to the folder that has its name.
        for folder, spec in sorted(specs.items(), key=lambda item: item[0] != item[1].id):
            other = next((device for device in devices.values() if Name.of(device.id) == Name.of(spec.id)), None)
            if other is not None:
                self.findings.append(_same_id(spec, other))
                broken |= {folder} if folder != spec.id else {folder, other.id}
                continue
            devices[spec.id] = spec
            if folder in broken:
                broken.add(spec.id)
        for path in sorted(self.files) if not only else ():
            folder, _, name = path.partition("/")
            if folder == PROTOCOLS and name.endswith(".yaml"):
                self._loaded(name.removesuffix(".yaml"), ())
        return Project(devices, self.findings, frozenset(broken))

    def _judged(self, folder: str, paths: list[str], reused: Reused | None = None) -> tuple[DeviceSpec | None, bool]:
        """A device as its files have it, and whether these or the protocols that it uses have errors.

        `reused` has objects of its model by the nodes that they were built of.
        """
        known = len(self.findings)
        spec = self._device(folder, paths, reused if reused is not None else {})
        return spec, spec is None or len(self.findings) > known or not self.faulty.isdisjoint(self._used(""))

    def _remembered(self, folder: str, paths: list[str]) -> tuple[DeviceSpec | None, bool]:
        """The same as it was read before, where none of its files and no protocol has changed since then."""
        assert self.memory is not None
        contents = {path: data for path, data in self.files.items() if path in paths or path.startswith(_SHARED)}
        before = self.memory.devices.get(folder)
        unclashing = all(self.folded.setdefault(folded(path), path) == path for path in paths)
        if before is not None and before.files == contents and unclashing:
            self.findings += before.findings
            return before.spec, before.is_broken
        known = len(self.findings)
        reused = before.reused() if before is not None else {}
        spec, is_broken = self._judged(folder, paths, reused)
        turns = before.turns + 1 if before is not None and reused else 0
        joined_findings = self.findings[self.own_findings :]
        self.memory.devices[folder] = DeviceRead(
            contents, spec, self.findings[known:], is_broken, turns, self.trees, joined_findings
        )
        return spec, is_broken

    def _tree(self, path: str) -> Mapping | None:
        """The typed tree of one file, or None where it cannot be used."""
        data = self.files[path]
        before = self.memory.files.get(path) if self.memory is not None else None
        if before is not None and before.data == data and not isinstance(data, Refused):
            result = before
        else:
            display_path = self.origins.get(path) or (f"{self.folder}/{path}" if self.folder else path)
            result = file_read(display_path, data, before)
        if self.memory is not None:
            self.memory.files[path] = result
        unportable = [*self._unportable(path, Span(result.file, 0, 0))]
        self.findings += bounded([*result.unread, *unportable] if unportable or result.unread else result.findings)
        is_wrong = unportable or result.unread or result.findings
        return None if unportable or (is_wrong and self.memory is not None and self.memory.strict) else result.tree

    def _unportable(self, path: str, span: Span) -> Iterator[Diagnostic]:
        """Finds what keeps a file from the file systems of some users: a name, and another one like it."""
        for step in path.split("/"):
            if fault := file_name_fault(step):
                text = f"the name {quoted(step)} {fault}"
                yield Diagnostic("file_name_portable", text, span, help="choose another name")
        first = self.folded.setdefault(folded(path), path)
        if first != path:
            text = f"the file cannot be beside `{first}` where names differ in more than small and capital letters"
            yield Diagnostic("file_name_portable", text, span, help="rename one of them")

    def _device(self, folder: str, paths: list[str], reused: Reused) -> DeviceSpec | None:
        main = f"{folder}/{MAIN}"
        paths = sorted(paths, key=lambda path: (path != main, path))
        known = len(self.findings)
        self.trees = trees = {path: self._tree(path) for path in paths}
        self.own_findings = len(self.findings)
        before = self.memory.devices.get(folder) if self.memory is not None else None
        if before is not None and before.spec is not None and self.own_findings > known:
            shared = {path: data for path, data in self.files.items() if path.startswith(_SHARED)}
            if before.has(trees, shared):  # of a file that cannot be read, its last tree stands in again
                self.findings += before.joined
                return before.spec
        unusable = {path for path, tree in trees.items() if tree is None}
        if not self._are_new(folder, unusable):
            return None
        paths = [path for path in paths if path not in unusable]
        own = [path for path in paths if not _is_of_a_version(path)]
        overlay_trees = {path: trees[path] for path in paths if path not in own}
        usable = [own_tree for path in own if (own_tree := trees[path]) is not None]
        if not usable:
            return None
        whole, findings = joined(usable)
        whole, twice = with_directions(whole)
        self.findings += findings + twice
        head = whole.values.get("device")
        if not isinstance(head, Mapping):
            text = f"no file of the folder `{folder}` has the section `device`"
            span = Span(whole.file, 0, 1)
            self.findings.append(Diagnostic("device_section", text, span, help=f"write it in `{main}`"))
            return None
        self.uses[""] = set()
        self.incomplete.discard("")
        files = {path.rpartition("/")[2].removesuffix(".yaml"): tree for path, tree in overlay_trees.items() if tree}
        if len(files) > MOST_OVERLAYS:
            text = f"the device has {len(files)} files of versions; the limit is {MOST_OVERLAYS}"
            help = "write the oldest version that is still in use as the base, and remove those before it"
            span = Span([*files.values()][MOST_OVERLAYS].file, 0, 1)
            self.findings.append(Diagnostic("versions_bounded", text, span, help=help))
            return None
        whole = self._with_protocols(whole, ())
        if "" in self.incomplete:
            return None  # all that the protocol states would seem to be missing
        versions, whole = overlays(files, whole)
        self.findings += bounded(versions.findings)
        lines = Lines(whole)
        self.findings += (
            bounded(lines.findings) + bounded(lines.unknown(whole)) + bounded([*unportable(whole, lines.versions())])
        )
        if len(lines.place) * sum(len(self.files[path]) for path in own) > LARGEST_VERSIONS:
            text = f"{len(lines.place)} versions of a spec of this size exceed the limit"
            help = "remove versions that are not in use any more"
            self.findings.append(Diagnostic("versions_bounded", text, key_span(whole, "versions"), help=help))
            return None
        layers: dict[str, Mapping] = {}
        for version, overlay in versions.trees.items():
            base = versions.bases[version]
            tree = lines.reached(layers.get(base, whole), base, version)
            assert isinstance(tree, Mapping)
            own_overlay, twice = overlay_with_directions(overlay)
            layers[version], findings = applied(tree, own_overlay)
            findings += twice
            missing = lines.unreached(overlay, version, versions.bases)
            self.findings += bounded(findings + lines.unknown(overlay) + missing)
        whole, findings = expanded(whole)
        self.findings += bounded(findings)
        earlier = before.spec if before is not None else None
        whole = with_unchanged(whole, earlier.tree if earlier is not None else None)
        self._placed(whole, head, folder, _NOT_OF_A_DEVICE)
        identity = head.values["id"]
        assert isinstance(identity, Scalar)
        expanded_trees = {}
        for version, tree in layers.items():
            tree, version_findings = expanded(tree)
            expanded_trees[version] = with_unchanged(tree, earlier.trees.get(version) if earlier is not None else None)
            self.findings += bounded([finding for finding in version_findings if finding not in self.findings])
        used = frozenset([*paths, *(f"{PROTOCOLS}/{name}.yaml" for name in self._used(""))])
        picked = dict(earlier.picked) if earlier is not None else {}
        return DeviceSpec(identity.text, whole, lines, expanded_trees, versions.bases, used, picked, reused)

    def _are_new(self, folder: str, paths: set[str]) -> bool:
        """Whether files that cannot be used have been no part of a device yet, which is then judged without them."""
        if not paths or self.memory is None or self.memory.strict:
            return not paths
        before = self.memory.devices.get(folder)
        known = before.spec.files if before is not None and before.spec is not None else None
        return all(path not in known if known is not None else _is_of_a_version(path) for path in paths)

    def _used(self, name: str) -> set[str]:
        """The protocols that a protocol uses, and those that they use; for an empty name, the protocols of the last
        device.
        """
        used: set[str] = set()
        waiting = {name}
        while waiting:
            waiting = {inner for name in waiting for inner in self.uses.get(name, ())} - used
            used |= waiting
        return used

    def _placed(self, tree: Mapping, head: Mapping, name: str, foreign: tuple[str, ...]) -> None:
        """Finds an id that is not the name of the folder or file, and sections that mean nothing there."""
        identity = head.values["id"]
        if isinstance(identity, Scalar) and identity.text != name:
            text = f"the id is {quoted(identity.text)}, the folder or file is `{name}`"
            self.findings.append(Diagnostic("id_matches_path", text, identity.span, help="rename one of them"))
        for key in foreign:
            if key in tree.values:
                text = f"there is no key `{key}` here"
                help = "a file belongs to a device or to a protocol, not to both"
                self.findings.append(Diagnostic("unknown_key", text, key_span(tree, key), help=help))

    def _with_protocols(self, tree: Mapping, users: tuple[str, ...]) -> Mapping:
        """The tree, merged over every protocol that it uses."""
        uses = tree.values.get("uses")
        if isinstance(uses, Sequence) and len(uses.items) > MOST_USES:
            text = f"{len(uses.items)} protocols are used here; the limit is {MOST_USES}"
            help = "combine related protocols into one"
            self.findings.append(Diagnostic("uses_bounded", text, uses.items[MOST_USES].span, help=help))
            return tree
        for use in uses.items if isinstance(uses, Sequence) else ():
            if not isinstance(use, Mapping):
                continue
            name = use.values["protocol"]
            assert isinstance(name, Scalar)
            if name.text not in users:
                self.uses.setdefault(users[-1] if users else "", set()).add(name.text)
            protocol = self._protocol(name, users)
            if protocol is None or name.text in self.incomplete:
                self.incomplete.add(users[-1] if users else "")
            if protocol is not None:
                tree, findings = merged_over(tree, protocol, use)
                self.findings += bounded(findings)
        return tree

    def _protocol(self, name: Scalar, users: tuple[str, ...]) -> Mapping | None:
        if name.text in users:
            chain = " -> ".join((*users, name.text))
            text = f"the protocol uses itself: {chain}"
            self.findings.append(Diagnostic("import_cycle", text, name.span, help="remove one of these uses"))
            return None
        if len(users) >= DEEPEST_USE and name.text not in self.protocols:
            text = f"more than {DEEPEST_USE} protocols are in one chain of uses"
            help = "let each protocol use the ones that it needs directly"
            self.findings.append(Diagnostic("uses_bounded", text, name.span, help=help))
            return None
        path = f"{PROTOCOLS}/{name.text}.yaml"
        if path not in self.files:
            own = (p[len(PROTOCOLS) + 1 : -5] for p in self.files if p.startswith(f"{PROTOCOLS}/"))
            known = sorted({*own, *self.installed()})
            text = f"there is no file `{path}`"
            self.findings.append(Diagnostic("file_missing", text, name.span, help=near(name.text, known)))
            return None
        return self._loaded(name.text, users)

    def _loaded(self, name: str, users: tuple[str, ...]) -> Mapping | None:
        """The tree of a protocol whose file is there, read once."""
        if name not in self.protocols:
            before = len(self.findings)
            tree = self._tree(f"{PROTOCOLS}/{name}.yaml")
            head = tree.values.get("protocol") if tree is not None else None
            if tree is not None and not isinstance(head, Mapping):
                text = "the key `protocol` is missing"
                help = "describe the protocol under the key `protocol`"
                self.findings.append(Diagnostic("missing_key", text, Span(tree.file, 0, 1), help=help))
            elif tree is not None and isinstance(head, Mapping):
                self._placed(tree, head, name, _NOT_OF_A_PROTOCOL)
            if tree is not None:
                tree, findings = with_directions(tree)
                self.findings += findings
            self.protocols[name] = self._with_protocols(tree, (*users, name)) if tree is not None else None
            if len(self.findings) > before:
                self.faulty.add(name)
        return self.protocols[name]


def _same_id(spec: DeviceSpec, other: DeviceSpec) -> Diagnostic:
    """The finding of a device whose id another one has, or one that is the same in generated code."""
    first = Label(_id_span(other.tree), "the first one")
    text = f"two devices have the id `{spec.id}`"
    if other.id != spec.id:
        text = f"the ids `{other.id}` and `{spec.id}` become the same name in generated code"
    return Diagnostic("device_id_unique", text, _id_span(spec.tree), (first,), "change one of them")


def _id_span(tree: Node) -> Span:
    head = tree.values["device"] if isinstance(tree, Mapping) else tree
    identifier = head.values["id"] if isinstance(head, Mapping) else head
    return identifier.span
