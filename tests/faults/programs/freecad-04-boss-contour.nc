(Exported by FreeCAD)
(Post Processor: PathScripts.post.grbl_post)
(Output Time:not recorded)
(Begin preamble)
G17 G90
G21
(Begin operation: G54)
(Path: G54)
G54
G0 Z20.000
(Finish operation: G54)
(Begin operation: T1 flat 10 mm)
(Path: T1 flat 10 mm)
(T1 flat 10 mm)
(Begin toolchange)
M6 T1
M3 S8000
(Finish operation: T1 flat 10 mm)
(Begin operation: Boss rough)
(Path: Boss rough)
(Boss rough)
(Compensated Tool Path. Diameter: 10.0)
G0 Z40.000
G0 X19.796 Y19.796
G0 Z3.000
G1 X19.796 Y19.796 Z-3.000 F300.000
G2 X2.460 Y-27.887 Z-3.000 I-19.796 J-19.796 K0.000 F800.000
G2 X-2.460 Y27.887 Z-3.000 I-2.460 J27.887 K0.000 F800.000
G2 X19.796 Y19.796 Z-3.000 I2.460 J-27.887 K0.000 F800.000
G1 X19.796 Y19.796 Z-6.000 F300.000
G2 X2.460 Y-27.887 Z-6.000 I-19.796 J-19.796 K0.000 F800.000
G2 X-2.460 Y27.887 Z-6.000 I-2.460 J27.887 K0.000 F800.000
G2 X19.796 Y19.796 Z-6.000 I2.460 J-27.887 K0.000 F800.000
G0 Z40.000
G0 Z40.000
(Finish operation: Boss rough)
(Begin operation: Boss finish)
(Path: Boss finish)
(Boss finish)
(Compensated Tool Path. Diameter: 10.0)
G0 Z40.000
G0 X14.140 Y14.140
G0 Z3.000
G1 X14.140 Y14.140 Z-3.000 F300.000
G2 X1.605 Y-19.933 Z-3.000 I-14.140 J-14.140 K0.000 F800.000
G2 X-1.605 Y19.933 Z-3.000 I-1.605 J19.933 K0.000 F800.000
G2 X14.140 Y14.140 Z-3.000 I1.605 J-19.933 K0.000 F800.000
G1 X14.140 Y14.140 Z-6.000 F300.000
G2 X1.605 Y-19.933 Z-6.000 I-14.140 J-14.140 K0.000 F800.000
G2 X-1.605 Y19.933 Z-6.000 I-1.605 J19.933 K0.000 F800.000
G2 X14.140 Y14.140 Z-6.000 I1.605 J-19.933 K0.000 F800.000
G0 Z40.000
G0 Z40.000
(Finish operation: Boss finish)
(Begin postamble)
M5
G17 G90
M2
