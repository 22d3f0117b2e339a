#!/usr/bin/env python3
"""Writes the unit database of UDUNITS-2 as C++ source: unit_table.py FOLDER_OF_XML OUTPUT.

The output defines the tables that base/unit_table.h declares.
"""

import pathlib
import sys
import xml.etree.ElementTree as ElementTree

FILES = ("prefixes", "base", "derived", "accepted", "common")  # in the order in which udunits2.xml imports them
BASE_UNITS = ["m", "kg", "s", "A", "K", "mol", "cd", "rad"]  # as in base/unit_table.h


def plural(name):
    """Returns the regular plural by the rules of UDUNITS."""
    if len(name) > 1:
        if name[-1] == "y":
            return name + "s" if name[-2] in "aeiou" else name[:-1] + "ies"
        if name[-1] in "sxz" or name.endswith(("ch", "sh")):
            return name + "es"
    return name + "s"


def forms(text):
    """Returns a name as written and, if it has underscores, with no-break spaces in their place."""
    return {text, text.replace("_", "\u00a0")}


def lower_case(text):
    """Returns the text in ASCII lower case, as strcasecmp() sees it."""
    return text.encode().lower().decode()


def names(element):
    """Returns the singular and the plural of a <name>. UDUNITS forms plurals also where the files have <noplural/>."""
    singular = element.findtext("singular").strip()
    return [singular, element.findtext("plural", plural(singular)).strip()]


class UnitTable:
    """Names, symbols and definitions of all units, names and symbols of all prefixes."""

    def __init__(self, folder):
        self.base_units = []
        self.definitions = []
        self.names, self.symbols = {}, {}
        self.name_prefixes, self.symbol_prefixes = {}, {}
        for part in FILES:
            for entry in ElementTree.parse(pathlib.Path(folder, f"udunits2-{part}.xml")).getroot():
                if entry.tag == "prefix":
                    self.add_prefix(entry)
                elif entry.tag == "unit":
                    self.add_unit(entry)
        if self.base_units != BASE_UNITS:
            sys.exit(f"unit_table.py: the base units are {self.base_units}, not {BASE_UNITS}")

    def add_prefix(self, entry):
        value = float(entry.findtext("value"))
        for element in entry:
            if element.tag == "name":
                self.name_prefixes[lower_case(element.text.strip())] = value
            elif element.tag == "symbol":
                self.symbol_prefixes[element.text.strip()] = value

    def add_unit(self, entry):
        definition = entry.findtext("def")
        if definition is None:
            index = len(self.base_units)
            self.base_units.append(entry.findtext("symbol").strip())
        else:
            index = len(BASE_UNITS) + len(self.definitions)
            self.definitions.append(definition.strip())
        for element in [*entry, *entry.findall("aliases/*")]:
            if element.tag == "name":
                for name in names(element):
                    self.names.update((lower_case(form), index) for form in forms(name))
            elif element.tag == "symbol":
                self.symbols.update((form, index) for form in forms(element.text.strip()))


def row(*values):
    return "{" + ", ".join(f'R"({value})"' if isinstance(value, str) else repr(value) for value in values) + "}"


def array(kind, name, rows):
    body = "".join(f"    {line},\n" for line in rows)
    return f"constexpr {kind} k{name}Rows[] = {{\n{body}}};\n", f"const std::span<const {kind}> k{name} = k{name}Rows;\n"


def sorted_rows(entries):
    """Returns the rows of a dictionary in the order of std::string_view."""
    return [row(text, value) for text, value in sorted(entries.items(), key=lambda item: item[0].encode())]


def source(table):
    """Returns the C++ source of a table."""
    arrays = [
        array("UnitName", "UnitNames", sorted_rows(table.names)),
        array("UnitName", "UnitSymbols", sorted_rows(table.symbols)),
        array("UnitDefinition", "UnitDefinitions", [row(text) for text in table.definitions]),
        array("UnitPrefix", "NamePrefixes", sorted_rows(table.name_prefixes)),
        array("UnitPrefix", "SymbolPrefixes", sorted_rows(table.symbol_prefixes)),
    ]
    return (
        '// Written by tools/unit_table.py from the database of UDUNITS-2.\n#include "base/unit_table.h"\n\n'
        "namespace overbend {\nnamespace {\n\n"
        + "\n".join(rows for rows, _ in arrays)
        + "\n}  // namespace\n\n"
        + "".join(span for _, span in arrays)
        + "\n}  // namespace overbend\n"
    )


if __name__ == "__main__":
    pathlib.Path(sys.argv[2]).write_text(source(UnitTable(sys.argv[1])), encoding="utf-8")
