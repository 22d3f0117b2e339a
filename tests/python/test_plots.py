"""Figures show the numbers of the results, in the units of the reports."""

import os
import pathlib
import re
import subprocess
import sys
import unittest

os.environ["MPLBACKEND"] = "Agg"

import numpy as np
from matplotlib import pyplot
from matplotlib.patches import Rectangle

import overbend as ob
from overbend.plots.units import shown

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples"
JLAY = """overbend: 1
environment: {water_depth: 400 m, seabed: {stiffness: 100 kN/m^2}}
pipe: {steel: {outside_diameter: 12.75 in, wall_thickness: 15.9 mm, yield_stress: 414 MPa}}
vessel: {stern_shoe: {x: -60 m, z: 4 m}}
tensioner: {x: 0 m, z: 15 m, guide: pinned, tension: 560 kN}
"""


def axes_texts(ax):
    """All texts in a figure."""
    return [text.get_text() for text in ax.texts] + [ax.get_title(loc="left"), ax.get_xlabel(), ax.get_ylabel()]


def bars(ax):
    """The bars of rollers in a figure."""
    return [patch for patch in ax.patches if isinstance(patch, Rectangle) and abs(patch.get_width() - 0.72) < 1e-9]


def longest_line(ax):
    return max(ax.get_lines(), key=lambda line: len(line.get_xdata()))


class Drawing(unittest.TestCase):
    def tearDown(self):
        pyplot.close("all")

    def assert_says(self, ax, text):
        self.assertTrue(any(text in item for item in axes_texts(ax)), f"'{text}' is not among {axes_texts(ax)}")


