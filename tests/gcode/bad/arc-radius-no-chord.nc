; 2:10: error: an arc by R must not end where it starts [arc-radius-no-chord]
G2 X0 Y0 R5 F1
