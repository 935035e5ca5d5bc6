(The bed with its column, which is fixed: Y goes along two rails, X on the front of the column)
G21 G90 G17 G94
S500 M3
(above the bed, up to the column)
T1 M6
G0 X-600 Y-10 Z400
G1 Z-482 F5000
G1 X600
G1 Y-210
G1 X-600
G0 Z400
(between the rails, and beside them)
T2 M6
G0 X0 Y-500
G1 Z-500
G1 Y60
G1 Y-500
G0 Z400
G0 X-290 Y-500
G1 Z-500
G1 Y500
G0 Z400
G0 X290 Y-500
G1 Z-500
G1 Y500
G0 Z400
(the guideway of X: the tool comes from the front)
T3 M6
G0 X0 Y0 Z600
G0 A90
G0 X-400 Y110 Z500
G1 Z-206
G1 X400
G0 Z500
(a window in the column)
T2 M6
G0 X0 Y-250
G1 Z-400
G1 Y-180
G0 Z600
G0 A0
M30
