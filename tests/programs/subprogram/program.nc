(a subprogram in the same file is called three times)
(T1 D=4. CR=0. - flat end mill)
(STOCK/BLOCK,60.,30.,8.,0.,0.,8.)
O1000
G21 G90 G17 G94 G54
T1 M6
S8000 M3
G0 X10. Y15. Z2.
M98 P2000 L3
G90 G0 Z20.
M5
M30
O2000
G91 G1 Z-4. F200.
Y5. F400.
Z4. F800.
G0 X18. Y-5.
G90
M99
