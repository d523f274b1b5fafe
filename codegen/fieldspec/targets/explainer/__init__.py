"""The explainer as JavaScript: what it knows of a device as data, and the modules that read these."""

from fieldspec.codec.explain import sentences
from fieldspec.targets.explainer.literals import lines
from fieldspec.targets.explainer.translation.modules import TRANSLATED, translated
from fieldspec.targets.templates import text

SHARED = ("checksums", "error", "escapes", "encodings", "digit_texts", "number_bits", "widths", "lists")
"""The modules that generated codecs use too."""

RUNTIME = (
    "numbers",
    "sentences",
    "texts",
    "python",
    "interpreter",
    "frames",
    "links",
    "layouts",
    "parameter_sets",
    "device",
    "values",
    "row",
    "percentages",
    "parameters",
    "spans",
    "occupants",
    "registers",
    "body",
    "explained_frame",
    "frame_rows",
    "explanation",
    "frame_sizes",
    "recognition",
    "readings",
    "lines",
    "open_requests",
    "log",
    "entries",
    "encoding",
    "explainer",
)
"""The modules in an order in which each imports only earlier modules and modules of `SHARED`. No name is declared
twice.
"""


_HEAD = "/** The sentences of explanations. A name in braces stands for what differs. */"


def module_text(name: str) -> str:
    """The text of a module. The module of the sentences is made from `codec/explain/sentences.py`, and
    others are translated."""
    if name == "sentences":
        constants = {key: value for key, value in vars(sentences).items() if key.isupper()}
        return f"{_HEAD}\nexport const SENTENCES = {lines(constants, 1)};\n"
    return translated(name) if name in TRANSLATED else text(f"targets/explainer/runtime/{name}.js")
