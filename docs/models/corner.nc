(corner.nc: two millimetres of a part, to compare the models of the workpiece)
(T1 D=1.5 CR=0.75 - ball end mill)
(T2 D=0.8 CR=0. - flat end mill)
(STOCK/BLOCK,2.,2.,1.5,0.,0.,1.5)
G21 G90 G17
T1 M6
S20000 M3
G0 X-1. Y0.3 Z2.
G1 Z-0.4 F300.
X3. Y0.9 Z-0.6
G0 Z2.
T2 M6
S20000 M3
G0 X1.5 Y3. Z2.
G1 Z-0.9 F300.
X0.9 Y1.1
X2.6 Y1.3
G0 Z2.
M30
