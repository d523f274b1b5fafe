"""The arguments of `fieldspec audit`."""

from __future__ import annotations

import argparse

from fieldspec.command.console.verb_parsers import DEVICE_HELP


def add_audit(audit: argparse.ArgumentParser) -> None:
    """Adds the arguments of the audit."""
    audit.add_argument("device", metavar="DEVICE[@VERSION]", help=DEVICE_HELP)
    audit.add_argument("--manual", metavar="FILE", help="the text of the manual (default: its recorded index)")
    audit.add_argument(
        "--record", action="store_true", help="with --manual: write the index of the text next to the spec"
    )
    audit.add_argument("--all", action="store_true", help="include the long tables")
    audit.add_argument(
        "--as-printed", action="store_true", help="show which misprints the checks would find without the errata"
    )
    audit.add_argument(
        "--table", metavar="NAME", help="print only this table, such as ledger; required for csv and xlsx"
    )
    audit.add_argument(
        "--format",
        choices=("text", "json", "html", "sarif", "csv", "xlsx", "parquet"),
        default="text",
        help="the output format (default: text)",
    )
    audit.add_argument("--out", metavar="FILE", help="the file for the page or the table (default: standard output)")
    audit.add_argument(
        "--dump", metavar="FILE", help="check values read from a device: CSV, XLSX or JSON (-: standard input)"
    )
    for role in ("address", "value", "words", "space"):
        audit.add_argument(
            f"--{role}", metavar="COLUMN", help=f"the column of the dump with the {role}, if it is not recognized"
        )
    audit.add_argument("--base", choices=("hex", "decimal", "4xxxx"), help="the notation of addresses in the dump")
    audit.add_argument(
        "--offset", type=int, metavar="NUMBER", help="the difference between addresses in the dump and on the wire"
    )
    audit.add_argument("--encoding", metavar="NAME", help="the encoding of the dump, such as gbk, big5 or utf-16")
    captures = "report on a folder of captures, or of tables from decode --to parquet"
    audit.add_argument("--captures", metavar="FOLDER", help=captures)
    evidence = "report on dumps, scans and captures of real units, one folder per unit"
    audit.add_argument("--evidence", metavar="FOLDER", help=evidence)
    lost = "with --evidence: the table `evidence` of an earlier report as JSON; lost evidence is a finding"
    audit.add_argument("--baseline", metavar="FILE", help=lost)
    audit.add_argument("--sheet", metavar="NAME", help="the sheet, if the dump is a workbook")
    signs = "record that a section of the manual was compared with the spec (`all`: every section)"
    audit.add_argument("--sign", metavar="SECTION", help=signs)
    audit.add_argument("--by", metavar="NAME", help="with --sign: who made the comparison, a name or a role")
    audit.add_argument("--on", metavar="DATE", help="with --sign: the date of the comparison (default: today)")
    audit.add_argument("--how", metavar="TEXT", help="with --sign: how the comparison was made")
