"""Groups of values, and tables."""

from __future__ import annotations

import difflib
import functools
from typing import Any, Callable, Iterator, Mapping, Sequence

import numpy as np

from .values import Number, labelled, xarray_module

Summary = Mapping[str, Any]


def nearest(name: str, names: Sequence[str]) -> str:
    """Suggestion of a similar name: "; did you mean 'lay_back'?", or an empty string."""
    close = difflib.get_close_matches(name, list(names), n=1)
    return f"; did you mean '{close[0]}'?" if close else ""


def wrapped(value: Any, units: Any = None, descriptions: Any = None) -> Any:
    """A value of a summary for users: groups as Record, lists of groups as Records, numbers as Number."""
    if isinstance(value, dict):
        return Record(value, units if isinstance(units, dict) else {},
                      descriptions if isinstance(descriptions, dict) else {})
    if isinstance(value, list):
        one_unit = units[0] if isinstance(units, list) and units else units
        one_description = descriptions[0] if isinstance(descriptions, list) and descriptions else descriptions
        items = [wrapped(item, one_unit, one_description) for item in value]
        return Records(items) if items and isinstance(items[0], Record) else items
    if isinstance(value, float):
        return Number(value, units if isinstance(units, str) else "1",
                      descriptions if isinstance(descriptions, str) else "")
    return value


class Record:
    """A group of values: `record.name` and `record['name']`; `dir()` lists the names."""

    def __init__(self, values: Summary, units: Mapping[str, Any] | None = None,
                 descriptions: Mapping[str, Any] | None = None):
        self._values, self._units, self._descriptions = values, units or {}, descriptions or {}

    def __getitem__(self, name: str) -> Any:
        if name not in self._values:
            raise KeyError(f"there is no '{name}'{nearest(name, list(self._values))}")
        return wrapped(self._values[name], self._units.get(name), self._descriptions.get(name))

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self[name]
        except KeyError as error:
            raise AttributeError(error.args[0]) from None

    def __contains__(self, name: object) -> bool:
        return name in self._values

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *(name for name in self._values if name.isidentifier())})

    def keys(self) -> list[str]:
        """Names of the values."""
        return list(self._values)

    def to_dict(self) -> dict[str, Any]:
        """The values as plain dicts, lists and numbers."""
        return _plain(self._values)

    def __repr__(self) -> str:
        return "\n".join(_as_line(name, self[name]) for name in self._values) or "(nothing)"


class Records(Sequence[Record]):
    """A list of groups; named groups can also be selected by name: `records['stinger 3']`."""

    def __init__(self, items: Sequence[Record]):
        self._items = list(items)

    def __getitem__(self, which: Any) -> Any:
        if not isinstance(which, str):
            return self._items[which]
        for item in self._items:
            if "name" in item and item["name"] == which:
                return item
        names = self.names()
        raise KeyError(f"there is no '{which}'{nearest(which, names)}; there are: {', '.join(names)}")

    def __len__(self) -> int:
        return len(self._items)

    def names(self) -> list[str]:
        """Names of the items that have one."""
        return [item["name"] for item in self._items if "name" in item]

    def to_dict(self) -> list[dict[str, Any]]:
        """The groups as plain dicts."""
        return [item.to_dict() for item in self._items]

    def to_pandas(self) -> Any:
        """A pandas.DataFrame with one row per group; single values of nested groups are columns "group.name".

        `attrs['units']` has the SI unit of every column, `attrs['descriptions']` its description.
        """
        columns: dict[str, tuple[str, str]] = {}
        rows = [_flat(item, "", columns) for item in self._items]
        return _frame({name: [row.get(name) for row in rows] for name in columns}, columns)

    def __repr__(self) -> str:
        return f"<{len(self)} groups" + (": " + ", ".join(self.names()) if self.names() else "") + ">"


