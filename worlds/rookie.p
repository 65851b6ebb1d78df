# A parameter file as EyeSim 1 to 4 read it.
name      Rookie
diameter  150        # mm
speed     40         # cm/s
turn      180        # deg/s
world     u-trap.wld
pause     on
psd  PSD_FRONT 1    0  70  0
psd  PSD_LEFT  2   90  70  0
psd  PSD_RIGHT 3  -90  70  0
ir   IR_FRONT  1    0  75  0
bump BUMP_RIGHT 1 -180  0
