(Exported by FreeCAD)
(Post Processor: PathScripts.post.linuxcnc_post)
(Output Time:not recorded)
(begin preamble)
G17 G54 G40 G49 G80 G90
G20
(begin operation: G54)
(machine units: in/min)
G54 
G0 Z5.9055 
(finish operation: G54)
(begin operation: T11 drill 5 mm)
(machine units: in/min)
(T11 drill 5 mm) 
M5
M6 T11 
G43 H11 
M3 S2500 
(finish operation: T11 drill 5 mm)
(begin operation: Drill 5)
(machine units: in/min)
(Drill 5) 
(Begin Drilling) 
G0 Z1.5748 
G90 
G98 
G0 X0.0000 Y-0.5000 
G0 Z0.1181 
G81 X0.0000 Y-0.5000 Z-0.5787 F5.9055 R0.0787 
G0 X0.0000 Y0.5000 
G0 Z0.1181 
G81 X0.0000 Y0.5000 Z-0.5787 F5.9055 R0.0787 
G80 
G0 Z0.1181 
G0 Z1.5748 
(finish operation: Drill 5)
(begin operation: T12 drill 6.35 mm)
(machine units: in/min)
(T12 drill 6.35 mm) 
M5
M6 T12 
G43 H12 
M3 S2000 
(finish operation: T12 drill 6.35 mm)
(begin operation: Drill quarter inch)
(machine units: in/min)
(Drill quarter inch) 
(Begin Drilling) 
G0 Z1.5748 
G90 
G98 
G0 X-1.0000 Y-0.5000 
G0 Z0.1181 
G83 X-1.0000 Y-0.5000 Z-0.5906 F4.7244 Q0.1575 R0.0787 
G0 X-1.0000 Y0.5000 
G0 Z0.1181 
G83 X-1.0000 Y0.5000 Z-0.5906 F4.7244 Q0.1575 R0.0787 
G0 X1.0000 Y0.5000 
G0 Z0.1181 
G83 X1.0000 Y0.5000 Z-0.5906 F4.7244 Q0.1575 R0.0787 
G0 X1.0000 Y-0.5000 
G0 Z0.1181 
G83 X1.0000 Y-0.5000 Z-0.5906 F4.7244 Q0.1575 R0.0787 
G80 
G0 Z0.1181 
G0 Z1.5748 
(finish operation: Drill quarter inch)
(begin postamble)
M05
G17 G54 G90 G80 G40
M2
