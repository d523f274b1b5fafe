"""The C header on x86-64: instructions a call and a byte, as callgrind counts them; they repeat exactly.

`python benchmarks/c_instructions.py`. Needs gcc and valgrind. The measure is what the same work takes at its best:
three instructions a field, which load, turn and store it, and one that returns.
"""

from __future__ import annotations

import re
import subprocess
import tempfile
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from c_headers import Subject, needed, newest, subjects, version, write_headers
from rows import Row, printed

GROUP = "C, instructions"
CALLS = 50
BYTES = 256

FORMS = {
    "out of line": """
APART void {p}_read_plain(const uint8_t *in, {p} *out) {{ {p}_unpack(in, out); }}
APART void {p}_write_plain(const {p} *in, uint8_t *out) {{ {p}_pack(in, out); }}""",
    "with restrict": """
APART void {p}_read_restrict(const uint8_t *restrict in, {p} *restrict out) {{ {p}_unpack(in, out); }}
APART void {p}_write_restrict(const {p} *restrict in, uint8_t *restrict out) {{ {p}_pack(in, out); }}""",
    "by value": """
APART {p} {p}_read_value(const uint8_t *in) {{ {p} out; {p}_unpack(in, &out); return out; }}
APART void {p}_write_value({p} in, uint8_t *out) {{ {p}_pack(&in, out); }}""",
    "inlined": """
APART void {p}_read_inlined(const uint8_t *in) {{ {p} out; {p}_unpack(in, &out); SEEN(&out); }}
APART void {p}_write_inlined(const {p} *in) {{ uint8_t out[{size}]; {p}_pack(in, out); SEEN(out); }}""",
}
ENDINGS = {"out of line": "plain", "with restrict": "restrict", "by value": "value", "inlined": "inlined"}
CHECKED = """
APART int {p}_read_checked(const uint8_t *in, size_t length, {p} *out) {{ return {p}_decode(in, length, out); }}
APART int {p}_write_checked(const {p} *in, uint8_t *out, size_t capacity, size_t *length)
{{ return {p}_encode(in, out, capacity, length); }}
APART int {p}_write_sized(const {p} *in, uint8_t *out, size_t capacity, size_t *length)
{{ if (capacity < {size}) return 1; {p}_pack(in, out); *length = {size}; return 0; }}"""
RUN = """
    for (at = 0; at < {calls}; at++) {{
        static {p} held; static uint8_t data[{size}]; size_t length;
        {p}_read_plain(data, &held); SEEN(&held); {p}_read_restrict(data, &held); SEEN(&held);
        held = {p}_read_value(data); SEEN(&held); {p}_read_inlined(data); {p}_write_inlined(&held);
        {p}_write_plain(&held, data); SEEN(data); {p}_write_restrict(&held, data); SEEN(data);
        {p}_write_value(held, data); SEEN(data);
        {p}_fill(&held);
        if ({p}_write_checked(&held, data, sizeof data, &length) != 0) return 1;
        SEEN(data);
        if ({p}_write_sized(&held, data, sizeof data, &length) != 0) return 1;
        SEEN(data);
        if ({p}_read_checked(data, sizeof data, &held) != 0) return 1;
        SEEN(&held);
    }}"""
# Values that are in range, so that every check is made.
FILL = """
static void ck10_point_fill(ck10_point *held)
{
    held->low_speed = held->high_speed = held->push_speed = 1;
    held->acceleration_time = held->deceleration_time = 1;
    held->push_torque_ratio = 50;
}
static void hiwin_e_telegram_111_request_fill(hiwin_e_telegram_111_request *held) { (void)held; }
static void hiwin_e_telegram_111_response_fill(hiwin_e_telegram_111_response *held) { (void)held; }
"""