class StaticFigures(Drawing):
    @classmethod
    def setUpClass(cls):
        cls.static = ob.Model.read(EXAMPLES / "bgl1.yaml").static()

    def test_every_figure_has_the_title_of_the_model_above_its_own(self):
        plot = self.static.plot
        for ax in (plot.profile(), plot.tension(part="overbend"), plot.reactions(), plot.separation()):
            self.assertEqual(ax.get_title(loc="left").split("\n")[0], self.static.title)
            self.assertEqual(len(ax.get_title(loc="left").split("\n")), 2)

    def test_a_title_of_a_model_is_shortened_in_narrow_axes(self):
        long = ob.Model.read(EXAMPLES / "bgl1.yaml").with_(title="word " * 60).static()
        first = long.plot.tension().get_title(loc="left").split("\n")[0]
        self.assertLess(len(first), 150)
        self.assertTrue(first.endswith(" ..."))

    def test_a_curve_has_the_values_of_the_table_over_the_distance_from_the_tensioner(self):
        line = longest_line(self.static.plot.along("bending_stress"))
        from_top = self.static.total_length - self.static.pipe.s.values
        seen = from_top <= line.get_xdata().max() + 1e-9
        np.testing.assert_allclose(line.get_xdata(), from_top[seen], rtol=1e-12)
        np.testing.assert_allclose(line.get_ydata(), 1e-6 * self.static.pipe.bending_stress.values[seen], rtol=1e-12)

    def test_marks_have_the_key_results(self):
        ax = self.static.plot.moment()
        for region in (self.static.overbend, self.static.sagbend):
            self.assert_says(ax, f"{region.max_bending_moment / 1e3:.1f} kN m")
        self.assert_says(self.static.plot.tension(), f"{self.static.bottom_tension / 1e3:.1f} kN at touchdown")
        self.assert_says(self.static.plot.profile(), f"touchdown at {self.static.lay_back:.1f} m")

    def test_stress_is_next_to_the_yield_stress(self):
        self.assert_says(self.static.plot.stress(), "yield 414 MPa")
        self.assert_says(self.static.plot.stress(), "von Mises stress [MPa]")

    def test_the_overbend_names_its_boxes_and_ends_behind_the_last(self):
        ax = self.static.plot.stress(part="overbend")
        self.assert_says(ax, "stinger 8")
        self.assertLess(ax.get_xlim()[1], 110)
        self.assertGreater(self.static.plot.stress().get_xlim()[1], self.static.length_top_to_touchdown)

    def test_the_line_is_true_to_scale_in_the_whole_elevation(self):
        self.assertEqual(self.static.plot.profile().get_aspect(), 1.0)
        self.assertEqual(self.static.plot.profile(part="overbend").get_aspect(), "auto")

    def test_bars_add_up_to_the_reactions_of_the_rollers(self):
        total = sum(bar.get_height() for bar in bars(self.static.plot.reactions()))
        self.assertAlmostEqual(total, 1e-3 * float(self.static.rollers.reaction.sum()), places=6)

    def test_a_roller_that_the_pipe_has_passed_is_a_cross(self):
        lines = self.static.plot.separation(position="port").get_lines()
        self.assertTrue(any(line.get_marker() == "x" for line in lines))

    def test_figures_go_into_the_axes_that_are_given(self):
        plot = self.static.plot
        along = [plot.profile, plot.tension, plot.moment, plot.stress, plot.strain]
        for draw in (*along, plot.reactions, plot.separation):
            ax = pyplot.subplots(figsize=(4, 3))[1]
            self.assertIs(draw(ax), ax)
            self.assertEqual(len(ax.figure.axes), 1)
            ax.figure.canvas.draw()

    def test_what_cannot_be_drawn_is_said(self):
        with self.assertRaisesRegex(ValueError, "part: found 'stinger', expected 'whole' or 'overbend'"):
            self.static.plot.tension(part="stinger")
        with self.assertRaisesRegex(ValueError, "expected one of 'bottom', 'port', 'starboard'"):
            self.static.plot.separation(position="top")
        with self.assertRaisesRegex(KeyError, "did you mean 'curvature'"):
            self.static.plot.along("curvatur")

    def test_a_model_without_a_pipe_has_none_to_draw(self):
        static = ob.Model.read(EXAMPLES / "jumper.yaml").static()
        for draw in (static.plot.profile, static.plot.tension, static.plot.stress):
            with self.assertRaisesRegex(ValueError, "no pipe to draw"):
                draw()

    def test_plain_arrays_are_drawn_as_labelled_ones(self):
        lines = []
        for use in (True, False):
            ob.use_xarray(use)
            try:
                static = ob.Model.read(EXAMPLES / "first-model.yaml").static()
                lines.append(longest_line(static.plot.moment()).get_ydata())
            finally:
                ob.use_xarray(True)
        np.testing.assert_array_equal(*lines)


class JLay(Drawing):
    def test_a_line_without_supports_has_its_figures_but_those_of_rollers(self):
        static = ob.Model.from_text(JLAY).static()
        for draw in (static.plot.profile, static.plot.tension, static.plot.moment, static.plot.stress):
            draw().figure.canvas.draw()
        with self.assertRaisesRegex(ValueError, "no rollers"):
            static.plot.reactions()
        with self.assertRaisesRegex(ValueError, "without supports"):
            static.plot.tension(part="overbend")


