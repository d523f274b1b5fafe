"""The evidence of one unit about each fact."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator

from fieldspec.codec.explain.occupants import forbidden_text
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.fact import Fact
from fieldspec.tools.evidence.observables import READ, WRITE, Observable, Observables
from fieldspec.tools.evidence.unit_evidence import Series, UnitEvidence

NEVER, NOTHING, CONSISTENT, OBSERVED, CONTRADICTED = (
    "never seen",
    "proves nothing",
    "consistent",
    "observed",
    "contradicted",
)
STATES = (NEVER, NOTHING, CONSISTENT, OBSERVED, CONTRADICTED)
"""The states of a fact. Each one outweighs those before it."""

ADDRESS, ACCESS, VALUE, RANGE, SCALE, MEMBER, BIT = "address", "access", "value", "range", "scale", "member", "bit"

_TROUBLES = {
    "unknown_value": "a codec refuses the value",
    "wrong_const": "the constant is another one",
    "unlisted_member": "the enum does not list the value",
    "unlisted_bits": "bits are set that are not listed",
}
_OUTSIDE = "outside of the range"
_IN_STEP = 3
"""The values that a remark names of those that change in step."""

Aspect = tuple[str, str]
"""The path of a fact, and what of it can be observed."""


@dataclass(frozen=True, slots=True)
class Observation:
    """What evidence says of one aspect of a fact: the state, how often and where it was seen, with which values."""

    state: str
    count: int = 0
    values: str = ""
    where: str = ""
    remark: str = ""


UNSEEN = Observation(NEVER)


def strongest(observations: Iterable[Observation]) -> Observation:
    """Several observations as one: the state that outweighs the others, and how often that was seen."""
    own = list(observations)
    best = max(own, key=lambda observation: (STATES.index(observation.state), observation.count), default=UNSEEN)
    return Observation(
        best.state,
        sum(observation.count for observation in own if observation.state == best.state),
        best.values,
        best.where,
        best.remark,
    )


def aspects(observables: Observables) -> dict[Aspect, Fact]:
    """All that can be observed of a device, in the order of the spec."""
    result: dict[Aspect, Fact] = {}
    device = observables.layout.device
    for item in observables.all:
        path = item.fact.place.path
        if item.address is not None:
            result.setdefault((path, ADDRESS), item.fact)
        if item.access:
            result.setdefault((path, ACCESS), item.fact)
        result.setdefault((path, VALUE), item.fact)
        if item.value.ranges is not None:
            result.setdefault((path, RANGE), item.fact)
        if item.value.scaled or item.value.unit:
            result.setdefault((path, SCALE), item.fact)
        enum = device.enums.get(item.value.enum)
        for member in enum.members if enum is not None else ():
            result.setdefault((member.place.path, MEMBER), member)
        flags = device.flags.get(item.value.flags)
        for bit in flags.bits if flags is not None else ():
            if not bit.reserved:
                result.setdefault((bit.place.path, BIT), bit)
    return result


def observations(unit: UnitEvidence, observables: Observables) -> dict[Aspect, Observation]:
    """The verdict of a unit on each aspect with evidence."""
    by_aspect: dict[Aspect, list[Observation]] = {}
    for aspect, observation in _UnitJudge(unit, observables).observations():
        by_aspect.setdefault(aspect, []).append(observation)
    return {aspect: strongest(own) for aspect, own in by_aspect.items()}


class _UnitJudge:
    def __init__(self, unit: UnitEvidence, observables: Observables) -> None:
        self.unit, self.layout = unit, observables.layout
        aliases = {item.fact.place.path: item.same_as for item in observables.all if item.same_as}
        self.in_step = _in_step(unit.series, aliases)
        self.bits_in_step = _in_step(unit.bits, {})
        self.items = list({(item.fact.place.path, item.value.enum): item for item in observables.all}.values())

    def observations(self) -> Iterator[tuple[Aspect, Observation]]:
        """All observations."""
        by_fact: dict[str, dict[tuple[str, str], Series]] = {}
        for (fact, path, operation), series in self.unit.series.items():
            by_fact.setdefault(fact, {})[path, operation] = series
        for item in self.items:
            fact = item.fact.place.path
            own = by_fact.get(fact, {})
            if item.address is not None:
                yield from self._address(item, own)
            if item.access:
                yield from self._access(item, own)
            for (path, operation), series in own.items():
                yield from self._value(item, path, operation, series)
            yield from self._troubles(item)
        for (fact, path, operation), series in self.unit.bits.items():
            yield (fact, BIT), self._of_series(series, self.bits_in_step.get((fact, path, operation), ()))

    def _refused(self, item: Observable, operation: str) -> Counter[str]:
        refusals: Counter[str] = Counter()
        for (fact, _, own), names in self.unit.refusals.items():
            if fact == item.fact.place.path and own == operation:
                refusals.update(names)
        return refusals

    def _address(self, item: Observable, own: dict[tuple[str, str], Series]) -> Iterator[tuple[Aspect, Observation]]:
        aspect = (item.fact.place.path, ADDRESS)
        for series in own.values():
            yield aspect, Observation(OBSERVED, series.count, "", series.where, "it answers")
        refused = self._refused(item, READ)
        if refused and not own and item.access != "wo":
            names = ", ".join(sorted(refused))
            yield (
                aspect,
                Observation(CONTRADICTED, sum(refused.values()), "", "", f"every read was refused with {names}"),
            )

    def _access(self, item: Observable, own: dict[tuple[str, str], Series]) -> Iterator[tuple[Aspect, Observation]]:
        aspect = (item.fact.place.path, ACCESS)
        operations = {operation: series for (_, operation), series in own.items()}
        for operation, series in operations.items():
            objection = forbidden_text(operation, item.access)
            if objection:
                done = "read" if operation == READ else "written"
                remark = f"the spec says that it {objection}, and it was {done}"
                yield aspect, Observation(CONTRADICTED, series.count, series.text, series.where, remark)
        count = sum(series.count for series in operations.values())
        place_text = next((series.where for series in operations.values()), "")
        other = {"ro": WRITE, "wo": READ}.get(item.access, "")
        refused = self._refused(item, other) if other else Counter()
        if item.access == "rw" and {READ, WRITE} <= operations.keys():
            yield aspect, Observation(OBSERVED, count, "", place_text, "reads and writes were answered")
        elif operations and refused:
            remark = f"a {other} was refused with {', '.join(sorted(refused))}"
            yield aspect, Observation(OBSERVED, count, "", place_text, remark)
        elif operations:
            names = " and ".join(f"{operation}s" for operation in sorted(operations))
            yield aspect, Observation(CONSISTENT, count, "", place_text, f"only {names} were answered")

    def _value(
        self, item: Observable, path: str, operation: str, series: Series
    ) -> Iterator[tuple[Aspect, Observation]]:
        fact = item.fact.place.path
        partners = self.in_step.get((fact, path, operation), ())
        yield (fact, VALUE), self._of_series(series, partners)
        if item.value.ranges is not None:
            yield (fact, RANGE), _fitting(series, "it was always 0, which says nothing of the range")
        if item.value.scaled or item.value.unit:
            yield (fact, SCALE), _fitting(series, "it was always 0, which fits any scale")
        enum = self.layout.device.enums.get(item.value.enum)
        for member in enum.members if enum is not None else ():
            if member.value not in series.labels:
                continue
            text, place_text = str(member.value), series.where
            if series.changes:
                observation = Observation(OBSERVED, 1, text, place_text, f"{path} had it among other values")
            else:
                observation = Observation(NOTHING, 1, text, place_text, f"{path} always had it")
            yield (member.place.path, MEMBER), observation

    @staticmethod
    def _of_series(series: Series, partners: Iterable[str]) -> Observation:
        """The observation that a series is of the value of a fact."""
        names = list(partners)
        if not series.changes:
            remark = f"it was always {series.text}, so it cannot be distinguished from other values"
            return Observation(NOTHING, series.count, series.text, series.where, remark)
        if names:
            rest_text = f" and {len(names) - _IN_STEP} more" if len(names) > _IN_STEP else ""
            remark = f"it changes in step with {', '.join(names[:_IN_STEP])}{rest_text}; they cannot be distinguished"
            return Observation(NOTHING, series.count, series.text, series.where, remark)
        return Observation(OBSERVED, series.count, series.text, series.where)

    def _troubles(self, item: Observable) -> Iterator[tuple[Aspect, Observation]]:
        own = item.fact.place.path
        for (fact, path, verdict), trouble in self.unit.troubles.items():
            if fact == own:
                aspect = RANGE if verdict == "out_of_range" and item.value.ranges is not None else VALUE
                remark = _TROUBLES.get(verdict, _OUTSIDE)
                if path != item.fact.name:
                    remark = f"{path}: {remark}"
                values = ", ".join(trouble.values)
                yield (fact, aspect), Observation(CONTRADICTED, trouble.count, values, trouble.where, remark)


def _fitting(series: Series, nothing: str) -> Observation:
    """The verdict of a series on a scale or a range, which a single value cannot confirm."""
    if series.is_zero:
        return Observation(NOTHING, series.count, "0", series.where, nothing)
    return Observation(CONSISTENT, series.count, series.text, series.where)


def _in_step(
    all_series: dict[tuple[str, str, str], Series], aliases: dict[str, str]
) -> dict[tuple[str, str, str], list[str]]:
    """For each series that changes: the names of other facts whose series change at the same moments."""
    groups: dict[tuple[int, int], list[tuple[str, str, str]]] = {}
    for key, series in all_series.items():
        if series.changes:
            groups.setdefault((series.pattern, len(series.labels)), []).append(key)
    result: dict[tuple[str, str, str], list[str]] = {}
    for keys in groups.values():
        for fact, path, operation in keys if len(keys) > 1 else ():
            other_names = {
                other: _name(other, other_path)
                for other, other_path, _ in keys
                if other != fact and other_path != aliases.get(fact) and path != aliases.get(other)
            }
            if other_names:
                result[fact, path, operation] = list(other_names.values())
    return result


def _name(fact: str, path: str) -> str:
    """A bit by its own path, everything else as dumps and captures name it."""
    return fact if "/bits/" in fact else path
