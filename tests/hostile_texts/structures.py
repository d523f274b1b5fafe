"""The structure of an output without its texts, by a parser of its own language: poison does not change it."""

from __future__ import annotations

import ast
import csv
import io
import json
import re
import subprocess
import tempfile
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import html5lib
import openpyxl
import tree_sitter
import tree_sitter_iec61131_3_st
from lxml import etree
from markdown_it import MarkdownIt

from external_tools import NODE_TOOLS, require_tool

Structure = Any
FORMULA = ("=", "+", "-", "@", "\t", "\r")
ST_ELEMENTS = {"Declaration", "ST", "InterfaceAsPlainText"}
"""The elements of PLCopen and TwinCAT that have Structured Text, or an element around it."""
NUMBER = re.compile(r"[-+]?[0-9]+([.,][0-9]+)?")


class ParserError(Exception):
    """A parser refuses an output."""


def of_python(text: str) -> Structure:
    """The syntax tree; texts are all the same."""
    tree = ast.parse(text)
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            node.value = ""
    return ast.dump(tree)


def of_c(text: str) -> Structure:
    """The tokens that the preprocessor leaves, with trigraphs as the standard has them."""
    call = [require_tool("gcc"), "-std=c99", "-fpreprocessed", "-dD", "-E", "-P", "-Werror=comment", "-x", "c", "-"]
    run = subprocess.run(call, input=text.encode(), capture_output=True, check=False)
    if run.returncode:
        raise ParserError(run.stderr.decode("utf-8", "replace")[:500])
    return re.sub(r'"(\\.|[^"\\\n])*"', '""', run.stdout.decode("utf-8")).split()


def of_lua(text: str) -> Structure:
    """The instructions of the compiled program, without the values of its constants."""
    with tempfile.TemporaryDirectory(prefix="fieldspec-lua-") as folder:
        path = Path(folder) / "x.lua"
        path.write_text(text, encoding="utf-8", newline="\n")
        run = subprocess.run([require_tool("luac5.4"), "-l", "-p", str(path)], capture_output=True, check=False)
    if run.returncode:
        raise ParserError(run.stderr.decode("utf-8", "replace")[:500])
    codes = re.findall(r"^\t\d+\t\[\d+\]\t(\w+)", run.stdout.decode("utf-8", "replace"), re.MULTILINE)
    # A constant beyond the 256th has an instruction of its own, and equal texts are one constant.
    return [code for code in codes if code not in ("LOADK", "LOADKX", "EXTRAARG")]


_KINDS = """
const ts = require(process.argv[1]);
const results = JSON.parse(require("fs").readFileSync(0, "utf8")).map(([name, text]) => {
  const file = ts.createSourceFile(name, text, ts.ScriptTarget.Latest, true);
  const kinds = [];
  const visit = (node) => {
    kinds.push(ts.SyntaxKind[node.kind]);
    if (ts.isIdentifier(node)) kinds.push(node.text);
    ts.forEachChild(node, visit);
  };
  visit(file);
  return { errors: file.parseDiagnostics.map((error) => String(error.messageText)), kinds };
});
console.log(JSON.stringify(results));
"""


def of_javascript(texts: list[tuple[str, str]]) -> list[Structure]:
    """The kinds of all nodes and the names of some files, by the parser of TypeScript."""
    parser = NODE_TOOLS.parent / "typescript" / "lib" / "typescript.js"
    require_tool("tsc")
    call = [require_tool("node"), "-e", _KINDS, str(parser)]
    run = subprocess.run(call, input=json.dumps(texts).encode(), capture_output=True, check=True)
    results = json.loads(run.stdout)
    for (name, _), result in zip(texts, results, strict=True):
        if result["errors"]:
            raise ParserError(f"{name}: {result['errors'][:3]}")
    return [result["kinds"] for result in results]


def of_html(text: str) -> Structure:
    """The tags with the names of their attributes; scripts as they are. No error of the parser is left out."""
    parser = html5lib.HTMLParser(strict=False, tree=html5lib.getTreeBuilder("etree"), namespaceHTMLElements=False)
    root = parser.parse(text)
    errors = [code for _, code, _ in parser.errors]
    if errors:
        raise ParserError(f"{errors[:5]}")
    return [
        (element.tag, sorted(element.attrib), element.text if element.tag in ("script", "style") else "")
        for element in root.iter()
        if isinstance(element.tag, str)
    ]


