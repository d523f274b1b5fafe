"""Devices without the facts that an output cannot express, and what the output says of them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from fieldspec.codec.layout.absences import Absences, absences
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.refusal import Refusal
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.language.diagnostics import Diagnostic, Severity


@dataclass(frozen=True, slots=True)
class Omission:
    """Something that an output leaves out, such as `message read_texts`, and why."""

    title: str
    reason: str

    @property
    def text(self) -> str:
        """The line of a comment about it."""
        return f"{self.title}: {self.reason}"


@dataclass(frozen=True, slots=True)
class Expressed:
    """The part of a device that an output expresses. `findings` are errors, which forbid it, or warnings of what is
    left out.
    """

    layout: DeviceLayout
    omissions: tuple[Omission, ...]
    findings: tuple[Diagnostic, ...]


def expressed(layout: DeviceLayout, refusals: Sequence[Refusal], reads_exceptions: bool = True) -> Expressed:
    """A device without what an output cannot express; the device itself where that is nothing.

    `reads_exceptions` says whether the output reads exception responses.
    """
    if not refusals:
        return Expressed(layout, (), ())
    absent = absences(layout, refusals, reads_exceptions)
    omissions = tuple(Omission(f"{kind} {name}", causes[0].reason) for kind, name, causes in absent.each())
    return Expressed(_without(layout, absent), omissions, tuple(findings(refusals, absent)))


def findings(refusals: Iterable[Refusal], absent: Absences) -> Iterator[Diagnostic]:
    """The findings of refused facts: errors where they concern frames, otherwise warnings that say what is absent."""
    errors = {id(finding) for finding in absent.findings}
    for finding in {id(refusal.finding): refusal.finding for refusal in refusals}.values():
        if id(finding) in errors:
            yield finding
            continue
        titles = [f"{kind} {name}" for kind, name, causes in absent.each() if any(c.finding is finding for c in causes)]
        if not titles:
            continue  # an equal one, of an anchor in both directions of a message, says it
        yield warning(finding, f"{', '.join(titles)} {'is' if len(titles) == 1 else 'are'} left out")


def warning(finding: Diagnostic, help: str) -> Diagnostic:
    """The finding of a fact that is left out. `help` says what the outputs do, without naming them."""
    return replace(finding, severity=Severity.WARNING, help=help)


def listing(omissions: Sequence[Omission], escaped: Callable[[str], str]) -> list[str]:
    """The lines of a comment about what is left out; none where that is nothing. `escaped` makes texts safe in it."""
    return ["Left out:", *(f"    {escaped(omission.text)}" for omission in omissions)] if omissions else []


def _without(layout: DeviceLayout, absent: Absences) -> DeviceLayout:
    device = layout.device
    messages = {name: message for name, message in layout.messages.items() if name not in absent.messages}
    links = {
        name: replace(
            link,
            messages={other: message for other, message in link.messages.items() if other in messages},
            known=link.messages if any(other not in messages for other in link.messages) else {},
        )
        for name, link in layout.links.items()
    }
    groups = (
        replace(group, registers=tuple(own for own in group.registers if own.name not in absent.registers))
        for group in device.groups
    )
    parameters = {
        name: replace(
            parameter_set,
            parameters=tuple(own for own in parameter_set.parameters if (name, own.name) not in absent.parameters),
        )
        for name, parameter_set in device.parameters.items()
    }
    stated = replace(
        device,
        messages={name: message for name, message in device.messages.items() if name in messages},
        records={name: record for name, record in device.records.items() if name not in absent.records},
        groups=tuple(group for group in groups if group.registers),
        tables={name: table for name, table in device.tables.items() if name not in absent.tables},
        parameters=parameters,
        conversions={name: own for name, own in device.conversions.items() if name not in absent.conversions},
        examples={name: example for name, example in device.examples.items() if example.message not in absent.messages},
    )
    return replace(
        layout,
        device=stated,
        records={name: record for name, record in layout.records.items() if name not in absent.records},
        messages=messages,
        links=links,
        registers=tuple(own for own in layout.registers if own.name not in absent.registers),
        tables={name: table for name, table in layout.tables.items() if name not in absent.tables},
    )
