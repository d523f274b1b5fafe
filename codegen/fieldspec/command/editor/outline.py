"""The outline of a document: its sections with the facts in them, and what an editor can fold."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from lsprotocol.types import DocumentSymbol, FoldingRange, Range, SymbolKind

from fieldspec.foundation.source import Span
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence, children, identity
from fieldspec.language.reading.references import unquoted

Ranged = Callable[[Span], "Range | None"]
"""The range of a place in the document as it is now; None where that has changed."""


def symbols(tree: Mapping, ranged: Ranged) -> list[DocumentSymbol]:
    """The sections of a document, each with the named facts in it, and those in these."""
    sections = (_symbol(key, node, node.span, ranged, SymbolKind.Namespace) for key, node in tree.values.items())
    return [section for section in sections if section is not None]


def _symbol(name: str, node: Node, name_span: Span, ranged: Ranged, kind: SymbolKind) -> DocumentSymbol | None:
    whole, selection = ranged(node.span), ranged(name_span)
    if whole is None or selection is None:
        return None
    return DocumentSymbol(name, kind, whole, selection, children=[*_named(node, ranged)])


def _named(node: Node, ranged: Ranged) -> Iterator[DocumentSymbol]:
    """The named facts that are next below a node."""
    for _, child in children(node):
        name = identity(child) if isinstance(node, Sequence) and isinstance(child, Mapping) else None
        if name and isinstance(child, Mapping) and child.start >= node.start and child.end <= node.end:
            scalar = next(value for value in child.values.values() if isinstance(value, Scalar) and value.text == name)
            span = unquoted(scalar) if child.start <= scalar.start <= scalar.end <= child.end else child.span
            symbol = _symbol(name, child, span, ranged, SymbolKind.Field)
            if symbol is not None:
                yield symbol
        elif not isinstance(child, Scalar):
            yield from _named(child, ranged)


def folds(node: Mapping | Sequence, ranged: Ranged) -> Iterator[FoldingRange]:
    """The lists and mappings below a node that take several lines, without the blank ones after them."""
    for _, child in children(node):
        if isinstance(child, Scalar):
            continue
        end = child.start + len(child.file.text[child.start : child.end].rstrip())
        lines = ranged(Span(child.file, child.start, end))
        if lines is not None and lines.end.line > lines.start.line:
            yield FoldingRange(lines.start.line, lines.end.line)
        yield from folds(child, ranged)
