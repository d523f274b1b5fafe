"""Where the facts of a telegram are in its port, and the bits of its request."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import FieldLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.enums import Bit
from fieldspec.language.model.operand import Operand, Operands
from fieldspec.language.model.watches import STARTING
from fieldspec.targets.controllers.routines.blocks.operands import NoBlock
from fieldspec.targets.controllers.routines.blocks.ports import axis_key, member
from fieldspec.targets.controllers.routines.blocks.standard import BlockDraft
from fieldspec.targets.controllers.routines.blocks.words import masked
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import Expression, Member
from fieldspec.targets.controllers.statements.routine import Statement

_REQUEST, _RESPONSE = "request", "response"


@dataclass(frozen=True, slots=True)
class RequestBit:
    """A bit of the request: the word it is in, and the roles of its fact."""

    word: Expression
    bit: Bit
    roles: frozenset[str]

    def put(self, on: bool) -> Statement:
        """The statement that sets or clears the bit."""
        return masked(self.word, [self.bit], on)


class TelegramPlaces:
    """The members of a telegram's port, by the facts that they hold."""

    def __init__(self, world: World, operands: Operands, draft: BlockDraft, message: MessageLayout) -> None:
        self.world, self.operands, self.message = world, operands, message
        self.axis = draft.struct("Axis", axis_key(message), "the same for all blocks of the telegram")
        draft.slots["Axis"] = self.axis
        self.valid = self._member("valid")

    def _member(self, name: str) -> Member:
        return member(self.world, axis_key(self.message), name, self.axis)

    def starting(self) -> list[Operand]:
        """The bits of the request that start something or keep it going."""
        path = f"messages/{self.message.name}/{_REQUEST}/"
        return [
            operand
            for operand in self.operands.all
            if operand.path.startswith(path) and STARTING & {*operand.roles} and operand.bit is not None
        ]

    def seen(self, operand: Operand) -> Expression | None:
        """The member for an operand in the request or the response; None where they do not have it."""
        try:
            return self.place(operand)[0]
        except NoBlock:
            return None

    def place(self, operand: Operand) -> tuple[Expression, FieldLayout]:
        """The member of the port for the field of an operand. Raises NoBlock where there is none."""
        for name, record in ((_REQUEST, self.message.request), (_RESPONSE, self.message.response)):
            for field in record.fields:
                if field.field is operand.holder and field.value is not None:
                    struct = self._member(name)
                    kind = self.world.type_of(field.value)
                    return Member(struct, self.world.member(record.name, field.name), kind), field
        raise NoBlock(f"{operand.path} is not in {self.message.name}")

    def bit(self, operand: Operand) -> RequestBit:
        """The bit of the request for an operand. Raises NoBlock for what is not a bit."""
        if operand.bit is None:
            raise NoBlock(f"{operand.path} is not a bit")
        word, _ = self.place(operand)
        return RequestBit(word, operand.bit, frozenset(operand.roles))


def cleared(bits: Sequence[RequestBit]) -> list[Statement]:
    """The statements that clear bits, one for each word."""
    words: dict[Expression, list[Bit]] = {}
    for bit in bits:
        words.setdefault(bit.word, []).append(bit.bit)
    return [masked(word, of_word, False) for word, of_word in words.items()]
