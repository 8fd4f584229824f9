"""Plants includes in a small house and looks at what tools/check_layers says of them."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECK_LAYERS = pathlib.Path(__file__).resolve().parents[2] / "tools" / "check_layers"

# A house that keeps the rules.
HOUSE = {
    "sensors_models/base/time.h": "#include <cstdint>\n#include <Eigen/Core>\n",
    "sensors_models/measurement/rig.h": '#include "sensors_models/base/time.h"\n',
    "sensors_models/noise/imu.h": '#include "sensors_models/base/time.h"\n',
    "estimator/svin2/svin2.cc": '#include "sensors_models/measurement/rig.h"\n',
    "sim/world/world.h": "#include <mujoco/mujoco.h>\n",
    "scenes/scene.h": '#include "sensors_models/base/time.h"\n',
    "scenarios/scoring/score.h": "#include <nlohmann/json.hpp>\n",
    "scenarios/runner/run.cc": '#include "sim/world/world.h"\n#include "scenes/scene.h"\n',
    "tools/drydock/main.cc": '#include "scenarios/scoring/score.h"\n',
}


def check(planted):
    """Exit code and output of check_layers on the house with the files of `planted` added."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in {**HOUSE, **planted}.items():
            path = pathlib.Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        done = subprocess.run([sys.executable, CHECK_LAYERS, folder], capture_output=True,
                              text=True, check=False)
        return done.returncode, done.stdout


class CheckLayersTest(unittest.TestCase):
    def assert_refused(self, file, include, rule):
        code, output = check({file: f"#pragma once\n#include {include}\n"})
        self.assertEqual(code, 1, output)
        self.assertIn(f"{file}:2: {rule}", output)

    def test_good_house_passes(self):
        code, output = check({})
        self.assertEqual(code, 0, output)

    def test_estimator_sees_neither_noise_nor_sim_nor_scenes(self):
        for target in ("sensors_models/noise/imu.h", "sim/world/world.h", "scenes/scene.h"):
            with self.subTest(target):
                self.assert_refused("estimator/svin2/bad.cc", f'"{target}"',
                                    f'estimator/ may not include "{target}"')

    def test_estimator_sees_neither_mujoco_nor_opengl_nor_embree(self):
        for target, library in (("mujoco/mujoco.h", "MuJoCo"), ("EGL/egl.h", "OpenGL"),
                                ("GL/osmesa.h", "OpenGL"), ("embree3/rtcore.h", "Embree")):
            with self.subTest(target):
                self.assert_refused("estimator/svin2/bad.cc", f"<{target}>",
                                    f"estimator/ may not include {library}")

    def test_only_the_vocabulary_unpacks(self):
        file = "estimator/svin2/vocabulary/file.cc"
        self.assertEqual(check({file: "#include <zlib.h>\n"})[0], 0)
        self.assert_refused("estimator/svin2/bad.cc", "<zlib.h>", "estimator/ may not include zlib")

    def test_sensors_models_look_down_only(self):
        self.assert_refused("sensors_models/measurement/bad.h", '"sensors_models/noise/imu.h"',
                            "sensors_models/measurement/ may not include")

    def test_scenes_need_no_mujoco(self):
        self.assert_refused("scenes/bus/bad.cc", "<mujoco/mujoco.h>",
                            "scenes/ may not include MuJoCo")

    def test_sim_does_not_know_the_estimator(self):
        code, output = check({"estimator/interface/estimator.h": "",
                              "sim/world/bad.cc": '#include "estimator/interface/estimator.h"\n'})
        self.assertEqual(code, 1, output)
        self.assertIn("sim/world/bad.cc:1: sim/ may not include", output)

    def test_scoring_and_dataset_see_only_base_and_measurement(self):
        for folder in ("scoring", "dataset"):
            with self.subTest(folder):
                self.assert_refused(f"scenarios/{folder}/bad.cc", '"sim/world/world.h"',
                                    f"scenarios/{folder}/ may not include")

    def test_circle_of_folders_is_refused(self):
        code, output = check({"sim/world/a.h": '#include "sim/motion/b.h"\n',
                              "sim/motion/b.h": '#include "sim/sensors/c.h"\n',
                              "sim/sensors/c.h": '#include "sim/world/a.h"\n'})
        self.assertEqual(code, 1, output)
        self.assertIn("sim/world/a.h:1: sim/world/ and sim/motion/ include one another", output)

    def test_include_that_is_not_written_from_the_root_is_refused(self):
        self.assert_refused("sim/world/bad.cc", '"world.h"', '"world.h" is not there')

    def test_unknown_library_is_refused(self):
        self.assert_refused("sim/world/bad.cc", "<boost/any.hpp>",
                            "sim/ may not include unknown library")

    def test_folder_without_a_rule_is_refused(self):
        self.assert_refused("sensors_models/extra/bad.h", "<vector>", "no rule for this folder")

    def test_folder_without_code_is_not_taken_for_a_good_one(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, CHECK_LAYERS, folder], capture_output=True,
                                  text=True, check=False)
        self.assertEqual(done.returncode, 1)


if __name__ == "__main__":
    unittest.main()
