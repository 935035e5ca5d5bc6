; 2:4: error: expected a number after X [number-expected]
G1 X Y2
