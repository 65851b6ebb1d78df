from eye import *

n = 0
def tick():
    global n
    n += 1

t = OSAttachTimer(100, tick)
OSWait(2050)
print("ticks", n)
OSDetachTimer(t)
OSWait(500)
print("ticks", n)
start = OSGetCount()
OSWait(1000)
print("waited", OSGetCount() - start)
h, m, s, t = ctypes.c_int(), ctypes.c_int(), ctypes.c_int(), ctypes.c_int()
OSGetTime(h, m, s, t)
print("%02d:%02d:%02d" % (h.value, m.value, s.value))
LCDSetPrintf(0, 0, "%d ticks", n)
