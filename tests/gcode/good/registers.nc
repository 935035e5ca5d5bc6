%
O1005
(lengths and radii of Fanuc: geometry, and wear that is added to it)
G21 G90 G17 G54 F100
G10 L10 P1 R100.
G10 L11 P1 R0.5
G10 L12 P1 R4.
G10 L13 P1 R-0.5
G91 G10 L13 P1 R-0.5
G90
G0 X0. Y0. Z5.
G41 D1
G1 X10. Y10.
X40.
Y30.
G40
X50. Y50.
#1=#2001
M30
%
