"""Brings a device to what a list asks for: compares, writes what differs, and verifies each value."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from fieldspec.codec.layout.value_texts import spec_text
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.tools.carriers.carrier import CarrierError
from fieldspec.tools.live.access import differs
from fieldspec.tools.live.client import Client, NoAnswerError, RefusedError
from fieldspec.tools.live.writing import WriteError

if TYPE_CHECKING:
    from fieldspec.tools.live.access import Access, Assignment, Reading

Progress = Callable[[int], None]


@dataclass(frozen=True, slots=True)
class Change:
    """A value that differs: what the device has, and what is to be there."""

    before: Reading
    chosen: Assignment

    @property
    def path(self) -> str:
        """The path of the value."""
        return self.chosen.path


class TransferError(Exception):
    """A value was not transferred. `uncertain` means that it is unknown whether the device has it."""

    def __init__(self, path: str, detail: str, uncertain: bool = False) -> None:
        super().__init__(f"{path} {detail}")
        self.uncertain = uncertain


def changes(
    access: Access, client: Client, assignments: Sequence[Assignment], done: Progress | None = None
) -> list[Change]:
    """The values that differ from what the device has, in the order of the list.

    A value that the device refuses to show is among them, with its refusal. Raises NoAnswerError and CarrierError.
    """
    present = access.read(client, [access.item(chosen) for chosen in assignments], done)
    return [Change(value, chosen) for value, chosen in zip(present, assignments, strict=True) if differs(chosen, value)]


def transfer(
    access: Access,
    client: Client,
    plan: Sequence[Change],
    before: Callable[[Change], None],
    after: Callable[[Change], None],
) -> None:
    """Writes all changes in their order, each verified before the next one.

    `before` is called before a request that may change the device, `after` when the value has been read back. Raises
    TransferError at the first value that the device does not take over.
    """
    sent_keys: set[object] = set()
    for change in plan:
        before(change)
        try:
            _settle(access, client, change, change.chosen.sent in sent_keys)
        except (NoAnswerError, CarrierError) as error:
            raise TransferError(change.path, f"may be written or not: {error}", uncertain=True) from None
        except (RefusedError, WriteError) as error:
            raise TransferError(change.path, f"is not written: {error}") from None
        sent_keys.add(change.chosen.sent)
        after(change)


def _settle(access: Access, client: Client, change: Change, is_sent: bool) -> None:
    """Writes a value once, with all that shares its words. Where no answer comes, or an exception that proves nothing,
    the device itself says whether it has the value. One that `is_sent` was written with another one, and is verified
    alone.
    """
    lost = ""
    try:
        if not is_sent:
            access.write(client, change.chosen)
    except NoAnswerError as error:
        lost = str(error)
    except RefusedError as error:
        if error.is_known:
            raise
        lost = f"{error}, which the spec does not list"
    now = access.read_back(client, change.chosen)
    if now is None or not differs(change.chosen, now):
        return
    if now.refusal:
        raise TransferError(change.path, f"cannot be read back: {now.refusal}", uncertain=True)
    if lost and now.words == change.before.words:
        raise TransferError(change.path, f"is not written: {lost}")
    number = now.decoded.number if now.decoded is not None else None
    raise TransferError(change.path, f"was not accepted: the device has {spec_text(number)} instead")
