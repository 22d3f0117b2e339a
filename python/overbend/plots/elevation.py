"""The elevation of a lay: pipe, vessel, rollers, water and seabed."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from . import drawing as draw

X_LABEL, Z_LABEL = "Distance astern of the stern shoe [m]", "Height above the water [m]"
