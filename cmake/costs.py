#!/usr/bin/env python3
"""costs.py RESULTS.xml: what the tests of `./test all` cost, from ctest's JUnit file: seconds by build and by room, dearest first."""

import sys
import xml.etree.ElementTree as ElementTree
from collections import Counter

ROWS = 24


def place(name):
    """core.Walls.Touch@ci counts for ('core', 'ci'); a stage without a build for itself."""
    name, _, preset = name.partition("@")
    return name.split(".")[0] if preset else name, preset or "a stage"


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: costs.py RESULTS.xml")
    seconds, count = Counter(), Counter()
    for case in ElementTree.parse(sys.argv[1]).iter("testcase"):
        seconds[place(case.get("name"))] += float(case.get("time"))
        count[place(case.get("name"))] += 1
    for key, cost in seconds.most_common(ROWS):
        print(f"{cost:6.0f}  {key[0]} ({key[1]}, {count[key]})")
    rest = [key for key, _ in seconds.most_common()[ROWS:]]
    print(f"{sum(seconds[key] for key in rest):6.0f}  {len(rest)} others, {sum(count[key] for key in rest)} tests")
    print(f"{sum(seconds.values()):6.0f}  in all, {sum(count.values())} tests")


main()
