"""Loads the outputs and checks of installed packages, and guards the compiler against what is wrong with them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from importlib import import_module
from typing import Any

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.console.usage import UsageError
from fieldspec.command.packages.plugins import CHECKS as CHECK_GROUP
from fieldspec.command.packages.plugins import FAILURES, Plugin, plugins
from fieldspec.command.packages.plugins import OUTPUTS as OUTPUT_GROUP
from fieldspec.foundation.names import folded
from fieldspec.foundation.reserved import file_name_fault
from fieldspec.foundation.source import Span
from fieldspec.foundation.spreadsheet import Workbook
from fieldspec.language.diagnostics import Diagnostic, Label, Severity
from fieldspec.language.model.device import Device
from fieldspec.targets import BUILT_IN, OUTPUTS, Files, Output


def load_outputs(anew: bool = False) -> None:
    """Adds the outputs of installed packages to fieldspec's own outputs. Raises UsageError."""
    installed = plugins(OUTPUT_GROUP, BUILT_IN, anew)
    for name in [name for name in OUTPUTS if name not in BUILT_IN]:
        del OUTPUTS[name]
    for name, plugin in installed.items():
        OUTPUTS[name] = Output(name, f"of the package {plugin.package}", backend=PluginBackend(plugin))


def outputs_help(arguments: Sequence[str]) -> str:
    """The outputs in `build --help`, including outputs of installed packages. Raises UsageError."""
    load_outputs()
    titles = {
        name: output.backend.title() if isinstance(output.backend, PluginBackend) else output.title
        for name, output in OUTPUTS.items()
    }
    return "The outputs are " + "; ".join(f"{name}: {title}" for name, title in titles.items()) + "."


class PluginBackend:
    """The module of an output in an installed package. Where it fails, a UsageError names the package."""

    def __init__(self, plugin: Plugin) -> None:
        self.plugin = plugin

    def files(self, versions: Sequence[DeviceLayout]) -> Files:
        """The files for all versions of one device. Raises UsageError."""
        return _checked_files(self.plugin, self._call("files", versions))

    def shared(self) -> Files:
        """The files that belong to no device, none where the module has no such function. Raises UsageError."""
        return _checked_files(self.plugin, self._call("shared")) if hasattr(self._module(), "shared") else {}

    def refusals(self, versions: Sequence[DeviceLayout]) -> list[Diagnostic]:
        """What forbids the files, nothing where the module has no such function. Raises UsageError."""
        if not hasattr(self._module(), "refusals"):
            return []
        return _checked_findings(self.plugin, self._call("refusals", versions))

    def title(self) -> str:
        """The description of the output in one line. Raises UsageError."""
        return str(self._module().TITLE)

    def _module(self) -> Any:
        module = loaded(self.plugin)
        title = getattr(module, "TITLE", None)
        if not isinstance(title, str) or not title.isprintable() or not callable(getattr(module, "files", None)):
            raise self.plugin.error(
                f"the module {self.plugin.value} needs a text TITLE of one line and a function files"
            )
        return module

    def _call(self, function: str, *arguments: object) -> Any:
        try:
            return getattr(self._module(), function)(*arguments)
        except UsageError:
            raise
        except FAILURES as error:
            raise self.plugin.failed(error) from error


def _checked_files(plugin: Plugin, files: Any) -> Files:
    """The files of an output, if they are what an output may give: texts and workbooks, by paths below its folder."""
    if not isinstance(files, dict):
        raise plugin.error("its files are not a dict of contents by path")
    for path, value in files.items():
        if not isinstance(path, str):
            raise plugin.error(f"{path!r} is not a path of a file below the folder of the output")
        for fault in filter(None, map(file_name_fault, path.split("/"))):
            raise plugin.error(f"{path!r} is not a path of a file below the folder of the output: a name in it {fault}")
        if not isinstance(value, (str, Workbook)):
            raise plugin.error(f"the content of {path} is neither a text nor a workbook")
        _refuse_content(plugin, path, value)
    _refuse_same_places(plugin, files)
    return files