def of_markdown(text: str) -> Structure:
    """The tokens without the texts; those beside each other are one text."""
    kinds: list[str] = []
    for token in MarkdownIt("commonmark").enable("table").parse(text):
        kinds.append(f"{token.type} {token.tag}")
        for child in token.children or ():
            # A name is code only where it has no backtick.
            kind = "text" if child.type in ("text", "text_special", "code_inline") else f"{child.type} {child.tag}"
            if kind != "text" or kinds[-1] != "text":
                kinds.append(kind)
    return kinds


@cache
def _st_parser() -> tree_sitter.Parser:
    return tree_sitter.Parser(tree_sitter.Language(tree_sitter_iec61131_3_st.language()))


def of_st(text: str) -> Structure:
    """The nodes of Structured Text without comments and texts."""
    bare = _without_texts(text)
    nodes: list[Any] = [_st_parser().parse(bare.encode()).root_node]
    kinds = []
    while nodes:
        node = nodes.pop()
        if "comment" not in node.type:
            kinds.append(node.type if node.child_count else node.text.decode())
            nodes += reversed(node.children)
    return kinds


_ST_TEXT = re.compile(r"""\(\*.*?\*\)|//[^\n]*|'(?:\$.|[^'$])*'|"(?:\$.|[^"$])*\"""", re.DOTALL)


def _without_texts(text: str) -> str:
    """Structured Text with empty comments and texts: each ends where the standard says that it ends."""
    return _ST_TEXT.sub(lambda match: "(**)" if match[0][:1] in "(/" else match[0][0] * 2, text)


def of_xml(text: str) -> Structure:
    """The tags with their attributes' names, and the structure of the Structured Text in them."""
    root = etree.fromstring(text.encode(), etree.XMLParser(resolve_entities=False, no_network=True))
    result: list[Any] = []
    for element in root.iter():
        name = element.tag if isinstance(element.tag, str) else type(element).__name__
        above = element.getparent()
        code = {name.rpartition("}")[2], above.tag.rpartition("}")[2] if above is not None else ""} & ST_ELEMENTS
        content = of_st(element.text or "") if code else ""
        result.append((name, sorted(element.attrib), content))
    return result


def of_csv(text: str) -> Structure:
    """The number of cells in each row; no cell is a formula."""
    delimiter = ";" if text.count(";") > text.count(",") else ","
    rows = list(csv.reader(io.StringIO(text, newline=""), delimiter=delimiter, strict=True))
    for cell in (cell for row in rows for cell in row):
        if cell.startswith(FORMULA) and not NUMBER.fullmatch(cell):
            raise ParserError(f"a formula: {cell!r}")
    return [len(row) for row in rows]


def of_json(text: str) -> Structure:
    """The keys and the kinds of values."""

    def kinds(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: kinds(item) for key, item in value.items()}
        return [kinds(item) for item in value] if isinstance(value, list) else type(value).__name__

    return kinds(json.loads(text))


def of_workbook(content: bytes) -> Structure:
    """The kind of each cell; none is a formula or a link."""
    book = openpyxl.load_workbook(io.BytesIO(content))
    kinds = []
    for sheet in book.worksheets:
        for cell in (cell for row in sheet.iter_rows() for cell in row):
            if cell.data_type == "f" or cell.hyperlink is not None:
                raise ParserError(f"a formula or a link: {cell.value!r}")
            kinds.append((sheet.title, cell.coordinate, cell.data_type))
    return kinds


BY_SUFFIX: dict[str, Callable[[str], Structure]] = {
    ".py": of_python,
    ".h": of_c,
    ".c": of_c,
    ".lua": of_lua,
    ".html": of_html,
    ".md": of_markdown,
    ".csv": of_csv,
    ".json": of_json,
    **dict.fromkeys((".st", ".scl", ".udt", ".db"), of_st),
    **dict.fromkeys((".xml", ".TcDUT", ".TcGVL", ".TcPOU"), of_xml),
}


def structures(files: dict[str, bytes]) -> Iterator[tuple[str, Structure]]:
    """The structure of each file, or the error of its parser. Raises KeyError for a suffix that no parser reads."""
    scripts = [(path, content.decode()) for path, content in files.items() if path.endswith((".js", ".ts"))]
    if scripts:
        yield from zip((path for path, _ in scripts), of_javascript(scripts), strict=True)
    for path, content in files.items():
        suffix = Path(path).suffix
        if suffix == ".xlsx":
            yield path, of_workbook(content)
        elif suffix not in (".js", ".ts"):
            try:
                yield path, BY_SUFFIX[suffix](content.decode("utf-8"))
            except (ParserError, SyntaxError, ValueError, csv.Error, etree.XMLSyntaxError) as error:
                raise ParserError(f"{path}: {error}") from error