class Table:
    """Columns over one dimension: `table.name` or `table['name']` is a labelled array, `len(table)` the number of rows.

    Named rows can be selected by name: `supports['stinger 3'].reaction`.
    """

    def __init__(self, names: Sequence[str], column: Callable[[str], Any], records: Records | None = None):
        """
        Args:
            names: Names of the columns; the first is the coordinate of the others.
            column: Returns the labelled array of a name.
            records: The rows with all their values, if these are more than the columns.
        """
        self._names, self._make, self._records = list(names), functools.lru_cache(maxsize=None)(column), records

    def keys(self) -> list[str]:
        """Names of the columns."""
        return list(self._names)

    def column(self, name: str) -> Any:
        """A column as a labelled array of shape (rows,)."""
        if name not in self._names:
            raise KeyError(f"the table has no column '{name}'{nearest(name, self._names)}")
        return self._make(name)

    def row_names(self) -> list[str]:
        """Names of the rows; empty if they have none."""
        if self._records is not None:
            return self._records.names()
        return [str(name) for name in self.column("name").values] if "name" in self._names else []

    def __getitem__(self, which: Any) -> Any:
        if isinstance(which, str) and which in self._names:
            return self.column(which)
        if isinstance(which, str):
            rows = self.row_names()
            if which not in rows:
                raise KeyError(f"there is neither a column nor a row '{which}'{nearest(which, self._names + rows)}")
            which = rows.index(which)
        if self._records is not None and len(self._records) == len(self):
            return self._records[which]
        return self._row(int(which))

    def _row(self, index: int) -> Record:
        if not -len(self) <= index < len(self):
            raise IndexError(f"the table has {len(self)} rows")
        columns = {name: self.column(name) for name in self._names}
        return Record({name: column.values[index].item() for name, column in columns.items()},
                      {name: column.attrs["units"] for name, column in columns.items()},
                      {name: column.attrs["description"] for name, column in columns.items()})

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self.column(name)
        except KeyError as error:
            raise AttributeError(error.args[0]) from None

    def __contains__(self, name: object) -> bool:
        return name in self._names

    def __iter__(self) -> Iterator[Record]:
        return (self[index] for index in range(len(self)))

    def __len__(self) -> int:
        return len(self.column(self._names[0])) if self._names else 0

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *(name for name in self._names if name.isidentifier())})

    def to_dict(self) -> dict[str, np.ndarray]:
        """The columns as plain numpy arrays."""
        return {name: self.column(name).values for name in self._names}

    def to_xarray(self) -> Any:
        """The table as an xarray.Dataset."""
        xarray = xarray_module()
        if xarray is None:
            raise ImportError("to_xarray() needs the package xarray (python3-xarray)")
        return xarray.Dataset({name: self.column(name) for name in self._names[1:]},
                              coords={self._names[0]: self.column(self._names[0])})

    def to_pandas(self) -> Any:
        """The table as a pandas.DataFrame, its first column as the index.

        Values are SI, columns in the order of the CSV tables (pipe.csv, supports.csv, ...); `attrs['units']` has the
        unit of every column and of the index, `attrs['descriptions']` its description.
        """
        attrs = {name: self.column(name).attrs for name in self._names}
        frame = _frame(self.to_dict(), {name: (column["units"], column["description"]) for name, column in attrs.items()})
        return frame.set_index(self._names[0]) if self._names else frame

    def __repr__(self) -> str:
        lines = [f"<Table of {len(self)} rows>"]
        width = max([28, *(len(name) + 2 for name in self._names)])
        for name in self._names:
            attrs = self.column(name).attrs
            lines.append(f"  {name:<{width}}{_unit(attrs['units']):<10}{attrs['description']}")
        return "\n".join(lines)


def make_table(source: Any, group: str, records: Records | None = None) -> Table:
    """Table of the datasets of a group that share a dimension, the dimension scale first.

    Args:
        source: Has names(group) and dataset(path), like results.h5 and trees in memory.
        group: Path of the group, "/static/stations".
        records: The rows, if they have more values than the columns.
    """
    names = [name for name in source.names(group) if not name.endswith("/")]
    datasets = {name: source.dataset(f"{group}/{name}") for name in names}
    columns = {name: dataset for name, dataset in datasets.items() if getattr(dataset[0], "ndim", 0) == 1}
    scale = next((dataset[4][0].rsplit("/", 1)[-1] for dataset in columns.values() if dataset[4] and dataset[4][0]), "index")
    ordered = ([scale] if scale in columns else []) + [name for name in columns if name != scale]

    def column(name: str) -> Any:
        values, units, description, frame, _ = columns[name]
        coords = {scale: columns[scale][0]} if scale in columns and len(columns[scale][0]) == len(values) else {}
        return labelled(values, name, (scale,), coords, units, description, frame)

    return Table(ordered, column, records)


def make_record(source: Any, group: str) -> Record:
    """Single values and vectors directly in a group of datasets.

    Args:
        source: As in make_table().
        group: Path of the group, "/static/scene".
    """
    datasets = {name: source.dataset(f"{group}/{name}") for name in source.names(group) if not name.endswith("/")}
    vectors = ("component", "axis")
    values, units, descriptions = {}, {}, {}
    for name, (value, unit, description, frame, _) in datasets.items():
        array = isinstance(value, np.ndarray)
        values[name] = labelled(value, name, vectors[:value.ndim], {}, unit, description, frame) if array else value
        units[name], descriptions[name] = unit, description
    return Record(values, units, descriptions)


def _frame(columns: Mapping[str, Any], labels: Mapping[str, tuple[str, str]]) -> Any:
    """A pandas.DataFrame of the columns, with their units and descriptions as attributes."""
    import pandas

    frame = pandas.DataFrame(dict(columns))
    frame.attrs["units"] = {name: unit for name, (unit, _) in labels.items()}
    frame.attrs["descriptions"] = {name: text for name, (_, text) in labels.items()}
    return frame


def _flat(record: Record, before: str, labels: dict[str, tuple[str, str]]) -> dict[str, Any]:
    """Single values of a group and its nested groups by name; `labels` collects units and descriptions."""
    row: dict[str, Any] = {}
    for name in record.keys():
        value, path = record[name], before + name
        if isinstance(value, Record):
            row.update(_flat(value, path + ".", labels))
        elif isinstance(value, str) or not isinstance(value, (Sequence, np.ndarray)):
            unit, text = record._units.get(name), record._descriptions.get(name)
            labels.setdefault(path, (unit if isinstance(unit, str) else "1", text if isinstance(text, str) else ""))
            row[path] = _plain(value) if not isinstance(value, Number) else float(value)
    return row


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {name: _plain(item) for name, item in value.items()}
    if isinstance(value, list):
        return [_plain(item) for item in value]
    return value


def _unit(units: str) -> str:
    return "" if units == "1" else units


def _as_line(name: str, value: Any) -> str:
    if isinstance(value, Number):
        return f"{name:<28}{float(value):>14.6g} {_unit(value.units)}".rstrip()
    if isinstance(value, Record):
        return f"{name}: " + ", ".join(value.keys())
    if isinstance(value, str) and len(value) > 60:
        value = value[:57] + "..."
    return f"{name:<28}{value!r:>14}"
