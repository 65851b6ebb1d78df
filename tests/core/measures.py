#!/usr/bin/env python3
"""measures.py BUILD: runs the tests that measure maps, localisation and planning, and prints what they measured.

What a test measures it gives to RecordProperty(); whether that is good enough it checks itself.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

TESTS = (
    ("test_core_files", "*MapQuality*"),
    ("test_core_localisation", "GridSlam.Draws*:LandmarkEkf.IsAsSure*:ScanMatcher.FindsNoisy*"),
    ("test_core_localisation_seeds", "*"),
    ("test_core_planning", "Astar.IsAsShort*:ThetaStar.IsNever*:RrtStar.IsWithin*"),
)
GTESTS_OWN = {"name", "file", "line", "status", "result", "timestamp", "time", "classname", "value_param", "type_param"}


def measure(program, which):
    """Runs the tests `which` of `program` and prints their measures. Whether all passed."""
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder) / "report.json"
        words = [program, f"--gtest_filter={which}", "--gtest_brief=1", f"--gtest_output=json:{report}"]
        passed = subprocess.run(words).returncode == 0
        tests = [test for suite in json.loads(report.read_text())["testsuites"] for test in suite["testsuite"]]
    for test in tests:
        print(f"{test['classname']}.{test['name']}: {'failed' if 'failures' in test else 'passed'}, {test['time']}")
        for name, value in test.items():
            if name not in GTESTS_OWN and name != "failures":
                print(f"    {name.replace('_', ' ')}: {value}")
    return passed and bool(tests)


def main():
    bin_folder = pathlib.Path(sys.argv[1]) / "bin"
    results = [measure(bin_folder / program, which) for program, which in TESTS]
    sys.exit(0 if all(results) else 1)


if __name__ == "__main__":
    main()
