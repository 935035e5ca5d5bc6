%
(complex.nc: a chaotic mix of straight and circular cuts, each crossing what was cut before)
(Near the end two cuts run across the whole top and meet all of it. Zero: middle of the top)
(T1 D=8. CR=0. - ZMIN=-8. - flat end mill)
(T2 D=5. CR=0. - ZMIN=-10. - flat end mill)
(STOCK/BLOCK,100.,100.,20.,50.,50.,20.)
G21 G90 G17 G94 G40
G54
T1 M6
S6000 M3
G0 G43 H1 X-60. Y-40. Z10.
M8
(a lattice of slots: four across, three along, one askew)
G0 Z-3.
G1 X60. F1000.
G0 Z10.
G0 Y-14.
G0 Z-4.
G1 X-60.
G0 Z10.
G0 Y12.
G0 Z-3.
G1 X60.
G0 Z10.
G0 Y38.
G0 Z-5.
G1 X-60.
G0 Z10.
G0 X-34. Y60.
G0 Z-4.
G1 Y-60.
G0 Z10.
G0 X-2.
G0 Z-6.
G1 Y60.
G0 Z10.
G0 X30.
G0 Z-4.
G1 Y-60.
G0 Z10.
G0 X60. Y-30.
G0 Z-5.
G1 X-60. Y26.
G0 Z10.
(a slot that turns left and then right)
G0 X-60. Y-26.
G0 Z-6.
G1 X-20.
G3 X-16. Y-22. I0. J4.
G1 Y2.
G2 X-12. Y6. I4. J0.
G1 X60.
G0 Z10.
(a zigzag on a ramp)
G0 X60. Y44.
G0 Z-2.
G1 X40. Y20.
X34. Y46. Z-4.
X22. Y18. Z-5.
X10. Y46. Z-6.
X2. Y22. Z-7.
X-12. Y44. Z-8.
G0 Z10.
(small arcs in all three planes: a ramp, and two dips)
T2 M6
S9000 M3
G0 G43 H2 X-44. Y-5. Z10.
G1 Z-2. F300.
G2 X-41. Y-2. Z-5. I3. J0. F800.
G1 X-26.
G18 G2 X-20. Z-5. I3. K6.
G17 G1 X-6.
G2 X-3. Y-5. I0. J-3.
G1 Y-34.
G0 Z10.
G0 X8. Y-42.
G1 Z-4. F300.
G19 G3 Y-38. Z-4. J2. K6. F800.
G17 G1 X24. Y-24.
G3 X26. Y-20. R5.
G1 X36. Y-4.
G0 Z10.
(across the whole top, through everything)
T1 M6
S6000 M3
G0 G43 H1 X-58. Y-58. Z10.
G0 Z-7.
G1 X58. Y58. F900.
G0 Z10.
G0 X-58.
G0 Z-3.
G1 X58. Y-58.
G0 Z10.
(and a frame around what is left)
G0 X-60. Y-48.
G0 Z-8.
G1 X48.
Y48.
X-48.
Y-60.
G0 Z10.
M9
M5
G28 G91 Z0.
G90
M30
%
