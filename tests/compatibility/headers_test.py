"""What the page says comes from the headers: they must be read right."""

import unittest

from headers import comment_text, declarations, differences


class Headers(unittest.TestCase):
    def test_a_function_has_the_comment_before_it(self):
        self.assertEqual(declarations("/** Beeps. */\nint AUBeep(void);\n"), {"AUBeep": "Beeps."})

    def test_one_without_a_comment_has_that_of_the_one_before(self):
        found = declarations("/** Old names. */\nint VWDriveDone(void);\nint VWDriveWait(void);\n")
        self.assertEqual(found, {"VWDriveDone": "Old names.", "VWDriveWait": "Old names."})

    def test_comments_over_several_lines_become_one(self):
        self.assertEqual(comment_text("/**\n * One\n * two.\n */"), "One two.")

    def test_a_name_in_a_comment_is_no_declaration(self):
        self.assertEqual(declarations("/** As VWWait(). */\nextern int IP_WIDTH, IP_HEIGHT;\n"), {})

    def test_types_and_macros_are_none(self):
        self.assertEqual(declarations("#define MAX(a, b) (a)\ntypedef void (*Fct)(void);\n"), {})

    def test_a_function_that_takes_one_is_found(self):
        text = "/** Calls. */\nTIMER OSAttachTimer(int scale, void (*fct)(void));\n"
        self.assertEqual(list(declarations(text)), ["OSAttachTimer"])

    def test_of_a_comment_only_what_compares_is_a_difference(self):
        self.assertEqual(differences("Sets it. 0 is off (EyeSim: an angle). Any thread."), "0 is off (EyeSim: an angle).")


if __name__ == "__main__":
    unittest.main()
