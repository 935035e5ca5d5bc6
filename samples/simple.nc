%
(simple.nc: straight cuts with a flat end mill that is tilted a little about X between them)
(The grooves hardly meet: few hulls, few intersections. Program zero: middle of the top)
(T1 D=6. CR=0. - ZMIN=-9.4 - flat end mill)
(STOCK/BLOCK,120.,80.,25.,60.,40.,25.)
G21 G90 G17 G94 G40
G54
T1 M6
S8000 M3
G0 X-75. Y-34. Z30.
M8
(ten grooves along X: the tool leans from A-9. to A9., two degrees more each time)
G0 X-75. Y-34. A-9.
G0 Z-9.4
G1 X75. F900.
G0 Z30.
G0 X75. Y-26.5 A-7.
G0 Z-8.3
G1 X-75. F900.
G0 Z30.
G0 X-75. Y-19. A-5.
G0 Z-7.7
G1 X75. F900.
G0 Z30.
G0 X75. Y-11.5 A-3.
G0 Z-5.6
G1 X-75. F900.
G0 Z30.
G0 X-75. Y-4. A-1.
G0 Z-4.1
G1 X75. F900.
G0 Z30.
G0 X75. Y4. A1.
G0 Z-4.1
G1 X-75. F900.
G0 Z30.
G0 X-75. Y11.5 A3.
G0 Z-5.6
G1 X75. F900.
G0 Z30.
G0 X75. Y19. A5.
G0 Z-7.7
G1 X-75. F900.
G0 Z30.
G0 X-75. Y26.5 A7.
G0 Z-8.3
G1 X75. F900.
G0 Z30.
G0 X75. Y34. A9.
G0 Z-9.4
G1 X-75. F900.
G0 Z30.
(four slots from the sides, upright and leaning)
G0 X-40. Y-60. A0.
G0 Z-7.
G1 Y-24. F700.
G0 Z30.
G0 X40. Y-60. A-4.
G0 Z-9.
G1 Y-24. F700.
G0 Z30.
G0 X40. Y60. A0.
G0 Z-7.
G1 Y24. F700.
G0 Z30.
G0 X-40. Y60. A4.
G0 Z-9.
G1 Y24. F700.
G0 Z30.
(four corners, cut off with the tool upright)
G0 A0.
G0 X-68. Y-26.
G0 Z-7.
G1 X-46. Y-48. F800.
G0 Z30.
G0 X46. Y-48.
G0 Z-7.
G1 X68. Y-26. F800.
G0 Z30.
G0 X68. Y26.
G0 Z-7.
G1 X46. Y48. F800.
G0 Z30.
G0 X-46. Y48.
G0 Z-7.
G1 X-68. Y26. F800.
G0 Z30.
M9
M5
G28 G91 Z0.
G90
M30
%
