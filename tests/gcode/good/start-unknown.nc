; nothing is known of where the tool stands until an axis is commanded
G1 Z-1 F100
X10
Y10
X0
M2
