(a floor and a fillet with a bull-nose mill)
(T1 D=10. CR=2. - bull nose end mill)
(STOCK/BLOCK,50.,40.,12.,0.,0.,12.)
G21 G90 G17 G94 G54
T1 M6
S5000 M3
G0 X-8. Y10. Z5.
G0 Z-4.
G1 X25. F400.
Y48.
G0 Z20.
M5
M30
