"""What LCDPrintf() makes of the values of Python."""

import ctypes
import unittest

from eye._format import c_format
from support import main


class Format(unittest.TestCase):
    def expect(self, text, form, *arguments):
        self.assertEqual(c_format(form, arguments), text)

    def test_it_prints_as_c_does(self):
        self.expect("  42|42  |0042|+42", "%4d|%-4d|%04d|%+d", 42, 42, 42, 42)
        self.expect("2a 2A 52 0x2a", "%x %X %o %#x", 42, 42, 42, 42)
        self.expect("3.14 3.141590 3.14159", "%.2f %f %g", 3.14159, 3.14159, 3.14159)
        self.expect("ab  |   ab|a", "%-4s|%5s|%.1s", "ab", "ab", "ab")
        self.expect("x y", "%c %c", "x", 121)
        self.expect("50%", "50%%")
        self.expect("   7|3.1", "%*d|%.*f", 4, 7, 1, 3.14)
        self.expect("1 2 3", "%ld %lu %lld", 1, 2, 3)
        self.expect("4294967295", "%u", -1)
        self.expect("ffffffff", "%x", -1)

    def test_int_and_float_stand_in_for_each_other(self):
        self.expect("3 -3", "%d %d", 3.9, -3.9)
        self.expect("5.0", "%.1f", 5)

    def test_any_value_is_a_string(self):
        self.expect("5 None b", "%s %s %s", 5, None, b"b")

    def test_ctypes_numbers_are_numbers(self):
        self.expect("5 2.5", "%d %.1f", ctypes.c_int(5), ctypes.c_double(2.5))

    def test_surplus_arguments_are_ignored(self):
        self.expect("text", "text", "")
        self.expect("1", "%d", 1, 2, "three")

    def test_a_missing_argument_shows_where(self):
        self.expect("1 %d", "%d %d", 1)
        self.expect("100%", "100%")
        self.expect("%s", "%s")

    def test_what_cannot_be_shown_shows_where(self):
        self.expect("%d", "%d", "many")
        self.expect("%y %n", "%y %n", 1)
        self.expect("%d", "%d", float("nan"))

    def test_a_tuple_stands_for_its_values(self):
        self.expect("1 2", "%d %d", (1, 2))

    def test_what_is_no_string_is_printed(self):
        self.assertEqual(c_format(5, ()), "5")


if __name__ == "__main__":
    main()
