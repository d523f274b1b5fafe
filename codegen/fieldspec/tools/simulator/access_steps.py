"""Requests that access registers in several steps: all are judged before the first one is carried out."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from fieldspec.codec.layout.message import MessageLayout
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.language.model.record import RegisterAccess
from fieldspec.tools.simulator.judging import first_out_of_range
from fieldspec.tools.simulator.refusal import Refusal
from fieldspec.tools.simulator.register_requests import accessed_words, place_words, read_registers, write_registers

if TYPE_CHECKING:
    from typing import Any

    from fieldspec.tools.simulator.engine import Engine


def carry_out_steps(
    engine: Engine, announced: MessageLayout, values: Mapping[str, Any], number: Callable[[Refusal], int]
) -> dict[str, Any]:
    """The values of the response. Raises Refusal, and then nothing is written, unless a rule of the behaviour refuses.

    Steps see what those before them have written. If there are several reasons to refuse the request, the
    reason with the lowest `number` counts.
    """
    steps = announced.message.access_steps
    wrong = first_out_of_range(engine.layout.device, announced.request, values)
    reasons: list[Refusal] = []
    judged = values
    if wrong:
        reads = {
            step.count: min(int(values[step.count]), 1) for step in steps if step.operation == "read" and step.count
        }
        judged = {**values, **reads}
        is_count = any(wrong == step.count for step in steps)
        reasons.append(Refusal("count_invalid" if is_count else "value_invalid", f"{wrong} is out of range"))
    try:
        _judge(engine, steps, judged)
    except Refusal as refusal:
        reasons.append(refusal)
    if reasons:
        raise min(reasons, key=number)
    body: dict[str, Any] = {}
    for step in steps:
        if step.operation == "write":
            access, content = _write(engine, step, values)
            write_registers(engine, access, content)
            continue
        words = read_registers(engine, step, values)
        field = announced.response.named(step.values)
        body[step.values] = words if field is not None and field.is_list else words[0]
    return body


def _judge(engine: Engine, steps: tuple[RegisterAccess, ...], values: Mapping[str, Any]) -> None:
    """Writes the words of all steps and puts the memory back as it was. Raises Refusal."""
    before: list[dict[tuple[str, int], int]] = []
    try:
        for step in steps:
            if step.operation == "write":
                words, _ = place_words(engine, *_write(engine, step, values))
                before.append(words)
            else:
                accessed_words(engine, step, values)
    finally:
        for words in reversed(before):
            engine.memory.words.update(words)


def _write(engine: Engine, step: RegisterAccess, values: Mapping[str, Any]) -> tuple[RegisterAccess, Mapping[str, Any]]:
    """A step that writes as an access with values. What masks leave of a register is what is in the memory now."""
    if not step.and_mask:
        return step, values
    space, (address,) = accessed_words(engine, step, values, "write")
    address = engine.memory.write_place(space, address)
    word, and_mask, or_mask = engine.memory.words[space, address], values[step.and_mask], values[step.or_mask]
    maximum = (1 << 8 * engine.layout.device.space(step.space).unit_size) - 1
    return RegisterAccess("write", step.start, "", "word", step.space), {
        step.start: values[step.start],
        "word": ((word & and_mask) | (or_mask & ~and_mask)) & maximum,
    }
