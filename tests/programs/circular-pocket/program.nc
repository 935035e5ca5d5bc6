(a round pocket: helix down, one circle at full depth)
(T1 D=6. CR=0. - flat end mill)
(STOCK/BLOCK,40.,40.,10.,0.,0.,10.)
G21 G90 G17 G94 G54
T1 M6
S8000 M3
G0 X25. Y20. Z1.
G1 Z0. F200.
G3 X25. Y20. Z-2. I-5. J0.
G3 X25. Y20. Z-4. I-5. J0.
G3 X25. Y20. I-5. J0.
G1 X20. F400.
G0 Z20.
M5
M30