class DynamicFigures(Drawing):
    @classmethod
    def setUpClass(cls):
        model = ob.Model.read(EXAMPLES / "bgl1-workable-sea.yaml").with_({"analysis.dynamic.build_up": "10 s"})
        cls.run_ = model.dynamic(duration="20 s")

    def test_a_history_is_in_kilonewtons_over_time(self):
        line = longest_line(self.run_.plot.history("top_tension"))
        np.testing.assert_allclose(line.get_ydata(), 1e-3 * self.run_.history("top_tension").values)
        self.assertEqual((line.get_xdata()[0], line.get_xdata()[-1]), (-10.0, 20.0))

    def test_a_window_of_time_is_drawn_alone(self):
        ax = self.run_.plot.history("top_tension", "bottom_tension", between=(5, 10))
        self.assertEqual(ax.get_xlim(), (5, 10))
        self.assertEqual([text.get_text() for text in ax.get_legend().get_texts()], ["top_tension", "bottom_tension"])

    def test_histories_of_several_units_do_not_share_axes(self):
        with self.assertRaisesRegex(ValueError, r"top_tension \[N\], lay_back \[m\], expected histories of one unit"):
            self.run_.plot.history("top_tension", "lay_back")

    def test_an_envelope_names_its_largest_value(self):
        ax = self.run_.plot.envelope("von_mises")
        self.assert_says(ax, f"{float(self.run_.envelope('von_mises')['max'].max()) / 1e6:.1f} MPa")

    def test_a_spectrum_holds_the_variance_of_its_history(self):
        line = longest_line(self.run_.plot.spectrum("top_tension"))
        since = self.run_.history("top_tension").values[self.run_.time >= 0]
        area = np.trapz(line.get_ydata(), line.get_xdata())
        self.assertAlmostEqual(area / (1e-3 * since.std()) ** 2, 1.0, delta=0.3)  # windows and trend change it

    def test_impacts_and_reactions_are_drawn(self):
        plot = self.run_.plot
        for ax in (plot.impacts(), plot.impacts(over="approach_velocity"), plot.reactions()):
            ax.figure.canvas.draw()
        with self.assertRaisesRegex(ValueError, "expected 'time' or 'approach_velocity'"):
            self.run_.plot.impacts(over="force")

    def test_the_range_of_reactions_is_that_of_the_table(self):
        tops = [bar.get_y() + bar.get_height() for bar in bars(self.run_.plot.reactions())]
        bottom = self.run_.rollers.position.values == "bottom"
        self.assertAlmostEqual(max(tops), 1e-3 * self.run_.rollers.reaction_max.values[bottom].max())


class StudyFigures(Drawing):
    AXES = {"tensioner.tension": ["150 kN", "300 kN", "500 kN"], "environment.water_depth": ["40 m", "45 m"]}

    @classmethod
    def setUpClass(cls):
        cls.model = ob.Model.read(EXAMPLES / "first-model.yaml")
        cls.study = ob.study(cls.model, axes=cls.AXES, gather=["static.lay_back", "static.sagbend.max_von_mises"])

    def test_there_is_a_curve_for_each_value_of_the_second_axis(self):
        ax = self.study.plot.curve("tensioner.tension", "static.sagbend.max_von_mises")
        curves = [line for line in ax.get_lines() if len(line.get_xdata()) == 3 and line.get_linestyle() == "-"]
        stress = 1e-6 * self.study.grid("static.sagbend.max_von_mises").values
        for depth, line in enumerate(curves):
            np.testing.assert_allclose(line.get_xdata(), [150, 300, 500])
            np.testing.assert_allclose(line.get_ydata(), stress[:, depth])
        self.assertEqual(len(curves), 2)
        self.assertEqual([text.get_text() for text in ax.get_legend().get_texts()][:2], ["40 m", "45 m"])

    def test_one_value_of_an_axis_is_chosen_by_the_nearest(self):
        ax = self.study.plot.curve("tensioner.tension", "static.lay_back", at={"environment.water_depth": 44.0})
        np.testing.assert_allclose(longest_line(ax).get_ydata(), self.study.grid("static.lay_back").values[:, 1])

    def test_a_map_has_a_cell_for_each_case_and_names_its_axes(self):
        ax = self.study.plot.map("static.lay_back", x="tensioner.tension")
        cells = np.asarray(ax.collections[0].get_array()).reshape(2, 3)
        np.testing.assert_allclose(cells, self.study.grid("static.lay_back").values.T)
        self.assert_says(ax, "tensioner.tension [kN]")
        self.assert_says(ax, "environment.water_depth [m]")

    def test_a_scatter_has_a_dot_for_each_case(self):
        ax = self.study.plot.scatter("tensioner.tension", "static.lay_back")
        self.assertEqual(sum(len(line.get_xdata()) for line in ax.get_lines()), 6)

    def test_seeds_are_a_band_about_their_mean(self):
        model = ob.Model.read(EXAMPLES / "bgl1-workable-sea.yaml").with_({"analysis.dynamic.build_up": "5 s"})
        study = ob.study(model, analysis="dynamic", duration="5 s", seeds=2, gather=["dynamic.top_tension.max"],
                         axes={"environment.waves.hs": ["0.5 m", "1 m"]})
        ax = study.plot.curve("environment.waves.hs", "dynamic.top_tension.max")
        values = 1e-3 * study.grid("dynamic.top_tension.max").values
        np.testing.assert_allclose(longest_line(ax).get_ydata(), values.mean(axis=1))
        band = ax.collections[0].get_paths()[0].vertices[:, 1]
        self.assertAlmostEqual(band.max(), values.max())
        self.assertAlmostEqual(band.min(), values.min())

    def test_limits_of_operation_are_drawn_over_their_axes(self):
        study = ob.study(self.model, axes={"environment.water_depth": ["40 m", "45 m"],
                                           "tensioner.tension": ["300 kN", "700 kN"]},
                         operability={"over": "tensioner.tension", "resolution": "50 kN"})
        line = longest_line(study.plot.operability())
        np.testing.assert_allclose(line.get_xdata(), [40, 45])
        np.testing.assert_allclose(line.get_ydata(), 1e-3 * study.operability.limit.values)
        with self.assertRaisesRegex(ValueError, "has not looked for limits"):
            self.study.plot.operability()

    def test_a_limit_beyond_the_largest_value_is_marked_as_such(self):
        study = ob.study(self.model, axes={"environment.water_depth": ["40 m", "45 m"],
                                           "pipe.steel.wall_thickness": ["12.7 mm", "14.3 mm"],
                                           "tensioner.tension": ["300 kN", "400 kN"]},
                         operability={"over": "tensioner.tension", "resolution": "50 kN"})
        self.assertTrue(study.operability.beyond.values.all())
        self.assert_says(study.plot.operability(), "≥ 400")

    def test_what_cannot_be_drawn_is_said(self):
        with self.assertRaisesRegex(KeyError, "no axis 'tension'"):
            self.study.plot.curve("tension", "static.lay_back")
        with self.assertRaisesRegex(KeyError, "did you mean 'static.lay_back'"):
            self.study.plot.map("static.layback")


