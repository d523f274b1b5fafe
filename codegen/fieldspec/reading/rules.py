"""The documentation of the rules of reading: what is true in a good spec, why, an example, the cure."""

from __future__ import annotations

RULES = {
    "alias_unknown": """An alias names an anchor that comes before it.

Why: otherwise it has no value.

Example: `*parameter` where the file has no `&parameter`, or has it further down.

Cure: Write the data out, or set the anchor first.
""",
    "aliases_grow": """Aliases do not make a file grow without bound.

Why: ten lines of aliases of aliases can mean more values than fit into memory.

Example: a list of ten aliases, each of which is a list of ten aliases, and so on.

Cure: Write the data out.
""",
    "device_id_unique": """No two devices have the same id.

Why: the id names what is generated; one device would overwrite the other.

Example: two folders whose `device` has `id: gadget`.

Cure: Give one of them another id.
""",
    "device_section": """One file of a device's folder says what the device is.

Why: without an id and a manual nothing can be generated or looked up.

Example: a folder with registers alone.

Cure: Write the section `device` in `device.yaml`.
""",
    "duplicate_key": """A key occurs once in its mapping.

Why: only one of the two values could count, and readers take different ones.

Example: a register with two `range`.

Cure: Remove one of them.
""",
    "duplicate_name": """No two entries of a section have the same name.

Why: paths, references and outputs know an entry by its name.

Example: two records called point.

Cure: Give one of them another name.
""",
    "file_empty": """A spec file says something.

Why: an empty file is one that was not written or was cut off.

Example: a file with a comment alone.

Cure: Write a section, or remove the file.
""",
    "file_missing": """A protocol that is used has a file.

Why: what it defines is missing from the device.

Example: `uses: [{protocol: wires}]` where the file is `protocols/wire.yaml`.

Cure: Put the name right, or write the file.
""",
    "file_regular": """A spec file is a regular file within the folder of the specs.

Why: a pipe can wait for ever and a device can go on for ever. What is behind a link that leads out of the folder is
not of the specs, and no finding may quote it.

Example: `device.yaml` is a symbolic link to `/etc/passwd`.

Cure: Put the file itself into the folder.
""",
    "file_too_large": """A spec file has at most 16 MiB and two million values, a folder 1000 files and 32 MiB.

Why: what is larger is no spec that a person wrote.

Example: a capture of a line that was saved with the ending `.yaml`.

Cure: Split it over several files, or take it out of the folder.
""",
    "id_matches_path": """A device has the id of its folder, a protocol that of its file.

Why: the command line finds a device by its folder, and `uses` finds a protocol by its file.

Example: `id: gadget_2` in the folder `gadget`.

Cure: Rename the folder or file, or put the id right.
""",
    "import_cycle": """No protocol uses itself, neither directly nor through others.

Why: there would be no first one to begin with.

Example: a protocol a that uses b, which uses a.

Cure: Remove one of these uses.
""",
    "key_not_text": """A key is a word.

Why: no key of the language is a list or a mapping.

Example: `? [a, b]`

Cure: Write a plain word.
""",
    "missing_key": """A mapping has the keys that it needs.

Why: the fact has no layout, or cannot be looked up, without them.

Example: an enum's member without its `value`.

Cure: Give the key.
""",
    "not_utf8": """A spec file is UTF-8.

Why: labels are in the manual's language, and another encoding turns them into other characters.

Example: a file that was saved as GB 18030.

Cure: Save the file as UTF-8.
""",
    "overlay_base_differs": """What the file of a version says was so, was so in the version that it is based on.

Why: the base has been changed since the file was written, and its author did not know what it is now.

Example: `range: {was: 1..100, is: 1..120}` where the base has 1..90.

Cure: Look at both places, decide what is right now, and put `was` right.
""",
    "overlay_changes_nothing": """Every entry in the file of a version changes something.

Why: an entry without effect is a slip, or a change that the base has taken over.

Example: `unit: {was: mm, is: mm}`.

Cure: Give the new value, or remove the entry.
""",
    "overlay_cycle": """No version is based on itself, directly or by way of others.

Why: there would be nothing to start from.

Example: 2.1 is based on 2.2, and 2.2 on 2.1.

Cure: Base one of them on a version that does not need it.
""",
    "overlay_fact_missing": """The facts that the file of a version changes are in the version that it is based on.

Why: an entry that matches nothing would silently do nothing.

Example: `fact: registers/sped`, or a register that only another line of versions has.

Cure: Put the path right, or base the version on the one that has the fact.
""",
    "overlay_name_taken": """What the file of a version adds or renames gets a name that is free.

Why: two facts of one list with one name could not be told apart.

Example: a register renamed to `speed` where there is a register `speed`.

Cure: Give another name; what is there already is changed under `changes`.
""",
    "section_twice": """A section that is no list is in one file of a device.

Why: lists are joined; of two other sections only one could count.

Example: `device` in two files of a folder.

Cure: Keep one of them.
""",
    "several_documents": """A spec file is one document.

Why: a second one would be passed over.

Example: a line `---` in the middle of a file.

Cure: Give the second document a file of its own.
""",
    "tab_indent": """Lines are indented with blanks.

Why: YAML allows no tab there, and how wide a tab is nobody knows.

Example: a line that begins with a tab.

Cure: Indent with blanks.
""",
    "tag_used": """A spec is plain data, without tags.

Why: a tag asks a reader to build something else than data, and the schema decides what a value is.

Example: `!!python/name:os.system`

Cure: Remove the tag.
""",
    "too_deep": """A file is nested at most 64 levels deep.

Why: the language needs a dozen; more is a slip or an attack.

Example: a thousand opening brackets.

Cure: Use fewer levels.
""",
    "too_many_findings": """A file, and a check, has at most 200 findings.

Why: more of them help nobody; most of them are the same slip again.

Example: a file in another form with ten thousand lines.

Cure: Mend the first ones.
""",
    "type_present": """The spec states the encoding of every value, once.

Why: width and sign are never guessed.

Example: a register without `type`, a text without `length`, a field with both `type` and `record`.

Cure: Give the type, as inferred with a reason if the manual only implies it.
""",
    "units_known": """A unit is one of the closed list.

Why: whoever converts values has to know what a unit is; a misspelt one is no unit.

Example: `unit: Pluse`

Cure: Use the unit that is meant, and an erratum for what is printed. A new unit is added to the schema.
""",
    "unknown_key": """Every key belongs to the language.

Why: a key with a typing error would be passed over, and what it says with it.

Example: `acces: rw`

Cure: Put the key right; `docs/language.md` lists all of them.
""",
    "unknown_word": """A value that is a word is one of those that its key allows.

Why: other words mean nothing there.

Example: `access: readonly`

Cure: Use one of the words that the finding lists.
""",
    "uses_bounded": """A device or a protocol uses at most 100 protocols, and at most 16 use each other in a row.

Why: a folder of specs must be read in bounded time, whoever has written it.

Example: a protocol that uses a protocol that uses a protocol, seventeen times.

Cure: Join protocols that go together, and let each use those that it needs itself.
""",
    "version_twice": """A version is declared once, and has one place on its line.

Why: `since` and `until` have to mean one place in one line.

Example: two members with the id `1.17`.

Cure: Give each version an identifier of its own; where two files follow the same version, say `after`.
""",
    "version_unknown": """`since`, `until` and `only` name versions that the device declares.

Why: a fact that applies from an unknown version on applies never or always.

Example: `since: "2.00"` where the version is called `2.0`.

Cure: Put the identifier right, or declare the version.
""",
    "versions_bounded": """A device has at most 250 files of versions, and 32 MiB, counted once for each version.

Why: each version is made of the files anew, so that many versions of a large spec take long to read.

Example: a file in `versions/` for each day of a year.

Cure: Make a version that is in use the base, and remove the files of those before it.
""",
    "wrong_form": """A value is written in the form that its key asks for.

Why: what cannot be read would have to be guessed.

Example: `range: 5-10` instead of `5..10`, or a bound that is no whole number of counts.

Cure: Write it as the description of the key says.
""",
    "wrong_size": """A list, or a row of a table, has as many entries as it should.

Why: a row that is too short puts its cells into other columns.

Example: a row of two cells in a table of three columns.

Cure: Write `~` for an empty cell.
""",
    "wrong_type": """A value is of the kind that its key asks for: a number, a text, a list, a mapping.

Why: another kind cannot mean what the key means.

Example: `at: servo`

Cure: Write a value of that kind.
""",
    "wrong_value": """A number is within the bounds of its key.

Why: a number outside of them cannot exist on the wire.

Example: `at: 0x12000`

Cure: Put the number right.
""",
    "yaml_syntax": """A spec file is YAML.

Why: what cannot be parsed says nothing.

Example: `label: a: b` without quotes.

Cure: Look at the place of the finding, and a little before it; quote texts with `: `, `#`, `{` or `[`.
""",
}
