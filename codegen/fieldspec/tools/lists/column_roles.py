"""The role of each column of a list: guessed from its heading in English or Chinese, or as the user says."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence

from fieldspec.foundation.classes import dataclass
from fieldspec.tools.lists.cells import address_text
from fieldspec.tools.lists.sheet import ListError, Sheet, SheetRow, letters

_LONGEST = 200
_HEADED_BY = 40
"""The number of rows among which the heading is searched."""


def _words(text: str) -> tuple[str, ...]:
    return tuple(text.split())


# The headings of each role, folded, the likeliest first. `*` begins a part of a heading.
HEADINGS: dict[str, tuple[str, ...]] = {
    "address": _words(
        """hex hexaddress addresshex addrhex *hexadecimal *十六进 *十六進 *16进 *16進 address addr adr registeraddress
        *address *addr 地址 位址 *地址 *位址 registernumber registerno register reg pnu
        *寄存器号 *暫存器號 寄存器 暫存器 decimal dec *十进 *十進 parameternumber 参数号 參數號 *参数编号 *參數編號"""
    ),
    "name": _words(
        """name parametername registername signalname variable tag *name symbol parameter signal 名称 名稱 参数名
        參數名 *名称 *名稱 变量 變數 参数 參數 项目 項目"""
    ),
    "printed_name": _words("printedname identifier id mnemonic abbreviation 代号 代號 符号 符號 缩写 縮寫"),
    "label": _words(
        "label title description *description function meaning content 描述 说明 說明 功能 内容 內容 *说明 *說明"
    ),
    "words": _words(
        """words word wordcount registers registercount numberofregisters numberofwords *words size length len 字数 字數
        字长 字長 *字数 *字數 长度 長度 寄存器数 暫存器數 寄存器数量 暫存器數量"""
    ),
    "type": _words(
        """type datatype dtype *datatype format dataformat 类型 類型 数据类型 資料類型 數據類型 资料型态 資料型態 *类型
        *類型 格式 型态 型態"""
    ),
    "access": _words(
        """access rw accessrights accesstype attribute readwrite *access *readwrite permission direction 读写 讀寫 属性
        屬性 权限 權限 *读写 *讀寫 存取 访问 訪問"""
    ),
    "unit": _words("unit units *unit 单位 單位 *单位 *單位"),
    "scale": _words("scale scaling factor resolution multiplier gain *scale 比例 倍率 系数 係數 精度 分辨率 解析度"),
    "min": _words("min minimum low lower lowerlimit *min 最小 最小值 下限 *最小"),
    "max": _words("max maximum high upper upperlimit *max 最大 最大值 上限 *最大"),
    "range": _words("range valuerange *range 范围 範圍 *范围 *範圍 取值 设定值 設定值"),
    "default": _words(
        """default defaultvalue initial initialvalue factory factorydefault *default 默认 默认值 預設 預設值 初始值
        出厂值 出廠值 *默认 *預設 *初始"""
    ),
    "const": _words("const constant constantvalue fixed fixedvalue 常数 常數 固定值"),
    "count": _words("count elements repeat instances"),
    "stride": _words("stride"),
    "space": _words("space area"),
    "value": _words(
        """value rawvalue currentvalue actualvalue presentvalue reading raw data valuehex hexvalue 值 数值 數值
        当前值 當前值 现在值 現在值 读数 讀數 数据 數據 資料"""
    ),
}


@dataclass(frozen=True, slots=True)
class Columns:
    """The columns of a list by role, counted from 0, its headings, and the rows below them."""

    places: Mapping[str, int]
    headings: tuple[str, ...]
    rows: tuple[SheetRow, ...]

    def cell(self, row: SheetRow, role: str) -> str:
        """The cell of a row in the column of a role; empty if the list has no such column."""
        place = self.places.get(role)
        return row.cell(place) if place is not None else ""

    def heading(self, role: str) -> str:
        """The heading of a role's column, or its letter if it has none."""
        place = self.places[role]
        text = self.headings[place] if place < len(self.headings) else ""
        return text or f"column {letters(place + 1)}"


def folded(text: str) -> str:
    """A text without case, width, blanks and punctuation, for comparisons."""
    wide = unicodedata.normalize("NFKC", text).casefold()
    return "".join(sign for sign in wide if sign.isalnum())


