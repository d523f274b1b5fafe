"""Fields of bits, which may lie apart, as expressions of Python."""

from __future__ import annotations

from fieldspec.language.model.enums import Bit


def runs_of(bit: Bit) -> str:
    """The runs of bits that lie apart, as the runtime takes them: `((8, 0x7f, 0), (0, 0x1, 7))`."""
    return f"({', '.join(f'({run.first}, {run.most:#x}, {run.weight})' for run in bit.runs)})"


def joined(word: str, bit: Bit) -> str:
    """The number in a field of bits without its sign: `raw >> 4 & 0x7`, or `raw >> 8 & 0x7f | (raw & 0x1) << 7`."""
    masked = [f"{word} >> {run.first} & {run.most:#x}" if run.first else f"{word} & {run.most:#x}" for run in bit.runs]
    return " | ".join(
        f"({text}) << {run.weight}" if run.weight else text for text, run in zip(masked, bit.runs, strict=True)
    )


def image(word: str, bit: Bit) -> str:
    """The bits of a field in a form that its `images` have."""
    return joined(word, bit) if bit.pieces else f"{word} & {bit.mask:#x}"


def place_of(bit: Bit) -> str:
    """Where the bits of a field are, as refusals of the runtime take it: a mask, or the runs of bits that lie apart."""
    return runs_of(bit) if bit.pieces else f"{bit.mask:#x}"
