from eye import *
import threading

lock = threading.Lock()

def display():
    for n in range(40):
        with lock:
            x, y, phi = VWGetPosition()
            LCDSetPrintf(0, 0, "%4d %4d %4d", x, y, phi)
        OSWait(50)
    LCDSetPrintf(1, 0, "display ends")

t = threading.Thread(target=display)
t.start()
for i in range(3):
    VWStraight(250, 200)
    VWWait()
    VWTurn(120, 90)
    VWWait()
t.join()
LCDSetPrintf(0, 0, "triangle      ")
print("triangle done")