def source(subjects: list[Subject], crc: str) -> str:
    """The program that calls every form of every function, as often."""
    headers = "".join(f'#include "{header}"\n' for header in dict.fromkeys(subject.header for subject in subjects))
    texts = [
        headers,
        '#define APART __attribute__((noipa))\n#define SEEN(what) __asm__ volatile("" : : "r"(what) : "memory")\n',
    ]
    for subject in subjects:
        texts += [form.format(p=subject.prefix, size=subject.size) for form in (*FORMS.values(), CHECKED)]
    texts += [FILL, f"\nAPART uint16_t crc_of_all(const uint8_t *in) {{ return {crc}(in, {BYTES}); }}"]
    texts.append("\nint main(void)\n{\n    int at;\n    static uint8_t many[256];")
    texts += [RUN.format(p=subject.prefix, size=subject.size, calls=CALLS) for subject in subjects]
    return (
        "".join(texts)
        + f"\n    for (at = 0; at < {CALLS}; at++) many[0] = (uint8_t)crc_of_all(many);\n    return 0;\n}}\n"
    )


def instruction_counts(folder: Path, text: str, *flags: str) -> dict[str, float]:
    """Instructions a call of each function, those of what it calls included."""
    (folder / "bench.c").write_text(text, encoding="utf-8")
    gcc, valgrind = needed("gcc", "gcc"), needed("valgrind", "valgrind")
    program, out = str(folder / "bench"), str(folder / "callgrind.out")
    subprocess.run([gcc, "-std=c99", *flags, "-o", program, str(folder / "bench.c")], check=True)
    tool = [valgrind, "--tool=callgrind", "--compress-strings=no", "--compress-pos=no", f"--callgrind-out-file={out}"]
    subprocess.run([*tool, program], check=True, capture_output=True)
    cost: Counter[str] = Counter()
    calls: Counter[str] = Counter()
    function = ""
    for line in Path(out).read_text("utf-8").splitlines():
        key, _, rest = line.partition("=")
        if key == "fn":
            function = rest
        elif key == "cfn":
            called = rest
        elif key == "calls":
            calls[called] += int(rest.split()[0])
        elif re.match(r"\d+ \d+$", line):
            cost[function] += int(line.split()[1])
    return {name: cost[name] / number for name, number in calls.items() if number >= CALLS}


def rows() -> Iterator[Row]:
    """The rows."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        devices = newest()
        all_subjects = subjects(devices, write_headers(folder, devices))
        text = source(all_subjects, "ck10_crc16_modbus")
        narrow = instruction_counts(folder, text, "-O2")
        small = instruction_counts(folder, text, "-Os")
        wide = instruction_counts(folder, text, "-O2", "-DCK10_WIDE_CRC_TABLE")
        by = f"3 per field, plus 1; {version(needed('gcc', 'gcc'))} -O2"
        for subject in all_subjects:
            for way, fields in (("read", subject.reads), ("write", subject.writes)):
                best = 3 * fields + 1
                for form, ending in ENDINGS.items():
                    yield row(
                        f"{subject.name}, {way}, {form}", by, narrow[f"{subject.prefix}_{way}_{ending}"], best, 1.05
                    )
                yield row(f"{subject.name}, {way}, -Os", by, small[f"{subject.prefix}_{way}_plain"], best, None)
            yield row(
                f"{subject.name}, decode: size and values checked",
                "11 more than unchecked",
                narrow[f"{subject.prefix}_read_checked"],
                narrow[f"{subject.prefix}_read_plain"] + 11,
                1.0,
            )
            # Ranges cost what they cost anyone: the goal is for encoders that only look at the size.
            limit = narrow[f"{subject.prefix}_write_plain"] + 11
            for name, ending, goal in (
                ("pack after a check of the size", "sized", 1.0),
                ("encode: every value against its range", "checked", None),
            ):
                count = narrow[f"{subject.prefix}_write_{ending}"]
                yield row(f"{subject.name}, {name}", "11 more than unchecked", count, limit, goal)
        for name, costs, goal in (("32 bytes of table", narrow, 14.5), ("512 bytes of table", wide, 9.5)):
            yield row(f"CRC-16 a byte, {name}", "the goal", costs["crc_of_all"] / BYTES, goal, 1.0)


def row(name: str, peer: str, ours: float, best: float, at_most: float | None) -> Row:
    """A row of counts."""
    return Row(GROUP, name, peer, round(ours, 2), best, "instructions", round(ours / best, 3), at_most)


def main() -> None:
    """Prints the rows."""
    printed(rows())


if __name__ == "__main__":
    main()
