"""A check that finds nothing is worth nothing: small trees with one offence each."""

import pathlib
import tempfile
import unittest

import check_arrows
import picture


class Tree(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = pathlib.Path(scratch.name)

    def write(self, path, text=""):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        top = pathlib.Path(path).parts
        for readme in [top[:1], top[:2] if top[0] == "core" else top[:1]]:
            (self.root.joinpath(*readme) / "README.md").touch()

    def offences(self):
        return check_arrows.offences_in(self.root)


class Arrows(Tree):
    def expect_include(self, path, include, allowed):
        self.write(path, f'#pragma once\n#include "{include}"\n')
        found = self.offences()
        if allowed:
            self.assertEqual(found, [])
        else:
            self.assertEqual(len(found), 1, found)
            self.assertIn(f"{path}:2: ", found[0])
            self.assertIn(include, found[0])

    def test_core_includes_nobody_outside_core(self):
        self.expect_include("core/robot/src/a.cpp", "eyebridge/hal/drive.hpp", allowed=False)

    def test_rooms_of_core_have_an_order(self):
        self.expect_include("core/world/src/a.cpp", "eyebridge/robot/simulation.hpp", allowed=False)

    def test_files_may_include_robot(self):
        self.expect_include("core/files/src/a.cpp", "eyebridge/robot/robot_model.hpp", allowed=True)

    def test_private_headers_of_another_room_are_private(self):
        self.write("core/robot/src/motor.hpp")
        self.expect_include("hal/board/a.cpp", "core/robot/src/motor.hpp", allowed=False)

    def test_tests_may_look_inside(self):
        self.write("core/robot/src/motor.hpp")
        self.expect_include("tests/hal/a.cpp", "core/robot/src/motor.hpp", allowed=True)

    def test_hal_sees_of_the_camera_only_its_view(self):
        self.expect_include("hal/registry/a.cpp", "eyebridge/camera/source.hpp", allowed=False)

    def test_hal_may_include_the_view(self):
        self.expect_include("hal/registry/a.cpp", "eyebridge/camera/view.hpp", allowed=True)

    def test_the_simulated_backend_may_include_the_camera(self):
        self.expect_include("hal/sim/a.cpp", "eyebridge/camera/source.hpp", allowed=True)

    def test_camera_does_not_know_the_hal(self):
        self.expect_include("camera/src/a.cpp", "eyebridge/hal/config.hpp", allowed=False)

    def test_the_firmware_sees_of_the_bridges_only_the_opcodes(self):
        self.write("bridges/protocol/opcodes.h")
        self.expect_include("firmware-stubs/board/src/a.c", "opcodes.h", allowed=True)

    def test_the_firmware_has_no_codec_of_the_bridges(self):
        self.write("bridges/protocol/io7/src/text.hpp")
        self.expect_include("firmware-stubs/board/src/a.c", "text.hpp", allowed=False)

    def test_the_firmware_does_not_know_its_ports(self):
        self.expect_include("firmware-stubs/board/src/a.c", "eyebridge/ports/port.hpp", allowed=False)

    def test_ports_know_the_board(self):
        self.write("firmware-stubs/board/include/eb_board.h")
        self.expect_include("firmware-stubs/ports/src/a.cpp", "eb_board.h", allowed=True)

    def test_ports_do_not_use_the_bridges(self):
        self.expect_include("firmware-stubs/ports/src/a.cpp", "eyebridge/bridges/tcp.hpp", allowed=False)

    def test_ports_know_no_world(self):
        self.expect_include("firmware-stubs/ports/src/a.cpp", "eyebridge/robot/simulation.hpp", allowed=False)

    def test_pins_know_the_world(self):
        self.expect_include("firmware-stubs/pins/src/a.cpp", "eyebridge/robot/simulation.hpp", allowed=True)

    def test_the_bridges_know_no_firmware(self):
        self.expect_include("bridges/transport/src/a.cpp", "eyebridge/ports/port.hpp", allowed=False)

    def test_nobody_includes_the_gui(self):
        self.expect_include("robios/src/a.cpp", "eyebridge/gui/window.hpp", allowed=False)

    def test_a_private_header_of_another_room_is_found_by_its_name(self):
        self.write("tests/support/rig.hpp")
        self.expect_include("hal/sim/a.cpp", "rig.hpp", allowed=False)

    def test_a_way_around_by_dots_is_found(self):
        self.write("apps/eyebridge/command.hpp")
        self.write("robios/src/command.hpp")
        self.expect_include("hal/sim/a.cpp", "../../apps/eyebridge/command.hpp", allowed=False)

    def test_a_private_header_of_the_same_room_is_fine(self):
        self.write("apps/eyebridge/session.hpp")
        self.write("robios/src/session.hpp")
        self.expect_include("robios/v7/a.cpp", "session.hpp", allowed=True)

    def test_examples_know_the_c_api_alone(self):
        self.expect_include("examples/a.cpp", "eyebridge/base/pose.hpp", allowed=False)

    def test_an_example_may_include_the_c_api(self):
        self.write("robios/include/eyebot.h")
        self.expect_include("examples/a.cpp", "eyebot.h", allowed=True)

    def test_a_folder_that_is_no_room_is_found(self):
        self.write("misc/a.cpp")
        self.assertEqual(self.offences(), ["misc/a.cpp: this folder is no room of the architecture"])

    def test_what_is_built_does_not_count(self):
        self.write("misc/README.md")
        (self.root / "build").mkdir()
        (self.root / "build" / "a.cpp").write_text('#include "eyebridge/gui/window.hpp"\n')
        self.assertEqual(self.offences(), [])


class Circles(Tree):
    def test_two_folders_that_include_each_other_are_an_offence(self):
        self.write("gui/plan/a.hpp", '#pragma once\n#include "editor/b.hpp"\n')
        self.write("gui/editor/b.hpp", '#pragma once\n#include "plan/a.hpp"\n')
        found = self.offences()
        self.assertEqual(len(found), 1, found)
        self.assertIn("gui/editor, gui/plan: include each other in a circle", found[0])

    def test_a_circle_may_be_longer(self):
        for home, target in (("a", "b"), ("b", "c"), ("c", "a")):
            self.write(f"gui/{home}/{home}.hpp", f'#pragma once\n#include "{target}/{target}.hpp"\n')
        self.assertIn("gui/a, gui/b, gui/c: include each other in a circle", self.offences()[0])

    def test_a_way_down_is_none(self):
        self.write("gui/editor/b.hpp", '#pragma once\n#include "plan/a.hpp"\n')
        self.write("gui/plan/a.hpp", "#pragma once\n")
        self.assertEqual(self.offences(), [])


class Forgotten(Tree):
    def test_a_name_without_its_header_is_found(self):
        self.write("hal/sim/a.cpp", "#include <string>\n// std::optional<int>\nstd::vector<std::string> names;\n")
        self.assertEqual(self.offences(), ["hal/sim/a.cpp:3: std::vector needs #include <vector>"])

    def test_a_header_of_ours_may_bring_it(self):
        self.write("core/base/include/eyebridge/base/names.hpp", "#pragma once\n#include <vector>\nstd::vector<int> all();\n")
        self.write("hal/sim/a.cpp", '#include "eyebridge/base/names.hpp"\nstd::vector<int> more;\n')
        self.assertEqual(self.offences(), [])

    def test_a_test_needs_googletest(self):
        self.write("tests/hal/a.cpp", "TEST(A, Is) {}\n")
        self.assertEqual(self.offences(), ["tests/hal/a.cpp:1: TEST needs #include <gtest/gtest.h>"])

    def test_an_unused_using_declaration_is_found(self):
        self.write("hal/sim/a.cpp", "\nusing std::chrono::seconds;\nusing testing::Not;\nseconds second();\n")
        self.assertEqual(self.offences(), ["hal/sim/a.cpp:3: Not is not used"])


class SameBits(Tree):
    def test_a_function_that_differs_between_computers_is_found(self):
        self.write("hal/sim/a.cpp", "#include <cmath>\n// not std::sin(x)\ndouble b = std::sqrt(2.0);\ndouble a = std::exp2(b);\n")
        self.assertEqual(self.offences(),
                         ["hal/sim/a.cpp:4: std::exp2() differs between computers; expected base/math.hpp, or std::sqrt"])

    def test_tests_and_windows_may_call_it(self):
        self.write("gui/a.cpp", "#include <cmath>\ndouble a = std::exp2(0.5);\n")
        self.assertEqual(self.offences(), [])


class Sizes(Tree):
    def test_400_lines_are_allowed(self):
        self.write("hal/sim/a.cpp", "\n" * 400)
        self.assertEqual(self.offences(), [])

    def test_401_lines_are_too_long(self):
        self.write("hal/sim/a.cpp", "\n" * 401)
        self.assertEqual(self.offences(), ["hal/sim/a.cpp: 401 lines; expected at most 400"])

    def test_a_readme_has_less_than_30_lines(self):
        self.write("hal/README.md", "\n" * 30)
        self.assertEqual(self.offences(), ["hal/README.md: 30 lines; expected at most 29"])

    def test_a_folder_without_readme_is_found(self):
        self.write("core/base/src/a.cpp")
        (self.root / "core/base/README.md").unlink()
        self.assertEqual(self.offences(), ["core/base: has no README.md"])


class Maps(Tree):
    def of(self, text):
        self.write("hal/sim/sim_drive.hpp", "#pragma once\n")
        self.write("hal/README.md")
        (self.root / "hal/README.md").write_text(text)
        return self.offences()

    def test_files_and_folders_of_tables_are_below(self):
        self.assertEqual(self.of("| `sim_*.hpp`, `sim/`, `sim/sim_drive.*`, `NAME_test.cpp`, `robot 2` | `not_a_name.cpp` |\n"), [])

    def test_one_that_is_gone_is_found(self):
        self.assertEqual(self.of("\n| `sim_drive.hpp`, `sim_motor.hpp` | what |\n"),
                         ["hal/README.md:2: names sim_motor.hpp; expected a file or folder below hal"])

    def test_links_lead_somewhere(self):
        self.assertEqual(self.of("[a](sim/sim_drive.hpp) [b](../hal/README.md#c) [d](https://e.f)\n[g](seat/README.md)\n"),
                         ["hal/README.md:2: links to seat/README.md; expected a file or folder that is there"])


class Picture(Tree):
    def setUp(self):
        super().setUp()
        self.write("core/base/include/eyebridge/base/pose.hpp", "#pragma once\n")
        self.write("core/world/src/world.cpp", '#include "eyebridge/base/pose.hpp"\n')
        self.write("hal/include/eyebridge/hal/drive.hpp", "#pragma once\n")
        self.write("robios/src/vw.cpp", '#include "eyebridge/hal/drive.hpp"\n#include "eyebridge/base/pose.hpp"\n')

    def wrong(self, page):
        return picture.wrong_with(page, picture.shown(picture.includes(self.root)))

    def test_a_shorter_way_is_left_out(self):
        self.write("hal/src/drive.cpp", '#include "eyebridge/base/pose.hpp"\n')
        arrows = picture.shown(picture.includes(self.root))
        self.assertEqual(arrows, [("core/world", "core/base"), ("hal", "core/base"), ("robios", "hal")])

    def test_each_arrow_is_drawn_and_explained_and_no_other(self):
        arrows = picture.shown(picture.includes(self.root))
        page = picture.drawn(arrows) + "".join(f"| {home} → {target} | why |\n" for home, target in arrows)
        self.assertEqual(self.wrong(page), [])
        self.assertEqual(self.wrong(page.replace("| robios → hal | why |", "| robios → hal |  |")),
                         ["docs/architecture.md: no sentence says why robios includes hal"])
        self.assertEqual(self.wrong(page + "| hal → gui | why |\n"), ["docs/architecture.md: hal → gui is explained, and not there"])
        self.assertIn("the picture is not that of the includes", self.wrong(page.replace("robios[robios]", "gui[gui]"))[0])


if __name__ == "__main__":
    unittest.main()
