; 2:1: error: G68 needs an angle (R) [rotation-without-angle]
G68 X1 Y1
