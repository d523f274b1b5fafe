"""The C files from which headers, self-tests and fuzz targets are built compile on their own, without a warning."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from compilers import compiled

from fieldspec.targets.c import runtime_files
from fieldspec.targets.c.number_access import access_functions

FOLDER = Path(runtime_files.__file__).parent
RUNTIME = FOLDER / "runtime"
STANDARD = ["stdbool.h", "stddef.h", "stdint.h", "stdlib.h", "string.h"]

# The declarations that a file needs before it, and statements that use all of it.
PROGRAMS = {
    "enum_size.h": ([], "typedef enum few {FIRST} DEVICE_ENUM_16 small; if (sizeof(small) < 2) return 1;"),
    "machine.h": ([], "uint8_t out[2] = {1, 2}, in[2] = {0, 0}; DEVICE_COPY(in, out, 2); DEVICE_CLEAR(out, 2);"),
    "status.h": ([], "device_codec_status status = DEVICE_OK; (void)status;"),
    "code_text.h": ([], "device_code_text text = {1, -1, 0, 0, 0, 0, 0, 0}; (void)text;"),
    "numbers.h": (
        ["machine.h"],
        "uint8_t out[2] = {0x07u, 0x08u};"
        " if (!device_load_bit(out, 0) || device_load_bit(out, 3) || !device_load_bit(out, 11)) return 1;"
        " device_store_bit(out, 11, false); device_store_bit(out, 9, true); if (out[1] != 2) return 1;"
        " if (device_signed_16(0x8000u) != -32768 || device_digit(0x66u) != 15u) return 1;",
    ),
    "digits.h": (
        [],
        'uint8_t out[6]; const uint8_t *text = (const uint8_t *)"-12.50";'
        " device_store_digits(out, 4, 0, 0x61u, 0x1abfu);"
        ' if (memcmp(out, "1abf", 4) != 0 || device_load_digits(out, 4, 16u) != 0x1abfu) return 1;'
        " if (!device_is_digits(out, 4, 0, 0x61u) || device_is_digits(out, 4, 0, 0)) return 1;"
        " if (!device_is_signed_digits(text, 6, 2) || device_load_signed_digits(text, 6) != -1250) return 1;"
        " device_store_signed_digits(out, 6, 2, -1250); if (memcmp(out, text, 6) != 0) return 1;"
        " if (device_to_bcd(1250u) != 0x1250u || device_of_bcd(0x1250u) != 1250u || device_is_bcd(0x12A0u)) return 1;",
    ),
    "encoded_texts.h": (
        [],
        'uint8_t out[4]; char text[16]; const char *word = "\\xC3\\xA9";'
        " if (!device_fits_encoded_text(word, 2, 4, 1u, 0x20u, false, 0xFFu)) return 1;"
        " device_store_encoded_text(out, word, 2, 4, 1u, 0x20u, false, 0xFFu);"
        " if (out[0] != 0xE9u || out[3] != 0x20u || !device_is_encoded_text(out, 4, 1u, 0x20u, false, 0xFFu)) return 1;"
        " device_load_encoded_text(text, out, 4, 1u, 0x20u, false, 0xFFu); if (memcmp(text, word, 3) != 0) return 1;",
    ),
    "counts.h": (
        [],
        'uint8_t out[4]; const uint8_t *text = (const uint8_t *)"01fA";'
        " if (!device_is_count(text, 3, 0x61u) || device_is_count(text, 3, 10u)) return 1;"
        " if (device_is_count(text, 4, 0x61u)) return 1;"
        " if (device_load_count(text, 3, 0x61u) != 31u || device_load_count(text, 2, 10u) != 1u) return 1;"
        " if (device_load_count(text, 2, 1u) != 0x3130u || !device_is_count(text, 4, 0)) return 1;"
        " if (!device_store_count(out, 3, 0x61u, 31u) || memcmp(out, text, 3) != 0) return 1;"
        " if (device_store_count(out, 2, 10u, 100u) || device_store_count(NULL, 1, 0, 256u)) return 1;",
    ),
    "widths.h": (
        ["status.h", "counts.h"],
        "const device_width fields[2] = {{6u, 5u, 0x2Cu, 0u, 1u, true, 0u, 0u, 0u, 0u, 0u},"
        " {1u, 0u, 0x100u, 0u, 0u, false, 0u, 0u, 0u, 0u, 0u}};"
        " const device_width texts[2] = {{2u, 0u, 0x100u, 0u, 0u, false, 2u, 3u, 2u, 1u, 1u},"
        " {3u, 3u, 0x100u, 1u, 0u, false, 0u, 2u, 2u, 1u, 1u}};"
        ' uint8_t image[7], out[7]; size_t length = 0; const uint8_t *line = (const uint8_t *)"-12.5,";'
        " if (device_widen_fields(fields, 2, line, 6, image) != DEVICE_OK) return 1;"
        ' if (memcmp(image, "-012.5,", 7) != 0) return 1;'
        " if (device_narrow_fields(fields, 2, image, out, 7, &length) != DEVICE_OK || length != 6) return 1;"
        " if (memcmp(out, line, 6) != 0) return 1;"
        ' line = (const uint8_t *)"\\3\\0AB"; if (device_widen_fields(texts, 2, line, 4, image) != DEVICE_OK) return 1;'
        ' if (memcmp(image, "\\4\\0AB", 5) != 0) return 1;'
        " if (device_narrow_fields(texts, 2, image, out, 7, &length) != DEVICE_OK || length != 4) return 1;"
        " if (memcmp(out, line, 4) != 0) return 1;"
        " if (device_widen_fields(texts, 2, line, 3, image) != DEVICE_ERR_INCOMPLETE) return 1;"
        ' line = (const uint8_t *)"\\5\\0AB";'
        " if (device_widen_fields(texts, 2, line, 4, image) != DEVICE_ERR_WRONG_MEASURE) return 1;",
    ),
    "list_elements.h": (
        ["machine.h", "status.h", "counts.h"],
        "const device_inner_list bits_count ="
        " {2u, 2u, 1u, 0u, 8u, 0u, 2u, 1u, 0L, 1u, 240u, NULL, NULL, NULL, 0u, false, false, false, 0L};"
        " const device_inner_list packed ="
        " {0u, 0u, 2u, 2u, 4u, 0u, 0u, 1u, 0L, 0u, 0u, NULL, NULL, NULL, 12u, false, true, false, 0L};"
        ' uint8_t image[4], out[3]; const uint8_t *bits = (const uint8_t *)"\\xFA\\xB2\\xCD";'
        ' if (device_list_size(&bits_count, (const uint8_t *)"\\x2F\\xFF") != 2) return 1;'
        " device_unpack_list(&packed, bits, 4, image);"
        ' if (memcmp(image, "\\xFF\\xAB\\2\\xCD", 4) != 0 || device_list_bytes(&packed, 4) != 3) return 1;'
        " device_pack_list(&packed, image, 4, out); if (memcmp(out, bits, 3) != 0) return 1;",
    ),
    "inner_lists.h": (
        ["machine.h", "status.h", "counts.h", "list_elements.h"],
        "const device_inner_list lists[2] ="
        " {{2u, 4u, 2u, 0u, 4u, 1u, 1u, 2u, 0L, 0u, 0u, NULL, NULL, NULL, 0u, false, false, false, 0L},"
        " {3u, 8u, 1u, 0u, 3u, 0u, 0u, 1u, 0L, 0u, 0u, NULL, NULL, NULL, 0u, false, false, false, 0L}};"
        " uint8_t image[11], out[8]; size_t length = 0;"
        ' const uint8_t *data = (const uint8_t *)"a\\1LIyTSz", *longer = (const uint8_t *)"a\\3yz";'
        " const device_inner_list tags ="
        " {1u, 1u, 4u, 0u, 8u, 0u, 0u, 1u, 0L, 0u, 0u, tag_size, NULL, NULL, 0u, false, false, false, 0L};"
        " const device_inner_list packed ="
        " {0u, 0u, 2u, 2u, 4u, 0u, 0u, 1u, 0L, 0u, 0u, NULL, NULL, NULL, 12u, false, true, false, 0L};"
        ' const uint8_t *bits = (const uint8_t *)"\\xFA\\xB2\\xCD";'
        ' const uint8_t *sent = (const uint8_t *)"x\\2AB\\1C";'
        " if (device_take_lists(lists, 2, 4, data, 8, image, &length) != DEVICE_OK || length != 10) return 1;"
        ' if (memcmp(image, "a\\1yzLI", 6) != 0 || memcmp(image + 8, "TS", 2) != 0) return 1;'
        " if (device_place_lists(lists, 2, 4, image, length, out, 8, &length) != DEVICE_OK || length != 8) return 1;"
        " if (memcmp(out, data, 8) != 0) return 1;"
        " if (device_take_lists(lists, 2, 4, data, 5, image, &length) != DEVICE_ERR_INCOMPLETE) return 1;"
        " if (device_take_lists(lists, 2, 4, longer, 4, image, &length) != DEVICE_ERR_WRONG_MEASURE) return 1;"
        " if (device_take_lists(&tags, 1, 1, sent, 6, image, &length) != DEVICE_OK || length != 9) return 1;"
        ' if (memcmp(image, "x\\2AB", 4) != 0 || memcmp(image + 5, "\\1C", 2) != 0) return 1;'
        " if (device_place_lists(&tags, 1, 1, image, length, out, 8, &length) != DEVICE_OK || length != 6) return 1;"
        " if (memcmp(out, sent, 6) != 0) return 1;"
        " if (device_take_lists(&tags, 1, 1, sent, 5, image, &length) != DEVICE_ERR_INCOMPLETE) return 1;"
        " if (device_take_lists(&packed, 1, 0, bits, 3, image, &length) != DEVICE_OK || length != 4) return 1;"
        ' if (memcmp(image, "\\xFF\\xAB\\2\\xCD", 4) != 0) return 1;'
        " if (device_place_lists(&packed, 1, 0, image, length, out, 8, &length) != DEVICE_OK || length != 3) return 1;"
        " if (memcmp(out, bits, 3) != 0) return 1;"
        " if (tag_size(sent + 1, 5) != 3 || tag_size(sent + 1, 0) != 1 || tag_size(sent + 2, 4) != 0) return 1;",
    ),
    "powers.h": (
        [],
        "if (device_times_power(1250.0, -2) != 12.5 || device_over_power(12.5, -2) != 1250.0) return 1;"
        " if (device_times_power(3.0, 22) != 3e22 || device_over_power(3e22, 22) != 3.0) return 1;",
    ),
    "checksums.h": (
        [],
        'const uint8_t *text = (const uint8_t *)"123456789"; if (device_crc16_modbus(text, 9) != 0x4B37u) return 1;'
        " if (device_sum8(text, 9) != 0xDDu || device_lrc(text, 9) != 0x23u) return 1;",
    ),
    "selftest_support.h": (
        [],
        'told = NULL; expect(same_text("a", "a"), ""); copy(&failed, &failed, 1); clear(&failed, 1);'
        ' if (passed != 1 || !same_bytes("a", "a", 1)) return 1;',
    ),
    "fuzz_macros.h": (
        ["status.h", "functions"],
        "RECORD(uint8_t, decode, encode, 1, 1); PACKED(uint8_t, unpack, pack, 1); FIXED(decode_nothing, encode_nothing,"
        " 1, 1); VALUE(uint8_t, read_value, write_value, 1, 1); ARRAY(uint8_t value[1], unpack_status, write_array, 1,"
        " 1); CONSTANT(uint8_t, read_value, write_constant, 1); TRIGGER(uint8_t, uint8_t, read_value, write_value,"
        " 1, 1);"
        " ADDRESS(uint16_t, at); CONVERSION(uint8_t, from_raw, to_raw, 1);"
        " QUANTITY(uint8_t, int8_t, power_from_raw, power_to_raw, 1);",
    ),
}
FUNCTIONS = """
static const uint8_t data[] = {7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
static const size_t size = 1;
static void hold(bool so) { if (!so) abort(); }
static device_codec_status decode(const uint8_t *in, size_t length, uint8_t *out)
{ *out = in[0]; return length == 1 ? DEVICE_OK : DEVICE_ERR_WRONG_LENGTH; }
static device_codec_status encode(const uint8_t *in, uint8_t *out, size_t capacity, size_t *length)
{ if (capacity < 1) return DEVICE_ERR_CAPACITY; out[0] = *in; *length = 1; return DEVICE_OK; }
static device_codec_status decode_nothing(const uint8_t *in, size_t length)
{ (void)in; return length == 1 ? DEVICE_OK : DEVICE_ERR_WRONG_LENGTH; }
static device_codec_status encode_nothing(uint8_t *out, size_t capacity, size_t *length)
{ if (capacity < 1) return DEVICE_ERR_CAPACITY; out[0] = 7; *length = 1; return DEVICE_OK; }
static void unpack(const uint8_t *in, uint8_t *out) { *out = in[0]; }
static void pack(const uint8_t *in, uint8_t *out) { out[0] = *in; }
static device_codec_status unpack_status(const uint8_t *in, uint8_t *out) { *out = in[0]; return DEVICE_OK; }
static device_codec_status write_array(const uint8_t *in, uint8_t *out) { *out = in[0]; return DEVICE_OK; }
static device_codec_status read_value(const uint8_t *in, uint8_t *out) { *out = in[0]; return DEVICE_OK; }
static device_codec_status write_value(uint8_t value, uint8_t *out) { out[0] = value; return DEVICE_OK; }
static device_codec_status write_constant(uint8_t *out) { out[0] = 7; return DEVICE_OK; }
static device_codec_status at(uint32_t number, uint16_t *address)
{ *address = (uint16_t)number; return number < 9 ? DEVICE_OK : DEVICE_ERR_OUT_OF_RANGE; }
static double from_raw(uint8_t raw, double reference) { return reference * raw; }
static device_codec_status to_raw(double quantity, double reference, uint8_t *raw)
{ (void)quantity; (void)reference; *raw = 0; return DEVICE_ERR_OUT_OF_RANGE; }
static device_codec_status power_from_raw(uint8_t raw, int8_t exponent, double *quantity)
{ (void)exponent; *quantity = raw; return DEVICE_OK; }
static device_codec_status power_to_raw(double quantity, int8_t exponent, uint8_t *raw)
{ (void)quantity; (void)exponent; *raw = 0; return DEVICE_OK; }
"""
BEHIND = {
    "inner_lists.h": """
static size_t tag_size(const uint8_t *in, size_t left)
{
    static const device_inner_list value =
        {1u, 1u, 1u, 0u, 3u, 0u, 1u, 1u, 0L, 0u, 0u, NULL, NULL, NULL, 0u, false, false, false, 0L};
    uint8_t fields[1];
    return device_sent_size(&value, 1, 1, fields, in, left);
}
"""
}
"""What a program needs after a file."""


def test_every_file_has_a_program() -> None:
    # The forms have words that are replaced, so only the headers made of them compile.
    names = {path.name for path in RUNTIME.iterdir() if not path.name.endswith("_forms.h")}
    assert set(PROGRAMS) == names


@pytest.mark.proof(18)
@pytest.mark.parametrize("compiler", ["gcc", "clang", "g++", "tcc"])
@pytest.mark.parametrize("file", PROGRAMS)
def test_a_file_compiles_on_its_own_and_does_what_it_says(file: str, compiler: str, tmp_path: Path) -> None:
    before, statements = PROGRAMS[file]
    lines = [f"#include <{name}>" for name in STANDARD]
    lines += [FUNCTIONS if name == "functions" else f'#include "{RUNTIME / name}"' for name in [*before, file]]
    source = tmp_path / "program.c"
    lines.append(BEHIND.get(file, ""))
    source.write_text("\n".join([*lines, f"int main(void) {{ {statements} return 0; }}\n"]), encoding="utf-8")
    program = compiled(compiler, source, tmp_path / "program")
    assert subprocess.run([str(program)], check=False).returncode == 0


# The bytes of 0x0102030405060708, the last ones of it, in each order.
ORDERS = {
    "u8": "08",
    "u16_be": "07 08",
    "u16_le": "08 07",
    "u24_be": "06 07 08",
    "u24_le": "08 07 06",
    "u32_be": "05 06 07 08",
    "u32_be_words_le": "07 08 05 06",
    "u32_le": "08 07 06 05",
    "u32_le_words_be": "06 05 08 07",
    "u40_be": "04 05 06 07 08",
    "u40_le": "08 07 06 05 04",
    "u48_be": "03 04 05 06 07 08",
    "u48_be_words_le": "07 08 05 06 03 04",
    "u48_le": "08 07 06 05 04 03",
    "u48_le_words_be": "04 03 06 05 08 07",
    "u56_be": "02 03 04 05 06 07 08",
    "u56_le": "08 07 06 05 04 03 02",
    "u64_be": "01 02 03 04 05 06 07 08",
    "u64_be_words_le": "07 08 05 06 03 04 01 02",
    "u64_le": "08 07 06 05 04 03 02 01",
    "u64_le_words_be": "02 01 04 03 06 05 08 07",
}


def test_every_order_of_bytes_has_a_function_that_loads_and_one_that_stores() -> None:
    assert sorted({**access_functions(is_odd=False), **access_functions(is_odd=True)}) == sorted(ORDERS)


@pytest.mark.parametrize("compiler", ["gcc", "clang", "g++", "tcc"])
def test_numbers_are_stored_in_their_order_and_loaded_again(compiler: str, tmp_path: Path) -> None:
    lines = [f"#include <{name}>" for name in STANDARD]
    lines += [f'#include "{RUNTIME / "machine.h"}"', *access_functions(is_odd=False).values()]
    lines += [*access_functions(is_odd=True).values(), "int main(void) { uint8_t out[8];"]
    for access, text in ORDERS.items():
        stored = bytes.fromhex(text)
        number = f"UINT64_C(0x{sorted(stored)[0]:02X}{bytes(sorted(stored))[1:].hex()})"
        expected = ", ".join(map(str, stored))
        lines.append(f"device_store_{access}(out, {number}); if (device_load_{access}(out) != {number}) return 1;")
        lines.append(f"{{ const uint8_t bytes[] = {{{expected}}}; if (memcmp(out, bytes, sizeof bytes)) return 2; }}")
    source = tmp_path / "program.c"
    source.write_text("\n".join([*lines, "return 0; }\n"]), encoding="utf-8")
    assert subprocess.run([str(compiled(compiler, source, tmp_path / "program"))], check=False).returncode == 0


@pytest.mark.parametrize("bits", [24, 40, 48, 56])
def test_a_signed_number_of_odd_size_has_its_sign(bits: int, tmp_path: Path) -> None:
    words = runtime_files.signed_words(bits)
    form = runtime_files.runtime_text("number_forms.h", "signed", words)
    least, greatest = f"INT64_C({-(1 << bits - 1)})", f"INT64_C({(1 << bits - 1) - 1})"
    lines = [f"#include <{name}>" for name in STANDARD] + [f'#include "{RUNTIME / "machine.h"}"', form]
    lines += [f"int main(void) {{ if (device_signed_{bits}(UINT64_C({1 << bits - 1})) != {least}) return 1;"]
    lines += [f"return device_signed_{bits}(UINT64_C({(1 << bits - 1) - 1})) != {greatest}; }}\n"]
    source = tmp_path / "program.c"
    source.write_text("\n".join(lines), encoding="utf-8")
    assert subprocess.run([str(compiled("gcc", source, tmp_path / "program"))], check=False).returncode == 0


def test_no_generator_inspects_its_own_output() -> None:
    # These inspect texts of specs and C files before anything is generated.
    readers = {"declarations.py", "literals.py", "runtime_files.py"}
    users = set()
    for path in FOLDER.glob("*.py"):
        tree = ast.parse(path.read_text("utf-8"))
        if any(
            isinstance(node, ast.Import) and "re" in [alias.name for alias in node.names] for node in ast.walk(tree)
        ):
            users.add(path.name)
    assert users == readers
