# ping-pong; alone we play with ourselves
from eye import *

RADIOInit()
me = RADIOGetID()
total, ids = RADIOStatus()
print("robot", me, "of", total)
partner = me
for i in range(total):
    if ids[i] != me:
        partner = ids[i]
RADIOSend(partner, "ping 0")
for i in range(5):
    sender, text = RADIOReceive()
    print("from", sender, text, ord(text[0]))
    LCDPrintf("%d: %s\n", sender, text)
    word, n = text.split()
    RADIOSend(sender, ("pong" if word == "ping" else "ping") + " %d" % (int(n) + 1))
print("waiting", RADIOCheck())
RADIORelease()
