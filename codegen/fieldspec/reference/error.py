"""The one exception of the reference codec."""

from __future__ import annotations


class CodecError(ValueError):
    """Bytes or values that a codec refuses.

    `reason` is one of: incomplete, wrong_length, wrong_mark, wrong_check, not_hex, unknown_code,
    unknown_value, wrong_const, wrong_measure, out_of_range, wrong_type, missing_value, unknown_field.
    `offset` is the byte at which it shows, None for values.
    """

    def __init__(self, reason: str, detail: str, offset: int | None = None) -> None:
        where = "" if offset is None else f" at byte {offset}"
        super().__init__(f"{reason}{where}: {detail}")
        self.reason, self.detail, self.offset = reason, detail, offset
