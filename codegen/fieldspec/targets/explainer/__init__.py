"""The explainer as JavaScript: what it knows of a device as data, and the modules that read these."""

SHARED = ("checksums", "error", "escapes", "encodings", "digit_texts", "number_bits", "lists", "widths")
"""The modules that generated codecs use too."""

RUNTIME = (
    "numbers",
    "texts",
    "interpreter",
    "device",
    "values",
    "rows",
    "frames",
    "parameters",
    "registers",
    "body",
    "explanation",
    "readings",
    "lines",
    "log",
    "entries",
    "encoding",
    "explainer",
)
"""The modules in an order in which each imports only earlier modules and modules of `SHARED`. No name is declared
twice.
"""


def runtime_path(name: str) -> str:
    """The file of a module, as a path in the package."""
    return f"targets/explainer/runtime/{name}.js"
