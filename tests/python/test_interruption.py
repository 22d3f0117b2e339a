"""Ctrl-C is heard wherever the engine is at work."""

import signal
import subprocess
import sys
import time
import unittest

import lays  # noqa: F401  (sets the folder of the examples)

BEGIN = """
import sys, overbend as ob
sys.path.insert(0, %r)
from lays import moving_lay, small_lay
from test_operation import OPERATION
model, moving = small_lay(), moving_lay()
try:
    print('begun', flush=True)  # CPython 3.11 does not catch what is raised on the way back to the first line of a `try`
    while True: %s
except KeyboardInterrupt:
    print('heard')
"""

CASES = {
    "sensitivities": "model.sensitivities()",
    "statics of many elements": "model.with_({'analysis.mesh': {'overbend_element': '20 mm', 'touchdown_element': "
                                "'20 mm', 'longest_element': '40 mm'}}).static()",
    "stages": "model.with_({'operation': OPERATION}).operation()",
    "a lay table": "model.lay_table('tension', '200 kN', '400 kN', steps=1000)",
    "the set-up of a simulation": "moving.simulation(duration='1e7 s')",
    "a row of output that takes long": "moving.with_({'analysis.dynamic.output_step': '1e6 s'}).dynamic(duration='1e7 s')",
    "reading": "ob.Model.from_text(model.text + ''.join(f'k{i}: 3\\n' for i in range(20000)))",
}


class Interruption(unittest.TestCase):
    def heard(self, call):
        code = BEGIN % (str(lays.ROOT / "tests" / "python"), call)
        child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, encoding="utf-8")
        try:
            self.assertEqual(child.stdout.readline(), "begun\n")
            time.sleep(0.3)  # at work
            sent = time.monotonic()
            child.send_signal(signal.SIGINT)
            output, _ = child.communicate(timeout=60)
            self.assertEqual(output, "heard\n")
            self.assertLess(time.monotonic() - sent, 10.0)  # of a second where nothing else is at work
        finally:
            child.kill()

    def test_ctrl_c_is_heard(self):
        for call_label, call in CASES.items():
            with self.subTest(call_label):
                self.heard(call if call_label != "reading" else f"\n        try: {call}\n        except ob.ModelError: pass")


if __name__ == "__main__":
    unittest.main()
