"""`fieldspec audit`: what shows that the spec of a device is right, and what does not."""

from __future__ import annotations

import argparse

from fieldspec.commands import specs
from fieldspec.commands.output import print_blocks, print_findings
from fieldspec.diagnostics import has_errors, in_order


def run(arguments: argparse.Namespace) -> int:
    """Prints the audit. Exit code 1 where a section has a finding that is an error."""
    from fieldspec.audit.report import report
    from fieldspec.audit.subject import Subject
    from fieldspec.facts import rows
    from fieldspec.proofs.running import errata_proofs

    spec, version = specs.spec_at(arguments.specs, arguments.device)
    layout = specs.laid(spec, version)
    made = report(Subject(spec, layout, rows(layout), errata_proofs(spec)))
    found = in_order(made.findings())
    if arguments.format == "json":
        from fieldspec.render.audit_json import rendered

        print(rendered(made), end="")
    elif arguments.format == "sarif":
        print_findings(found, "sarif", "")
    else:
        from fieldspec.render.audit_text import blocks

        print_blocks(blocks(made, arguments.all))
        if found:
            print()
            print_findings(found, "text", "")
    return 1 if has_errors(found) else 0
