"""Findings: warnings and notes on results, as records."""

from dataclasses import dataclass, field
from typing import Any, Optional


@dataclass(frozen=True)
class FindingNumber:
    """A number of a finding: name, value [SI] and SI unit."""

    name: str
    value: float
    unit: str


@dataclass(frozen=True)
class Finding:
    """A warning or note on a result; docs/guide/findings.md explains every code and its remedy.

    Attributes:
        code: 'pipe-off-rollers', 'compression', ...
        severity: 'serious', 'caution' or 'note'. With a serious finding the verdict is passed with reservations at best.
        message: One sentence.
        object: Object concerned: 'stinger 8', 'mooring line port bow'; empty if it concerns the whole.
        from_top: Location on the pipe, arc length from the tensioner [m].
        time: Time [s].
        numbers: Numbers in SI, the one that measures the severity first.
        accepted: True if listed in checks.accepted_findings.
    """

    code: str
    severity: str
    message: str
    object: str = ""
    from_top: Optional[float] = None
    time: Optional[float] = None
    numbers: tuple[FindingNumber, ...] = field(default=())
    accepted: bool = False

    def __str__(self) -> str:
        return f"{self.severity}: {self.message} [{self.code}]"


def _finding(content: dict[str, Any]) -> Finding:
    record = dict(content)
    record["numbers"] = tuple(FindingNumber(**number) for number in content.get("numbers", ()))
    return Finding(**record)


def make_findings(records: list[dict[str, Any]]) -> list[Finding]:
    """Findings from their JSON records."""
    return [_finding(record) for record in records]