def columns(sheet: Sheet, names: Mapping[str, str]) -> Columns:
    """The columns of a sheet. `names` has a heading, a letter or a number for some roles.

    Raises ListError if no column has addresses, or if a column in use has cells that cannot be read.
    """
    if not sheet.rows:
        raise ListError("is empty")
    best: Columns | None = None
    for index, row in enumerate(sheet.rows[:_HEADED_BY]):
        if not _is_heading(row):
            continue
        candidate = Columns(_guessed(row.cells, names), row.cells, sheet.rows[index + 1 :])
        if "address" in candidate.places and (best is None or len(candidate.places) > len(best.places)):
            best = candidate
    if best is None:
        best = _without_heading(sheet, names)
    _refuse_unreadable(sheet, best, names)
    return best


def _is_heading(row: SheetRow) -> bool:
    """Whether a row may be a heading: it has texts, and none of them is an address with digits."""
    filled = [cell for cell in row.cells if cell]
    numbers = sum(cell[:1].isdigit() and address_text(cell) is not None for cell in filled)
    return bool(filled) and not numbers


def _guessed(cells: Sequence[str], names: Mapping[str, str]) -> dict[str, int]:
    heads = [folded(cell) for cell in cells]
    places: dict[str, int] = {}
    for role, text in names.items():
        place = _column_index(cells, text)
        if place is not None:
            places[role] = place
    if len(places) < len(names):
        return {}
    for role, words in HEADINGS.items():
        used_places = set(places.values())
        if role in places:
            continue
        for word in words:
            hit = next((n for n, head in enumerate(heads) if n not in used_places and _fits(head, word)), None)
            if hit is not None:
                places[role] = hit
                break
    return places


def _fits(head: str, word: str) -> bool:
    return word[1:] in head if word.startswith("*") else head == word


def _column_index(cells: Sequence[str], text: str) -> int | None:
    """The column that a user names: by its heading, by its number, or by its letters."""
    heads = [folded(cell) for cell in cells]
    if folded(text) and folded(text) in heads:
        return heads.index(folded(text))
    return _numbered(text, len(cells))


def _numbered(text: str, width: int) -> int | None:
    if re.fullmatch("[0-9]{1,4}", text) and 1 <= int(text) <= width:
        return int(text) - 1
    if re.fullmatch("[A-Za-z]{1,2}", text):
        number = 0
        for letter in text.upper():
            number = number * 26 + ord(letter) - ord("A") + 1
        return number - 1 if number <= width else None
    return None


def _without_heading(sheet: Sheet, names: Mapping[str, str]) -> Columns:
    """The columns of a list whose first row is data, or a heading that names no role."""
    first = sheet.rows[0]
    width = max(len(row.cells) for row in sheet.rows)
    heads = first.cells if _is_heading(first) else ()
    headings = headings_text(heads)
    places = {}
    for role, text in names.items():
        place = _column_index(heads, text) if heads else None
        place = _numbered(text, width) if place is None else place
        if place is None:
            raise ListError(f"has no column {text}; there are {headings}, or give a letter or a number")
        places[role] = place
    if "address" not in places:
        raise ListError(
            f"has no column that looks like addresses ({headings}); name it with --address, by its heading, letter or "
            "number"
        )
    rows = sheet.rows[1:] if heads else sheet.rows
    return Columns(places, heads, rows)


def _refuse_unreadable(sheet: Sheet, columns: Columns, names: Mapping[str, str]) -> None:
    """Raises ListError for formulas and merged cells in the columns in use."""
    if not columns.rows:
        raise ListError("has a heading and no rows")
    used = {place + 1: role for role, place in columns.places.items()}
    first = columns.rows[0].number
    wrong = sorted((row, column) for row, column in sheet.formulas if column in used and row >= first)
    if wrong:
        row, column = wrong[0]
        rest_text = f" and {len(wrong) - 1} more" if len(wrong) > 1 else ""
        raise ListError(
            f"has formulas in {letters(column)}{row}{rest_text}; save the list with values instead of formulas"
        )
    for area in sheet.merged:
        touched = [column for column in used if area.first_column <= column <= area.last_column]
        if touched and area.last_row >= first and area.last_row > area.first_row:
            raise ListError(f"has merged cells {area.text()}; undo the merge and fill each cell")


def headings_text(headings: Iterable[str]) -> str:
    """The headings of a file for a message, cut if there are many."""
    joined = ", ".join(text for text in headings if text)
    if not joined:
        return "no headings"
    return joined if len(joined) <= _LONGEST else f"{joined[:_LONGEST]}..."
