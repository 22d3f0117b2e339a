"""What an engineer should know of results, as records."""

from dataclasses import dataclass, field
from typing import Any, Optional


@dataclass(frozen=True)
class FindingNumber:
    """A number of a finding: its name, its value [SI] and its SI unit."""

    name: str
    value: float
    unit: str


@dataclass(frozen=True)
class Finding:
    """What an engineer should know of a result; docs/guide/findings.md has every code with its meaning and remedy.

    Attributes:
        code: 'pipe-off-rollers', 'compression', ...
        severity: 'serious', 'caution' or 'note'. A serious finding reserves the verdict.
        message: One sentence.
        object: What it is about: 'stinger 8', 'mooring line port bow'; empty: the whole.
        from_top: Place on the pipe, arc length from the tensioner [m].
        time: When [s].
        numbers: Its numbers in SI, the one that says how bad it is first.
        accepted: By checks.accepted_findings.
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


def _finding(told: dict[str, Any]) -> Finding:
    record = dict(told)
    record["numbers"] = tuple(FindingNumber(**number) for number in told.get("numbers", ()))
    return Finding(**record)


def findings_of(told: list[dict[str, Any]]) -> list[Finding]:
    """The records of a list as JSON has it."""
    return [_finding(one) for one in told]
