"""What steps act on, as variables of blocks: inputs in physical units, raw numbers beside them, and tests."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.names import Name
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.enums import Bit
from fieldspec.language.model.fact import Fact, ScalarValue
from fieldspec.language.model.operand import Operand
from fieldspec.language.model.task import Step, Task
from fieldspec.language.model.value import Value
from fieldspec.targets.controllers.routines.blocks.standard import BlockDraft
from fieldspec.targets.controllers.routines.named_numbers import joined_bits, mask_of
from fieldspec.targets.controllers.routines.quantities import Quantity, quantities
from fieldspec.targets.controllers.routines.remarks import count_of, of_value
from fieldspec.targets.controllers.routines.scaling import OUT_OF_RANGE, counts_out_of_range
from fieldspec.targets.controllers.routines.world import PREFIXES, World
from fieldspec.targets.controllers.statements.expressions import (
    BITS,
    BOOL,
    LREAL,
    UNSIGNED,
    ArrayType,
    Call,
    Elementary,
    EnumMemberExpression,
    EnumType,
    Expression,
    Operation,
    Shift,
    Truth,
    Type,
    Variable,
    Whole,
    outside,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Condition, Statement, bare, when

_MEASURED = frozenset(
    {
        *("target_position", "target_distance", "target_speed", "target_acceleration", "target_deceleration"),
        *("torque_limit", "jog_speed", "actual_position", "actual_speed", "actual_torque"),
    }
)
"""The roles of what has a unit by its nature. Where a manual prints none, the name of the variable says Counts."""


_WORDS = {"speed": "velocity"}
"""Arguments of tasks that PLCopen calls by another word."""


class NoBlock(Exception):
    """A step that no block can carry out. The text says why, and follows the name of the task in a comment."""


@dataclass(frozen=True, slots=True)
class Scaled:
    """A value with another number in its unit: the words of its functions, what they are made of, and all that have
    these functions.
    """

    name: str
    quantity: Quantity
    same: list[Quantity]


def scaled(world: World, fact: Fact) -> Scaled | None:
    """The functions for the quantity of a fact; None where a count is all there is."""
    for name, same in quantities(world.layout).items():
        for quantity in same:
            if quantity.fact is fact:
                return Scaled(name, quantity, same)
    return None


def kind_of(world: World, operand: Operand, value: Value | None) -> Type:
    """The type of a variable for an operand: BOOL for a bit, a number for several, else that of the value.

    Raises NoBlock where it is an array or has no value.
    """
    if operand.bit is not None:
        return BOOL if operand.bit.width == 1 else UNSIGNED[_bytes(operand.bit.width)]
    if value is None:
        raise NoBlock(f"{operand.path} has no value")
    kind = world.type_of(value)
    if isinstance(kind, ArrayType):
        raise NoBlock(f"{operand.path} is not a single number")
    return kind


def _bytes(bits: int) -> int:
    return next(size for size in UNSIGNED if 8 * size >= bits)


def argument(block: BlockDraft, name: str, operand: Operand, value: Value | None) -> Variable:
    """Declares an argument as an input, and gives the variable that has its raw number while the block works.

    The raw number is made at the start, so that an input may change afterwards.
    """
    world = block.world
    name = _WORDS.get(name, name)
    kind = kind_of(world, operand, value)
    quantity = scaled(world, operand.holder) if operand.bit is None else None
    raw_name = f"{PREFIXES[kind.name] if isinstance(kind, Elementary) else 'e'}{Name.of(name).pascal()}Raw"
    for declared in block.declared:
        if declared.variable == Variable(bare(raw_name), kind):
            return declared.variable
    remark = of_value(value) if operand.bit is None else ""
    if quantity is not None:
        unit = quantity.quantity.value.unit
        description = f"in {unit}; 1 count = {count_of(quantity.quantity.value)}" if unit else remark
        source = block.declare(f"lr{Name.of(name).pascal()}", LREAL, "input", description)
        raw = block.declare(raw_name, kind, "output", "what is sent, in counts")
        parameter = f"{PREFIXES[quantity.quantity.kind.name]}Counts"
        call = Call(
            world.routine(quantity.name, "to_counts"),
            (("lrValue", source),),
            ((parameter, raw),),
            block.status.type,
        )
        block.at_start += _unless_refused(block, _refusing(block, call, block.refuse()))
        return raw
    source = block.declare(world.variable(f"{name}{_counts(operand, value)}", kind), kind, "input", remark)
    raw = block.declare(raw_name, kind, "output", "what is sent")
    block.at_start.append(Assignment(raw, source))
    if isinstance(kind, Elementary) and value is not None and is_count(value.encoding):
        block.at_start += _unless_refused(block, [*_ranged(block, value, raw, kind)])
    return raw


def bit_of_argument(block: BlockDraft, task: Task, step: Step) -> Expression:
    """Whether the bit of an argument is set that a step writes. The argument is an input of all its bits."""
    width = len(task.bits_of(step.argument))
    kind, highest = UNSIGNED[_bytes(width)], (1 << width) - 1
    words = Name.of(step.argument).pascal()
    raw = Variable(bare(f"{PREFIXES[kind.name]}{words}Raw"), kind)
    if all(declared.variable != raw for declared in block.declared):
        source = block.declare(f"{PREFIXES[kind.name]}{words}", kind, "input", f"0..{highest}.")
        raw = block.declare(f"{PREFIXES[kind.name]}{words}Raw", kind, "output", "what is sent")
        block.at_start.append(Assignment(raw, source))
        refused: list[Statement] = [Assignment(block.result, block.status.of("out_of_range")), block.refuse()]
        wrong = outside(raw, [(0, highest)])
        block.at_start += _unless_refused(block, [when(wrong, refused)] if wrong is not None else [])
    bits = BITS[kind.size]
    mask = Whole(1 << (step.argument_bit or 0), bits, True)
    return raw.converted(bits).combined("AND", mask).compared("<>", Whole(0, bits, True))


def unit_of(operand: Operand) -> str:
    """The unit of a fact; `counts` where it has none."""
    value = operand.value
    return value.unit if value is not None and value.unit and value.scaled else "counts"


def _counts(operand: Operand, value: Value | None) -> str:
    has_counts = value is not None and not value.scaled and (not value.unit or bool(value.scale_by))
    measured = has_counts and bool(_MEASURED & {*operand.roles})
    return "_counts" if measured else ""


def _refusing(block: BlockDraft, call: Call, refuse: Statement) -> list[Statement]:
    return [
        Assignment(block.result, call),
        when(block.result.compared("<>", block.status.of("ok")), [refuse]),
    ]


def _unless_refused(block: BlockDraft, statements: list[Statement]) -> list[Statement]:
    """What converts a further argument: left out once one is refused, so that its status is what Diagnostics shows."""
    if not any(isinstance(statement, Condition) for statement in block.at_start) or not statements:
        return statements
    return [when(block.unrefused(), statements)]


def _ranged(block: BlockDraft, value: Value, raw: Variable, kind: Elementary) -> Iterator[Statement]:
    """The statements that refuse a number which may not be written."""
    ranges = value.writable_ranges
    if ranges is None or kind.family not in ("signed", "unsigned"):
        return
    sentinels = [interval for interval in value.special_intervals if not ranges.includes(*interval)]
    wrong = outside(raw, [*ranges.intervals, *sentinels])
    if wrong is not None:
        yield when(wrong, [Assignment(block.result, block.status.of("out_of_range")), block.refuse()])


def outputs_of(block: BlockDraft, name: str, operand: Operand, value: Value | None, raw: Expression) -> list[Statement]:
    """Declares outputs for what was read, and gives the statements that fill them: the quantity and the raw number."""
    world = block.world
    kind = kind_of(world, operand, value)
    if operand.bit is not None:
        output = block.declare(world.variable(name, kind), kind, "output")
        return [Assignment(output, field_of(operand.bit, raw))]
    quantity = scaled(world, operand.holder)
    if quantity is None:
        output = block.declare(
            world.variable(f"{name}{_counts(operand, value)}", kind), kind, "output", of_value(value)
        )
        return [Assignment(output, raw)]
    unit = quantity.quantity.value.unit
    physical = block.declare(f"lr{Name.of(name).pascal()}", LREAL, "output", f"in {unit}" if unit else "")
    assert isinstance(kind, Elementary)
    raw_output = block.declare(f"{PREFIXES[kind.name]}{Name.of(name).pascal()}Raw", kind, "output", of_value(value))
    parameter = f"{PREFIXES[quantity.quantity.kind.name]}Counts"
    filled = [("lrValue", physical)]
    if counts_out_of_range(world, quantity.same, raw) is not None:
        words = Name.of(f"{name}_out_of_range").pascal()
        filled.append(
            (OUT_OF_RANGE, block.declare(f"x{words}", BOOL, "output", "what was read is outside of its stated range"))
        )
    call = Call(world.routine(quantity.name, "from_counts"), ((parameter, raw),), tuple(filled), block.status.type)
    return [Assignment(raw_output, raw), *_refusing(block, call, block.fail("request"))]


def field_of(bit: Bit, word: Expression) -> Expression:
    """A bit of a word as a truth, several as a number."""
    assert isinstance(word.type, Elementary)
    bits = BITS[word.type.size]
    masked = word.converted(bits).combined("AND", mask_of(bit, bits))
    if bit.width == 1:
        return masked.compared("<>", Whole(0, bits, True))
    moved = Shift("SHR", masked, bit.first, bits) if bit.first else masked
    return (joined_bits(bit, word.converted(bits), bits) if bit.pieces else moved).converted(
        UNSIGNED[_bytes(bit.width)]
    )


def holds(world: World, operand: Operand, content: Value | None, value: ScalarValue, read: Expression) -> Expression:
    """Whether what was read has a value: `read` is the word of a bit, else the value itself."""
    if operand.bit is not None and operand.bit.width == 1:
        truth = field_of(operand.bit, read)
        assert isinstance(truth, Operation)
        return truth if value in (True, 1) else truth.operands[0].compared("=", truth.operands[1])
    number = field_of(operand.bit, read) if operand.bit is not None else read
    expected = constant(world, operand, content, value, number.type)
    if isinstance(expected, Truth):
        return number if expected.value else number.compared("=", expected)
    return number.compared("=", expected)


def constant(world: World, operand: Operand, content: Value | None, value: ScalarValue, kind: Type) -> Expression:
    """A value of a step as a literal: a truth, a number in counts, or the name of a member.

    Raises NoBlock where the operand cannot have it.
    """
    if kind == BOOL:
        return Truth(bool(value))
    enum = operand.bit.enum if operand.bit is not None else content.enum if content is not None else ""
    if isinstance(value, str):
        value = _named(world, operand, content, enum, value)
    if isinstance(kind, EnumType):
        for member in world.layout.device.enums[enum].members:
            if member.value == value:
                return EnumMemberExpression(world.names.enum_members[enum][member.name], member.value, kind)
    if not isinstance(kind, Elementary) or not isinstance(value, int) or kind.family == "real":
        raise NoBlock(f"{operand.path} cannot be {value} here")
    number = int(value)
    return Whole(number & kind.high if kind.family == "bits" else number, kind, kind.family == "bits")


def _named(world: World, operand: Operand, content: Value | None, enum: str, name: str) -> int:
    members = world.layout.device.enums[enum].members if enum else ()
    numbers = {member.name: member.value for member in members}
    if content is not None:
        numbers |= {sentinel.name: sentinel.value for sentinel in content.sentinels}
    if name not in numbers:
        raise NoBlock(f"{operand.path} has no value {name}")
    return int(numbers[name])