class Units(unittest.TestCase):
    def test_figures_use_the_units_of_the_reports(self):
        self.assertEqual(shown("tension", "N"), ("kN", 1e-3, 1))
        self.assertEqual(shown("strain", "1")[:2], ("%", 100.0))

    def test_figures_and_tables_are_in_us_units_where_that_is_asked_for(self):
        static = ob.Model.read(EXAMPLES / "bgl1.yaml").static()
        ob.use_units("us")
        self.addCleanup(ob.use_units, "metric")
        axes = static.plot.tension()
        self.assertRegex(axes.get_ylabel(), r"\[kip\]$")
        self.assertRegex(axes.get_xlabel(), r"\[ft\]$")
        self.assertAlmostEqual(float(axes.lines[0].get_ydata().max()), 250.0 / 4.4482216, delta=1.0)  # 250 kN at the top
        metres = np.asarray(axes.get_xticks())
        np.testing.assert_allclose(metres / 0.3048, np.round(metres / 0.3048, 3), atol=1e-6)  # round feet
        self.assertEqual(static.top_tension.units, "N")
        with self.assertRaisesRegex(ValueError, "found 'imperial', expected 'metric' or 'us'"):
            ob.use_units("imperial")

    def test_a_machine_without_matplotlib_gets_a_clear_error(self):
        code = ("import sys; sys.modules['matplotlib'] = None; import overbend as ob\n"
                f"static = ob.Model.read({str(EXAMPLES / 'first-model.yaml')!r}).static()\n"
                "try: static.plot.tension()\nexcept ImportError as error: print(error)")
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, encoding="utf-8", check=True)
        self.assertIn("python3-matplotlib", done.stdout)


if __name__ == "__main__":
    unittest.main()
