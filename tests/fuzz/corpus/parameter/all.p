name R
diameter 150 # mm
speed 40
turn 180
world w.wld
pause on
debug off
psd A -1 90 70 0
ir B 1 0 75 45 120
bump C 2 -180 0
