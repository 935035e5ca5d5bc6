; 4:11: error: on this control cutter compensation begins with a straight move that turns no axis [compensation-entry]
O1005
G21 G90 G17 F100.
G41.1 D2. G2 X10. Y0. I5.
M30
