; 2:1: error: the start of this G2 is 2 from its centre, the end 12.806248 [arc-radius-mismatch]
G2 X10 Y10 I2 J0 F100
