"""The checksums of the JavaScript runtime against those of the layout: all CRCs of the public catalogue, sums, xors."""

from __future__ import annotations

import json
import random
import subprocess
from pathlib import Path

from external_tools import require_tool
from fieldspec.codec.layout.checksums import checksum
from fieldspec.language.model.checksums import checksum_named
from fieldspec.language.schema.crc_catalogue import CRC_CATALOGUE
from fieldspec.targets.js.links import checksum_function
from js_output.javascript import package

NAMES = [
    *(line.split()[0] for line in CRC_CATALOGUE.splitlines()),
    *("crc16_modbus", "lrc", "sum8", "sum16", "sum24_ones", "sum32_of2_twos", "xor8", "xor16", "xor32_from_ff_ones"),
    *(
        "adler32",
        "fletcher16",
        "fletcher32",
        "fletcher16_of1_modulo_100_from_0",
        "fletcher64_of3_modulo_ffffffff_from_1",
        "fletcher32_of2b_modulo_ffff_from_0",
    ),
    *("crc16_1021_0_ff_0_of2", "crc64_1_0_rr_0_of4_then_0a0b", "sum16_of2l", "xor16_of2b_twos"),
    *("crc16_xmodem_but_280d0a_as_290e0b", "sum8_but_00_as_ff", "crc40_gsm_but_0001_as_0203"),
]


def test_every_checksum_is_computed_as_the_layout_computes_it(tmp_path: Path) -> None:
    chance = random.Random(7)
    samples = [b"123456789", b"", *(chance.randbytes(chance.randrange(1, 40)) for _ in range(6))]
    rows = []
    expected = []
    for name in NAMES:
        for order in ("big", "little") if checksum_named(name).method != "crc" else ("big",):
            rows.append(f"  {checksum_function(name, order)},")
            expected.append([str(checksum(name, sample, order)) for sample in samples])
    runtime = (package() / "runtime" / "checksums.js").as_uri()
    script = tmp_path / "checksums.mjs"
    lines = [
        f"import * as checksums from {json.dumps(runtime)};",
        "const { avoiding, crc16, crcOf, fletcherOf, followedBy, lrc, sum8, swapping, totalOf } = checksums;",
        f"const samples = {json.dumps([sample.hex() for sample in samples])};",
        'const bytes = samples.map((hex) => new Uint8Array(Buffer.from(hex, "hex")));',
        f"const algorithms = [{' '.join(rows)}];",
        "const results = algorithms.map((compute) => bytes.map((data) => String(compute(data, 0, data.length))));",
        "console.log(JSON.stringify(results));",
    ]
    script.write_text("\n".join(lines), "utf-8")
    run = subprocess.run([require_tool("node"), str(script)], capture_output=True, text=True, check=True)
    assert json.loads(run.stdout) == expected
