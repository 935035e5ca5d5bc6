(lengths in inches: a slot of a quarter inch)
(T1 D=0.25 CR=0. - flat end mill)
(STOCK/BLOCK,2.,1.,0.5,0.,0.,0.5)
G20 G90 G17 G94 G54
T1 M6
S8000 M3
G0 X-0.25 Y0.5 Z0.1
G0 Z-0.125
G1 X2.25 F20.
G0 Z1.
M5
M30
