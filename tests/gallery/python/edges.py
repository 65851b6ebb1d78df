from eye import *

CAMInit(QVGA)
gray = CAMGetGray()
print("gray", len(gray))
LCDImageStart(0, 0, 320, 240)
LCDImageGray(IPLaplace(gray))
OSWait(500)
edge = IPSobel(gray)
for i in range(len(edge)):
    edge[i] = 255 if (edge[i] & 0xff) > 60 else 0
LCDImage(IPOverlayGray(gray, edge, RED))
col = CAMGet()
h, s, i = IPCol2HSI(col)
print("hsi", len(h), len(s), len(i))
LCDImageStart(330, 0, 160, 120)
print("red", IPPRGB2HSI(255, 0, 0))
same = sum(1 for a, b in zip(IPCol2Gray(col), gray) if a == b)
print("gray is the mean:", same > 70000)
LCDMenu("", "", "", "END")
KEYWait(KEY4)
