(rounded corners by R: less than half a turn, and more than half a turn)
(T1 D=4. CR=0. - flat end mill)
(STOCK/BLOCK,60.,40.,8.,0.,0.,8.)
G21 G90 G17 G94 G54
T1 M6
S9000 M3
G0 X10. Y8. Z2.
G1 Z-2. F150.
X30. F400.
G3 X38. Y16. R8.
G1 Y20.
G3 X46. Y28. R-8.
G0 Z20.
M5
M30
