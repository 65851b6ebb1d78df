maze m.maz
error psd 5 1
accel 9 9
psd_range 1 9