def _refuse_content(plugin: Plugin, path: str, content: str | Workbook) -> None:
    if isinstance(content, str):
        try:
            content.encode("utf-8")
        except UnicodeError:
            raise plugin.error(
                f"the content of {path} is not a text in UTF-8: it has half of a surrogate pair"
            ) from None
        return
    from fieldspec.tools.lists.workbook_writer import packed

    try:
        packed(content)  # the pipeline does so again, where nobody knows whose workbook it is
    except Exception as error:
        raise plugin.error(f"the workbook {path} cannot be packed: {type(error).__name__}: {error}") from None


def _refuse_same_places(plugin: Plugin, paths: Iterable[str]) -> None:
    """Refuses paths that some file system cannot have beside each other."""
    by_place: dict[str, str] = {}
    for path in paths:
        if (other := by_place.setdefault(folded(path), path)) != path:
            raise plugin.error(f"{path!r} and {other!r} are one file on some systems")
    for place in by_place:
        for end in (index for index, sign in enumerate(place) if sign == "/"):
            if (file := by_place.get(place[:end])) is not None:
                raise plugin.error(f"{file!r} is a file and a folder")


def refuse_same_files(name: str, owners: Iterable[tuple[str, Iterable[str]]]) -> None:
    """Refuses an output of a package that gives a file twice: for two devices, or for one and for none.

    `owners` are devices with the paths of their files. Raises UsageError.
    """
    backend = OUTPUTS[name].backend
    if not isinstance(backend, PluginBackend):
        return
    by_place: dict[str, str] = {}
    for owner, paths in owners:
        for path in paths:
            if (other := by_place.setdefault(folded(path), owner)) != owner:
                raise backend.plugin.error(f"it gives {path} for {other} and for {owner}; each needs a path of its own")


def _checked_findings(plugin: Plugin, findings: Any) -> list[Diagnostic]:
    try:
        result = list(findings)
    except UsageError:
        raise
    except FAILURES as error:
        raise plugin.failed(error) from error
    for finding in result:
        if not isinstance(finding, Diagnostic):
            raise plugin.error("it yields something that is not a Diagnostic")
        for attribute, kind, noun in _FINDING:
            if not isinstance(getattr(finding, attribute), kind):
                raise plugin.error(f"the {attribute} of its finding is not a {noun}")
        if not isinstance(finding.labels, tuple) or not all(isinstance(label, Label) for label in finding.labels):
            raise plugin.error("the labels of its finding are not a tuple of Label objects")
    return result


_FINDING = (
    ("code", str, "text"),
    ("message", str, "text"),
    ("help", str, "text"),
    ("span", Span, "Span"),
    ("severity", Severity, "Severity"),
)
"""The types of what a finding has."""


def loaded(plugin: Plugin) -> Any:
    """The module, or the object in a module, that an entry point refers to. Raises UsageError."""
    module, _, path = plugin.value.partition(":")
    try:
        target: Any = import_module(module.strip())
        for name in filter(None, path.partition("[")[0].strip().split(".")):
            target = getattr(target, name)
    except FAILURES as error:  # whatever it raises, it is the package that is broken
        raise plugin.failed(error) from None
    return target


def load_checks(anew: bool = False) -> None:
    """Adds the checks of installed packages to fieldspec's own checks. Raises UsageError."""
    from fieldspec.language.checks import table

    table.INSTALLED.clear()
    if not plugins(CHECK_GROUP, (), anew):
        return
    from fieldspec.command import rules

    built_in = {rule.code for rule in (*rules.all_rules(), *rules.change_rules())}
    for name, plugin in plugins(CHECK_GROUP, built_in, anew).items():
        function = loaded(plugin)
        if not callable(function):
            raise plugin.error(f"{plugin.value} is not a function")
        try:
            rules.check_rule(name, function)
        except ValueError as error:
            raise plugin.error(str(error)) from None
        table.INSTALLED[name] = _guard_check(plugin, function)


def _guard_check(plugin: Plugin, function: Callable[[Device], Iterator[Diagnostic]]) -> Any:
    """A check whose failures name its package, and whose findings have its code."""

    def check(device: Device) -> Iterator[Diagnostic]:
        try:
            findings = function(device)
        except FAILURES as error:
            raise plugin.failed(error) from error
        for finding in _checked_findings(plugin, findings):
            if finding.code != plugin.name:
                raise plugin.error(f"its finding has the code {finding.code}, and not {plugin.name}")
            yield finding

    check.__module__, check.__doc__ = function.__module__, function.__doc__
    return check
