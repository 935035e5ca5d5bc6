; offsets and a stop written as variables; dialect: fanuc, offsets: told
O1
G21 G90 G54 G0 X0. Y0. Z5.
#5221=5.
X0.
#7001=10.
G54.1 P1 X0.
#3006=1 (TURN THE PART)
M30
