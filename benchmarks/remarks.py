"""What stands in the way of the goals that are missed, by group and name of the row."""

from __future__ import annotations

RICHER = (
    "The floor knows one device in one form. Ours checks by some seventy rules, and what it writes is eight times as "
    "long: tests of every constant beside the C header, codecs in Python, pages as HTML and Markdown."
)
START = (
    "About 0.2 s are spent before the first register: Python, some three hundred modules, the library of the schema, "
    "and the templates. The peer has a tenth of that to import."
)
READS = (
    "The spec is read, validated and laid out at each call, and the modules for that are imported. A cache of compiled "
    "devices would have to be compared with the specs and the compiler by their hashes, and the hash of the compiler "
    "alone takes more than half of the goal."
)
WATCH = "All outputs of all versions of a device are made again, however little of it has changed."
ALL = (
    "It is all work of Python, for texts as long as that. Versions that share most of their facts are written anew, "
    "but for wrapped and escaped texts, and a device keeps one processor busy."
)

REMARKS = {
    ("Command line", "decode of one frame"): READS,
    ("Command line", "show"): READS,
    ("400 registers", "C, Python, Markdown and HTML"): f"{START} {RICHER}",
    ("400 registers", "C header and self-test"): START,
    ("400 registers", "HTML and Markdown"): START,
    ("10,000 registers", "C, Python, Markdown and HTML"): RICHER,
    ("100,000 registers", "C, Python, Markdown and HTML"): RICHER,
    ("100,000 registers", "memory"): "All files are held until all are made, so that none is written where one fails.",
}
NODES = (
    "Every value becomes an object of its own that knows its place, and tags, anchors, keys that stand there twice, "
    "depth and size are looked after; the prototype that took 0.32 did nothing of this."
)
BY_GROUP = {"build --watch": WATCH, "All outputs of four devices": ALL, "YAML with line numbers": NODES}
"""What stands in the way of every row of a group that has no remark of its own."""
