(A plate with what three axes leave: holes, a pocket, a bent slot, grooves of ball and bull nose, a chamfer.)
(T1 D=10. CR=0. - flat end mill)
(T2 D=6. CR=0. TAPER=118deg - drill)
(T3 D=8. CR=4. - ball end mill)
(T4 D=12. CR=2. - bull nose end mill)
(T5 D=10. CR=0. TAPER=45deg - chamfer mill)
(STOCK/BLOCK,120.,80.,20.,0.,0.,20.)
G21 G90 G17
T1 M6 S8000 M3
G0 X15. Y15. Z5.
G1 Z-4. F300.
G1 X35.
G1 Y30.
G1 X15.
G1 Y15.
G1 Y22.
G1 X35.
G0 Z5.
G0 X50. Y15.
G1 Z-5.
G1 X65.
G3 X75. Y25. I0. J10.
G1 Y40.
G0 Z5.
G0 X95. Y20.
G1 Z-6.
G3 X95. Y20. I-5. J0.
G0 Z5.
T2 M6 S5000 M3
G0 X110. Y10. Z5.
G1 Z-12. F150.
G0 Z5.
G0 X110. Y70.
G1 Z-25.
G0 Z5.
T3 M6 S8000 M3
G0 X15. Y45. Z5.
G1 Z-3. F300.
G1 X45.
G1 X55. Y55.
G0 Z5.
G0 X30. Y65.
G1 Z-2.
G2 X30. Y65. I-8. J0.
G0 Z5.
T4 M6 S8000 M3
G0 X75. Y60. Z5.
G1 Z-3. F300.
G1 X105. Y55.
G0 Z5.
T5 M6 S8000 M3
G0 X-10. Y-3. Z5.
G1 Z-4. F300.
G1 X130.
G0 Z5.
M30
