"""The compiler, step by step: files -> project -> findings -> layouts -> files by path."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.foundation.classes import replace
from fieldspec.language.diagnostics import LEAVE_OUT, Diagnostic, Severity, has_errors, in_order
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.project import Project, read
from fieldspec.targets import OUTPUTS, Files, PageLink
from fieldspec.tools.proofs.equal_lines import equal_versions
from fieldspec.tools.proofs.running import Outcome, proven


def load(files: Mapping[str, bytes], only: frozenset[str] = frozenset()) -> Project:
    """The project of spec files by path, relative to the specs' folder; of all devices, or of those in `only`."""
    return read(files, only)


def checked(project: Project) -> list[Diagnostic]:
    """All findings of all files and devices, in order."""
    device_findings = [finding for spec in project.devices.values() for finding in findings(spec)]
    return in_order([*project.findings, *device_findings])


def layouts(spec: DeviceSpec, ran: Outcome | None = None) -> list[DeviceLayout]:
    """The layouts of all versions of a device that has no findings, the oldest first, and the versions sharing them.

    `ran` is the outcome of running the proofs of the device, where it is known.
    """
    if ran is not None:
        by_version, shared = ran.layouts, ran.shared
    else:
        by_version = {version: device_layout(spec.at(version)[0]) for version in spec.versions()}
        shared = equal_versions(spec, {version: layout.identity for version, layout in by_version.items()})
    return [
        replace(
            by_version[version],
            equal_versions=tuple(version_id for version_id, other in shared.items() if other == version),
        )
        for version in spec.versions()
    ]


def findings(spec: DeviceSpec) -> list[Diagnostic]:
    """The findings of one device at all its versions, beyond the findings of its files."""
    return proven(spec)


def refusals(versions: list[DeviceLayout], names: Iterable[str]) -> list[Diagnostic]:
    """The findings on facts of a device that some outputs cannot express, before any is built: one for each fact.

    Errors forbid an output. Warnings say what it leaves out.
    """
    return merged_refusals(versions[0].device.id, {name: OUTPUTS[name].refusals(versions) for name in names})


def merged_refusals(
    device: str, by_output: Mapping[str, Sequence[Diagnostic]], required: bool = True
) -> list[Diagnostic]:
    """The findings of several outputs about a device: one for each fact, which names the outputs.

    Outputs that are not `required` are left out where they have errors, with one warning for each reason.
    """
    refused = _refused(device, by_output) if required else _left_out(device, by_output)
    return [*refused, *_omissions(by_output)]


def _refused(device: str, by_output: Mapping[str, Sequence[Diagnostic]]) -> Iterator[Diagnostic]:
    """The errors of some outputs, one for each fact."""
    refusing: dict[tuple[str, str, int], list[str]] = {}
    for name, findings in by_output.items():
        for key in dict.fromkeys(_key(finding) for finding in findings if finding.help == LEAVE_OUT):
            refusing.setdefault(key, []).append(name)
    all_refusing = {name for outputs in refusing.values() for name in outputs}
    remaining = ",".join(name for name in by_output if name not in all_refusing)
    fix = f"build the others: `fieldspec build {device} --to {remaining}`" if remaining else LEAVE_OUT
    for name, findings in by_output.items():
        for finding in findings:
            outputs = refusing.get(_key(finding), [name])
            if finding.severity is Severity.ERROR and name == outputs[0]:
                help = f"{', '.join(outputs)} cannot express it; {fix}" if finding.help == LEAVE_OUT else finding.help
                yield replace(finding, help=help)


def _left_out(device: str, by_output: Mapping[str, Sequence[Diagnostic]]) -> Iterator[Diagnostic]:
    """A warning for each first error of some outputs: it says which of them are left out for the device."""
    first_errors: dict[tuple[str, str, int], Diagnostic] = {}
    refusing: dict[tuple[str, str, int], list[str]] = {}
    for name, findings in by_output.items():
        error = next((finding for finding in findings if finding.severity is Severity.ERROR), None)
        if error is not None:
            first_errors.setdefault(_key(error), error)
            refusing.setdefault(_key(error), []).append(name)
    for key, error in first_errors.items():
        outputs = refusing[key]
        all_reasons = f"`fieldspec build {device} --to {','.join(outputs)}` shows all reasons as errors"
        help = f"{', '.join(outputs)} {'is' if len(outputs) == 1 else 'are'} left out for {device}; {all_reasons}"
        yield replace(error, help=help, severity=Severity.WARNING)


def _omissions(by_output: Mapping[str, Sequence[Diagnostic]]) -> Iterator[Diagnostic]:
    """The warnings of some outputs, one for each fact. Its help says what becomes of the fact in which of them."""
    warnings: dict[tuple[str, str, int], Diagnostic] = {}
    deeds: dict[tuple[str, str, int], dict[str, list[str]]] = {}
    for name, findings in by_output.items():
        for finding in findings if not has_errors(findings) else ():  # else nothing is written
            if finding.severity is Severity.WARNING:
                warnings.setdefault(_key(finding), finding)
                outputs = deeds.setdefault(_key(finding), {}).setdefault(finding.help, [])
                if name not in outputs:
                    outputs.append(name)
    for key, finding in warnings.items():
        texts = (f"{', '.join(outputs)}: {deed}" for deed, outputs in deeds[key].items())
        yield replace(finding, help="; ".join(texts))


def _key(finding: Diagnostic) -> tuple[str, str, int]:
    return finding.code, finding.span.file.path, finding.span.start


def outputs(devices: Iterable[list[DeviceLayout]], names: Iterable[str] = tuple(OUTPUTS)) -> dict[str, bytes]:
    """The files of some outputs of some devices, by path relative to the folder of generated files."""
    devices = list(devices)
    contents: dict[str, bytes] = {}
    for name in names:
        contents |= shared(name)
        for versions in devices:
            contents |= output(name, versions)
        contents |= overview(name, list(contents), contents.__getitem__)
    return contents


def overview(name: str, paths: Iterable[str], content: Callable[[str], bytes]) -> dict[str, bytes]:
    """The files of one output that summarize all devices, by path.

    `paths` are the latter below the folder of all outputs, and `content` has the bytes of one of them.
    """
    folder = f"{name}/"
    inner = [path.removeprefix(folder) for path in paths if path.startswith(folder)]
    return _contents(name, {**OUTPUTS[name].overview(inner, lambda path: content(folder + path).decode("utf-8"))})


def output(name: str, versions: list[DeviceLayout], links: Sequence[PageLink] = ()) -> dict[str, bytes]:
    """The files of one output of one device, by path. The index of the documentation also has the `links`."""
    return _contents(name, OUTPUTS[name].files(versions, links))


def shared(name: str) -> dict[str, bytes]:
    """The files of one output that belong to no device, by path."""
    return _contents(name, OUTPUTS[name].shared())


def _contents(name: str, files: Files) -> dict[str, bytes]:
    """The bytes of files by path. A workbook that occurs several times is packed once."""
    workbooks = {id(content): content for content in files.values() if not isinstance(content, str)}
    if workbooks:
        from fieldspec.tools.lists.workbook_writer import packed

        bytes_of = {key: packed(workbook) for key, workbook in workbooks.items()}
    return {
        f"{name}/{path}": content.encode("utf-8") if isinstance(content, str) else bytes_of[id(content)]
        for path, content in files.items()
    }
