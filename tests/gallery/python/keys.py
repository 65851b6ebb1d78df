from eye import *

names = {KEY1: "left", KEY2: "right", KEY3: "up", KEY4: "down"}
count = {}

def show():
    row = 2
    for k in sorted(count):
        LCDSetPrintf(row, 0, "%-6s %d times", names[k], count[k])
        row += 1

LCDMenu("LEFT", "RIGHT", "UP", "DOWN")
while True:
    key = KEYGet()
    count[key] = count.get(key, 0) + 1
    show()
    if count[key] == 3:
        break
print(names[key], "was first")
LCDMenuI(1, "again?", BLACK, CYAN)
while KEYRead() == 0:
    OSWait(20)
