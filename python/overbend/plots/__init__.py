"""Figures of results, drawn by matplotlib in the style and the units of the reports.

`static.plot.tension()`, `run.plot.envelope('von_mises')`, `study.plot.map('static.lay_back')`. Every function returns
the matplotlib Axes that it drew into, so that a figure can be completed and saved; given `ax`, it draws into that.
"""

from .dynamic_plots import DynamicPlots
from .static_plots import StaticPlots
from .study_plots import StudyPlots

__all__ = ["DynamicPlots", "StaticPlots", "StudyPlots"]
