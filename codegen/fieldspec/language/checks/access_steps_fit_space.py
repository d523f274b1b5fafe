"""If a message accesses registers in several steps, each step reads or writes words or bytes in the message, or changes
the bits of one register by two masks. All numbers of a step are integers, and no two reads and no two writes share
their `values`.

Why: a simulated device carries out the steps, and explanations show their registers.

Example: a step that writes without `values` and without masks; a step for an address space of coils.

Fix: Correct the keys of the step, and leave out steps that access single bits.
"""

from __future__ import annotations

from collections import Counter

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.address_space import BIT, AddressSpace
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count, is_signed
from fieldspec.language.model.record import Field, Message, RegisterAccess


def access_steps_fit_space(device: Device) -> Findings:
    for message in device.messages.values():
        steps = message.access_steps
        if not steps:
            continue
        if len(steps) == 1 and not steps[0].and_mask:
            text = f"{message.name} has a single access, which clients look for under `accesses`"
            yield finding(message.place, "accesses", text, "state it under `accesses`")
        for (operation, name), times in Counter((step.operation, step.values) for step in steps).items():
            if name and times > 1:
                text = f"{name} are the values of {times} steps that {operation} in {message.name}"
                yield finding(message.place, "accesses", text, "name a field of its own in each step")
        for step in steps:
            if step.space in ("", *device.spaces):
                yield from _step(message, step, device.space(step.space))


def _step(message: Message, step: RegisterAccess, space: AddressSpace) -> Findings:
    does = f"{message.name} {step.operation}s"
    related_labels = () if not space.name else (label(space.place, "name", "the space"),)
    if space.unit == BIT:
        text = f"a step of {does} single bits"
        help = "state a message of one access for the bits"
        yield finding(message.place, "accesses", text, help, *related_labels)
        return
    has_masks = bool(step.and_mask and step.or_mask)
    wrong = ""
    if bool(step.and_mask) != bool(step.or_mask):
        wrong = "with one mask only"
    elif has_masks and (step.operation == "read" or step.values or step.count):
        wrong = "by masks, and has `values` or a `count`" if step.operation == "write" else "by masks"
    elif not has_masks and not step.values:
        wrong = "no `values`"
    if wrong:
        help = "a step has `values`, or writes one register with `and_mask` and `or_mask`"
        yield finding(message.place, "accesses", f"a step of {does} {wrong}", help)
    carried = (step.and_mask, step.or_mask, step.values)
    own = (step.start, step.count, step.and_mask, step.or_mask, step.values if step.operation == "write" else "")
    shared = next((name for name, times in Counter(filter(None, own)).items() if times > 1), "")
    if shared:
        text = f"{shared} is stated for two purposes in a step of {message.name}"
        yield finding(message.place, "accesses", text, "name a field of its own for each purpose")
    holder = message.response if step.operation == "read" else message.request
    for name in filter(None, (step.start, step.count, *carried)):
        record = holder if name == step.values else message.request
        field = record.named(name)
        if field is not None:
            yield from _number_findings(message, field, space, name in carried, name == step.values)
    yield from _count(message, step, message.request.named(step.count) if step.count else None)


def _number_findings(
    message: Message, field: Field, space: AddressSpace, is_carried: bool, may_be_list: bool
) -> Findings:
    """The finding of a field that is not a number, or no register where it `is_carried`."""
    value = field.value
    if value is None or not is_count(value.encoding) or value.flags or (field.is_list and not may_be_list):
        text = f"{field.name} is not a single number, but a step of {message.name} needs one"
        yield finding(field.place, "name", text, "state it as an integer without flags")
    elif is_carried and (value.size != space.unit_size or is_signed(value.encoding)):
        text = f"{field.name} is {value.type.name}, but {message.name} accesses {space.unit}s"
        help = f"use `u{8 * space.unit_size}`, and give the registers their types"
        yield finding(field.place, "type", text, help)


def _count(message: Message, step: RegisterAccess, count: Field | None) -> Findings:
    """The finding of a number of registers that may differ from what a request carries."""
    holder = message.response if step.operation == "read" else message.request
    values = holder.named(step.values) if step.values else None
    if count is None or values is None:
        return
    if count.measures is not None and count.measures.plus:
        text = f"{count.name} is the number of {values.name} plus {count.measures.plus} in {message.name}"
        help = "remove `plus`: what a request asks for is the number of registers"
        yield finding(count.place, "measures", text, help)
    elif step.operation == "write" and count.measures is None:
        text = f"{count.name} may differ from the number of {values.name} in {message.name}"
        help = f"add `measures: {{items: {values.name}}}`: encoders compute it, and decoders compare it"
        yield finding(count.place, "name", text, help, label(values.place, "name", values.name))
