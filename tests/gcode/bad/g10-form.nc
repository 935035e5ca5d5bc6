; 3:1: error: this form of G10 is not known; it is left out [g10-form]
G21 G90 G0 X0 Y0 Z0
G10 L55
M2
