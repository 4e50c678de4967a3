"""What mpmCheck finds."""

from dataclasses import dataclass


@dataclass
class Finding:
    """kind: error, warning, note. unless: not told if a text with this pattern is there."""
    kind: str
    file: str
    entry: str
    text: str
    remedy: str = ""
    page: str = ""
    unless: str = ""
