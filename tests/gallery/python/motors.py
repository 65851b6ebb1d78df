from eye import *
import sys

ENCODERReset(1)
ENCODERReset(2)
for left, right in [(20, 20), (20, 10), (-10, 10), (0, 0)]:
    MOTORDrive(1, left)
    MOTORDrive(2, right)
    OSWait(1000)
    l, r = ENCODERRead(1), ENCODERRead(2)
    print(left, right, l > 0, r > 0)
    LCDPrintf("%4d %4d: %6d %6d\n", left, right, l, r)
print("no motor 7:", MOTORDrive(7, 10))
print("no PSD 9:", PSDGet(9))
SERVOSet(1, 200)
AUBeep()
if len(sys.argv) > 1:
    print("arguments", sys.argv[1:])
    exit(4)
