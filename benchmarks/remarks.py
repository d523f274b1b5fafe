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
    "The device is compiled already; of its ten thousand objects, three hundred are made. Half of what is left is the "
    "import of sixty small modules, which say what a device is made of and how a frame is explained, and a fifth that "
    "of argparse; to see that specs and compiler are the same takes 3 ms."
)
WATCH = "All outputs of all versions of a device are made again, however little of it has changed."
ALL = (
    "It is all work of Python, for texts as long as that. Versions that share most of their facts are written anew, "
    "but for wrapped and escaped texts, and a device keeps one processor busy."
)
TURNS = (
    "pymodbus takes 3.7 times as long as the loop over 256 entries; when the goal was set, it took 4.7 times as long. "
    "The least by hand that makes the same objects, for one message and with no link between, is at 8.0. What remains "
    "is a call of the link each way, and the look-up of the class by the code. construct is at 29 to 31, by run."
)
TESTS = (
    "Eighteen fields have ranges, and a comparison takes 9 ns: the tests are half of the time. Without any, the same "
    "class by hand is at 23 beside construct, and at 39 beside Kaitai. With them, nothing was found to be faster: to "
    "test the packed bytes as one large number takes as long for fields of one interval alone; a regular expression, "
    "`min` and `max`, sets, and `map` take longer. Limits that are those of the type are left to `struct`."
)
SUMS = "What is written by hand with the same tests is at 30, with none at 34; the goal was set without tests."
CLASSES = (
    "One file of such classes by hand takes 3.1 ms, most of it for making 100 classes of 21 slots. The rest are nine "
    "modules instead of one, so that devices share what they can (1.3 ms), and what says which field is refused and "
    "decodes many records at once (0.6 ms)."
)

REMARKS = {
    ("Python, Modbus request", "build and parse"): TURNS,
    ("Python, CK10 point record", "encode"): TESTS,
    ("Python, ESC11 packet", "build and parse"): SUMS,
    ("Python, import", "100 records of 21 fields, added to python -c pass"): CLASSES,
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
