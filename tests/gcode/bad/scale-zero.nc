; 2:1: error: a scale of 0 leaves nothing [scale-zero]
G51 X0 Y0 P0
