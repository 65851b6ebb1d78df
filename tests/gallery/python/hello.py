#!/usr/bin/env python3
from eye import *

LCDPrintf("Hello from Python!\n")
LCDPrintf("%d %s\n", 42, "is the answer")
LCDSetPrintf(5, 10, "five and ten: %5.2f", 3.14159)
LCDPrintf("no arguments but a sign: 100%%\n")
LCDPrintf("one too many\n", "")
LCDMenu("A", "B", "C", "END")
key = KEYWait(KEY4)
print("key", key)
