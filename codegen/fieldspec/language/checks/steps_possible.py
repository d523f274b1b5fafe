"""Every step of a task can be carried out: its target exists exactly once, has the necessary access, and can
have the value.

Why: function blocks and clients consist of these steps. If a step writes a read-only value, or a value
outside its range, the device rejects it or does something else.

Example: `{write: actual_position, argument: position}`, or `{wait: in_position, value: 2}`.

Fix: Name the intended fact by its role or its path, and a value that it can have. Use `pulse` for a bit
whose edge has the effect, and `set` or `clear` for any other bit.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.checks.finding import Findings, enumeration, finding, near
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.fact import ScalarValue
from fieldspec.language.model.operand import Operand, Operands
from fieldspec.language.model.record import Message
from fieldspec.language.model.task import Step, Task, argument_text, value_text
from fieldspec.language.model.value import Value

_ON_BITS = ("set", "clear", "pulse")
_TAKE = {"write": "writes", "wait": "waits for"}


def steps_possible(device: Device) -> Findings:
    if not device.tasks:
        return
    operands = Operands(device)
    timeouts = {limit.place.path: limit for limit in device.limits}
    for task in device.tasks:
        for name in task.messages:
            if name not in device.messages:
                text = f"there is no message `{name}`"
                yield finding(task.place, "messages", text, near(name, device.messages))
        yield from _keys_of_kind(task)
        yield from _bits_of_arguments(task)
        for index, step in enumerate(task.steps):
            yield from _of_step(device, operands, task, step)
            if step.action == "wait" and step.argument:
                yield from _compared(operands, task, index)
            limit = timeouts.get(step.timeout)
            if step.timeout and (limit is None or limit.kind != "timing"):
                text = f"there is no timing `{step.timeout}`" if limit is None else f"{limit.name} is not a timing"
                yield finding(step.place, "timeout", text, "name a limit of the kind `timing` by its path")


def _of_step(device: Device, operands: Operands, task: Task, step: Step) -> Findings:
    yield from _value_present(step)
    known = {message for message in task.messages if message in device.messages}
    for message in sorted(known) or [""]:
        targets = operands.target(step.target, message)
        if len(targets) != 1:
            place_text = f" in {message}" if message else ""
            text = f"there is no `{step.target}`{place_text}"
            help = "add this role to a fact, or name a fact by its path"
            if targets:
                text = f"{enumeration([operand.path for operand in targets])} are `{step.target}`{place_text}"
                help = "name one of them by its path"
            yield finding(step.place, step.action, text, help)
            return
        yield from _on(device, step, targets[0])


def _value_present(step: Step) -> Findings:
    """Findings of a value that the action of a step needs or does not take."""
    takes = step.action in _TAKE
    stated = step.value is not None or bool(step.wanted)
    has = stated or bool(step.argument)
    if takes and not has:
        text = f"the step {_TAKE[step.action]} nothing"
        yield finding(step.place, step.action, text, "add a `value`, or the name of an `argument`")
    elif has and not takes:
        key = "argument" if step.argument else "value"
        yield finding(step.place, key, f"`{step.action}` does not take `{key}`", "remove it")
    if stated and step.argument:
        yield finding(step.place, "argument", "the step has a value and an argument", "remove one of them")
    compares = step.action == "wait" and bool(step.argument)
    for key, used in (("within", step.within is not None), ("relative", step.relative)):
        if used and not compares:
            yield finding(step.place, key, f"`{key}` is for a wait with an argument", "remove it")
    if step.argument_bit is not None and not (step.action == "write" and step.argument):
        text = "`argument_bit` is for a step that writes an argument"
        yield finding(step.place, "argument_bit", text, "remove it")
    if step.action != "send" and (step.values or step.arguments):
        key = "values" if step.values else "arguments"
        yield finding(step.place, key, f"`{step.action}` does not take `{key}`", "only `send` takes it")


def _keys_of_kind(task: Task) -> Findings:
    """Findings of keys that tasks of other kinds have."""
    for key, kind, used in (("halt", "stop", task.halt), ("direction", "jog", bool(task.direction))):
        if used and task.kind != kind:
            yield finding(task.place, key, f"`{key}` is for tasks of the kind `{kind}`", "remove it")


def _bits_of_arguments(task: Task) -> Findings:
    """Findings of an argument whose bits are written one by one: from 0 on, and no other step uses the argument."""
    for argument in task.arguments():
        steps = task.bits_of(argument)
        bits = [step.argument_bit for step in steps]
        if bits != [*range(len(bits))]:
            text = f"the steps write the bit {enumeration([str(bit) for bit in bits])} of {argument_text(argument)}"
            yield finding(steps[0].place, "argument_bit", text, "write each bit once, from 0 on")
        uses = sum(argument in (step.argument, *step.arguments.values()) for step in task.steps)
        if steps and uses > len(steps):
            text = f"other steps use {argument_text(argument)} as a whole"
            yield finding(steps[0].place, "argument_bit", text, "give the number of the bits another name")


def _compared(operands: Operands, task: Task, index: int) -> Findings:
    """Findings of a wait for an argument: an earlier step writes it, and both count alike."""
    step = task.steps[index]
    before = [
        earlier
        for earlier in task.steps[:index]
        if earlier.argument == step.argument or step.argument in earlier.arguments.values()
    ]
    if not before:
        text = f"no earlier step writes the argument {argument_text(step.argument)}"
        yield finding(step.place, "argument", text, "write it, or wait for a value")
        return
    for message in task.messages or ("",):
        for operand in operands.target(step.target, message):
            value = operand.value
            if value is None or not is_count(value.encoding) or value.enum or value.flags:
                text = f"{operand.path} is not a number that can be compared with an argument"
                yield finding(step.place, "wait", text, "name the fact that shows where the device is")
                continue
            for commanded in _argument_targets(operands, before[0], step.argument, message):
                if value.scaled and commanded.value is not None and not _same_count(value, commanded.value):
                    text = f"{operand.path} and {commanded.path} count differently"
                    yield finding(step.place, "wait", text, "name a fact with the same scale and unit")


def _argument_targets(operands: Operands, step: Step, argument: str, message: str) -> Iterator[Operand]:
    """The operands to which a step writes an argument of the task."""
    for operand in operands.target(step.target, message):
        if not isinstance(operand.fact, Message):
            yield operand
            continue
        for field, name in step.arguments.items():
            inner = operands.by_path.get(f"{operand.path}/request/{field}")
            if name == argument and inner is not None:
                yield inner


def _same_count(first: Value, second: Value) -> bool:
    return (first.scale, first.offset, first.unit) == (second.scale, second.offset, second.unit)


def _on(device: Device, step: Step, operand: Operand) -> Findings:
    place = step.place
    if (step.action == "send") != isinstance(operand.fact, Message):
        text = f"{operand.path} is {'a' if step.action != 'send' else 'not a'} message"
        yield finding(place, step.action, text, "messages are sent; other facts are written or read")
    elif isinstance(operand.fact, Message) and not operand.fact.is_requested:
        text = f"only the device sends {operand.path}, of its own accord"
        yield finding(place, step.action, text, "name a message that is sent to the device")
    elif isinstance(operand.fact, Message):
        yield from _check_request(device, step, operand.fact)
    elif step.action in ("read", "wait") and not operand.readable:
        yield finding(place, step.action, f"{operand.path} cannot be read", "name the fact that shows it")
    elif step.action not in ("read", "wait") and not operand.writable:
        yield finding(place, step.action, f"{operand.path} cannot be written", "name the fact that commands it")
    elif step.action in _ON_BITS:
        yield from _on_bit(step, operand)
    elif step.argument_bit is not None and (operand.bit is None or operand.bit.width != 1):
        text = f"{operand.path} is not a bit"
        yield finding(place, step.action, text, "name the bit of a register that takes the bit of the argument")
    else:
        for value in (step.value, *step.wanted):
            if value is not None:
                yield from _valued(device, step, operand, value)


def _on_bit(step: Step, operand: Operand) -> Findings:
    bit = operand.bit
    if bit is None or bit.width != 1:
        text = f"{operand.path} is not a bit"
        yield finding(step.place, step.action, text, "write its value, or name one of its bits")
    elif (bit.edge == "rising") != (step.action == "pulse") and step.action != "clear":
        text = f"the {bit.edge or 'level'}{' edge' if bit.edge else ''} of {operand.path} has the effect"
        yield finding(step.place, step.action, text, "use `pulse` for a rising edge, and `set` for a level")


def _valued(device: Device, step: Step, operand: Operand, value: ScalarValue) -> Findings:
    wrong = _refused(device, operand, value)
    if wrong:
        text = f"{operand.path} cannot be {value_text(value)}: {wrong}"
        yield finding(step.place, "value", text, "use a value that it can have")


def _refused(device: Device, operand: Operand, value: object) -> str:
    """The reason why an operand cannot have a value, or an empty text."""
    bit, content = operand.bit, operand.value
    if isinstance(value, bool):
        return (
            "" if (bit and bit.width == 1) or (content and content.type.name.startswith("bool")) else "it is not a bit"
        )
    enum = device.enums.get(bit.enum if bit else content.enum if content else "")
    if isinstance(value, str):
        names = [member.name for member in enum.members] if enum else []
        names += [sentinel.name for sentinel in content.sentinels] if content else []
        return "" if value in names else f"there is no value with this name, {near(value, names)}"
    if not isinstance(value, int):
        return "raw values are whole numbers"
    if bit is not None:
        return "" if 0 <= value < 1 << bit.width else f"the bits go to {(1 << bit.width) - 1}"
    if enum is not None and not enum.open and value not in {member.value for member in enum.members}:
        return f"{enum.name} has no such value"
    ranges = content.ranges if content is not None else None
    return "" if ranges is None or value in ranges else f"its range is {ranges.text()}"


def _check_request(device: Device, step: Step, message: Message) -> Findings:
    fields = {field.name: field for field in message.request.fields}
    for key, names in (("values", step.values), ("arguments", step.arguments)):
        for name in names:
            if name not in fields:
                text = f"the request of {message.name} has no field `{name}`"
                yield finding(step.place, key, text, near(name, fields))
    for name in step.arguments:
        if name in step.values:
            text = f"{name} has the value {value_text(step.values[name])} and the argument "
            text += argument_text(step.arguments[name])
            yield finding(step.place, "arguments", text, "remove one of them")
    for name, value in step.values.items():
        field = fields.get(name)
        if field is None or isinstance(value, dict | list):
            continue
        operand = Operand("", f"{message.name}.{name}", field, field, field.value, (), False, True)
        wrong = _refused(device, operand, value)
        if wrong:
            text = f"{operand.path} cannot be {value_text(value)}: {wrong}"
            yield finding(step.place, "values", text, "use a value that it can have")
    left = [
        field.name
        for field in message.request.fields
        if field.name not in step.values
        and field.name not in step.arguments
        and not field.reserved
        and field.measures is None
        and (field.value is None or field.value.const is None)
    ]
    if left:
        text = f"there is no value for {enumeration(left)} of {message.name}"
        yield finding(step.place, step.action, text, "add each to `values` or `arguments`")
