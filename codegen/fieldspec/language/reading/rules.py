"""The documentation of the rules of reading: what holds, why, an example, the fix."""

from __future__ import annotations

RULES = {
    "alias_unknown": """An alias names an anchor that comes before it.

Why: without the anchor, the alias has no value.

Example: `*parameter` in a file without `&parameter`, or before it.

Fix: Write the data out, or set the anchor first.
""",
    "aliases_grow": """Aliases do not expand a file without limit.

Why: ten lines of nested aliases can expand to more values than fit into memory.

Example: a list of ten aliases, each of which is a list of ten aliases, and so on.

Fix: Write the data out.
""",
    "codec_usable": """A codec that a spec names belongs to an installed package, and passes its tests. Its Python runs
on random numbers and bytes, the same at every run: `encode` returns the bytes of its size, and `decode` returns the
number again or, with `rounds`, a number with the same bytes. A codec that raises an exception, or does not end, fails.

Why: without the codec, no program can interpret the bytes; a wrong codec misreads them.

Example: `codec: acme_flaot` if the package has `acme_float`.

Fix: Correct the name, install the package, or correct its codec.
""",
    "device_id_unique": """No two devices have the same id.

Why: the id names the generated files; one device would overwrite the other.

Example: two folders whose `device` has `id: gadget`.

Fix: Give one of them a different id.
""",
    "device_section": """One file in the folder of a device identifies the device.

Why: without an id and a manual, nothing can be generated or verified.

Example: a folder with only registers.

Fix: Add the section `device` in `device.yaml`.
""",
    "duplicate_key": """A key occurs once in its mapping.

Why: only one of the two values could apply, and YAML readers disagree about which.

Example: a register with two `range` keys.

Fix: Remove one of them.
""",
    "duplicate_name": """No two entries of a section have the same name.

Why: paths, references and outputs identify an entry by its name.

Example: two records named point.

Fix: Rename one of them.
""",
    "file_empty": """A spec file has content.

Why: an empty file was never written or was truncated.

Example: a file with only a comment.

Fix: Add a section, or remove the file.
""",
    "file_missing": """Every protocol under `uses` has a file.

Why: without the file, the definitions of the protocol are missing from the device.

Example: `uses: [{protocol: wires}]` where the file is `protocols/wire.yaml`.

Fix: Correct the name, or add the file.
""",
    "file_name_portable": """Every file of the specs, and every file that is written for a version, has a name that all
file systems of users permit.

Why: users whose file system does not permit the name can neither check out the specs nor write the outputs. A name with
a line break or another invisible character misleads the reader.

Example: a device `aux`, a version `con`, or `Motion.yaml` next to `motion.yaml`.

Fix: Choose another name.
""",
    "file_regular": """A spec file is a regular file within the folder of the specs.

Why: reading a pipe can block without end, and reading a special file may never end. A file outside the folder is not
part of the specs, and no finding may quote it.

Example: `device.yaml` is a symbolic link to `/etc/passwd`.

Fix: Put the file itself into the folder.
""",
    "file_too_large": """A spec file has at most 16 MiB and two million values, a folder 1000 files and 32 MiB.

Why: a larger file is not a spec that a person wrote.

Example: a capture of a line, saved with the extension `.yaml`.

Fix: Split it into several files, or move it out of the folder.
""",
    "id_matches_path": """The id of a device is the name of its folder, and the id of a protocol is the name
of its file.

Why: the command line finds a device by its folder, and `uses` finds a protocol by its file.

Example: `id: gadget_2` in the folder `gadget`.

Fix: Rename the folder or the file, or correct the id.
""",
    "import_cycle": """No protocol uses itself, directly or through others.

Why: in a cycle there is no protocol to read first.

Example: a protocol a that uses b, which uses a.

Fix: Remove one of these uses.
""",
    "key_not_text": """A key is a word.

Why: no key of the language is a list or a mapping.

Example: `? [a, b]`

Fix: Use a word as the key.
""",
    "missing_key": """A mapping has all required keys.

Why: without them, the fact has no layout or no source.

Example: a member of an enum without `value`.

Fix: Add the key.
""",
    "not_utf8": """A spec file is encoded in UTF-8.

Why: labels are in the language of the manual, and another encoding turns them into other characters.

Example: a file saved as GB 18030.

Fix: Save the file as UTF-8.
""",
    "overlay_base_differs": """The `was` values in a version file match the base version.

Why: if they differ, the base has changed since the file was written, and the author did not know its new
value.

Example: `range: {was: 1..100, is: 1..120}` where the base has 1..90.

Fix: Compare the file with its base, decide which value is right now, and correct `was`.
""",
    "overlay_changes_nothing": """Every entry in a version file changes something.

Why: an entry without effect is a mistake, or a change that is now in the base.

Example: `unit: {was: mm, is: mm}`, an added register with a `since` after the version, or a change of a register
that the same file removes.

Fix: State the new value, or remove the entry.
""",
    "overlay_cycle": """No version is based on itself, directly or through others.

Why: in a cycle there is no version to start from.

Example: 2.1 is based on 2.2, and 2.2 on 2.1.

Fix: Base one of them on a version that does not depend on it.
""",
    "overlay_fact_missing": """The facts that a version file changes are in its base version.

Why: an entry that matches nothing would silently have no effect.

Example: `fact: registers/sped`, or a register that only another version line has.

Fix: Correct the path, or base the version on a version that has the fact.
""",
    "overlay_removal_incomplete": """A fact is removed with its errata, examples, notes and tasks.

Why: errata, examples, notes and tasks would refer to a fact that the version does not have.

Example: `removes: [{fact: registers/speed, ...}]` where an erratum is about `registers/speed`.

Fix: Remove them in the same file, or let them refer to a different fact.
""",
    "overlay_name_taken": """A fact that a version file adds or renames has a name that is not in use.

Why: two facts with the same name in one list cannot be distinguished.

Example: a register renamed to `speed` where a register `speed` exists.

Fix: Use another name. To change an existing fact, use `changes`.
""",
    "section_twice": """A section that is not a list occurs in only one file of a device.

Why: lists are joined, but of two sections that are not lists only one could apply.

Example: `device` in two files of a folder.

Fix: Remove one of them.
""",
    "several_documents": """A spec file is one YAML document.

Why: a second document would be ignored.

Example: a line `---` in the middle of a file.

Fix: Move the second document to its own file.
""",
    "tab_indent": """Lines are indented with spaces.

Why: YAML does not permit tabs there, because their width is not defined.

Example: a line that begins with a tab.

Fix: Indent with spaces.
""",
    "tag_used": """A spec contains data without tags.

Why: a tag asks the reader to construct something other than data, but only the schema decides what a value
is.

Example: `!!python/name:os.system`

Fix: Remove the tag.
""",
    "too_deep": """A file is nested at most 64 levels deep.

Why: the language needs about a dozen levels; more is a mistake or an attack.

Example: a thousand opening brackets.

Fix: Use fewer levels.
""",
    "too_many_findings": """A file or a check has at most 200 findings.

Why: more findings do not help; most of them repeat the same mistake.

Example: a file in another format with ten thousand lines.

Fix: Correct the first findings.
""",
    "type_present": """The spec states the type of every value on the wire, once, and the keys of a value at the value
itself.

Why: width and sign are never guessed. A field with a record has no value, so a unit, a range or a meaning of this field
would have no effect.

Example: a register without `type`, a text without `length`, a field with both `type` and `record`, or with `record` and
`unit`.

Fix: Add the type, as inferred with a reason if the manual only implies it. State the keys of values at the fields of
the record. Bytes without a meaning are `type: bytes`, with their `length` and `reserved: true`.
""",
    "unknown_key": """Every key is part of the language.

Why: a misspelt key would be ignored together with its value.

Example: `acces: rw`

Fix: Correct the key; `docs/language.md` and the pages that it names list all keys.
""",
    "unknown_word": """A word is permitted by its key.

Why: other words have no meaning for the key.

Example: `access: readonly`

Fix: Use one of the words that the finding lists.
""",
    "uses_bounded": """A device or a protocol uses at most 100 protocols, and a chain of uses has at most 16
protocols.

Why: reading a folder of specs must take a bounded time, even if its author is hostile.

Example: a chain of seventeen protocols, each of which uses the next.

Fix: Combine related protocols, and let each protocol use directly the protocols that it needs.
""",
    "version_never": """The bounds of a fact permit at least one version.

Why: outputs contain only facts of versions, so an error in an unused fact, or a missing register, would not be noticed.

Example: `since: "2.0"` and `until: "1.0"` at one register, or a member with `until: "1.0"` in an enum that has
`since: "2.0"`.

Fix: Correct the bounds, or remove the fact.
""",
    "version_twice": """A version is declared once and has one place in its line.

Why: `since` and `until` must name a single place in a line.

Example: two members with the id `1.17`.

Fix: Give each version its own identifier. If two files follow the same version, add `after`.
""",
    "version_unknown": """`since`, `until` and `only` name versions that the device declares.

Why: the compiler cannot determine in which versions a fact with an unknown bound applies.

Example: `since: "2.00"` where the version is declared as `2.0`.

Fix: Correct the identifier, or declare the version.
""",
    "versions_bounded": """A device has at most 250 version files, and 32 MiB, counted once for each version.

Why: every version is built from the files, so a large spec with thousands of versions takes a long time to read.

Example: a file in `versions/` for each day of a year.

Fix: Make a version that is in use the base, and remove the files of earlier versions.
""",
    "wrong_form": """A value has the form that its key requires.

Why: the meaning of a value in a different form would be a guess.

Example: `range: 5-10` instead of `5..10`, or a bound that is not a whole number of counts.

Fix: Use the form in the description of the key.
""",
    "wrong_size": """A list or a row of a table has the required number of entries.

Why: if a row is too short, its cells move to other columns.

Example: a row of two cells in a table of three columns.

Fix: Write `~` for an empty cell.
""",
    "wrong_type": """A value has the type that its key requires: a number, a text, a list or a mapping.

Why: a value of another type has no meaning for the key.

Example: `at: servo`

Fix: Use a value of the required type.
""",
    "wrong_value": """A number is within the bounds of its key.

Why: a number outside the bounds cannot occur on the wire.

Example: `at: 0x12000`

Fix: Correct the number.
""",
    "yaml_syntax": """A spec file is valid YAML.

Why: a file that cannot be parsed has no content.

Example: `label: a: b` without quotes.

Fix: Look at the place of the finding and just before it. Quote texts that contain `: `, `#`, `{` or `[`.
""",
}
