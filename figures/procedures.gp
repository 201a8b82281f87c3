# The motion as procedures of the author may have found it. (a) Bars: the windows of Figure 3 in
# which no chatter of mass 1 is complete, by procedure; grey: as printed; lines: the edges of the
# first row. (b) Dual sticks a period in the scenes of Figure 5 against the place of the second stop;
# grey: where the forces allow them; circles: the printed scenes.
load 'figures/style.gp'
windows = data.'/procedures_windows.csv'
dual = data.'/procedures_dual.csv'
half_step = 0.0005  # of the frequencies
stats windows using 'number' nooutput name 'row'
rows = row_max + 1

eval page('procedures', 2, 1)
set lmargin at screen 0.31; set tmargin at screen 0.985; set bmargin at screen 0.42
set label 1 '(a)' at screen 0.01, screen 0.965
set xlabel 'Ω {/*0.85 (dashed: ends of the first row)}'
set xrange [0.28:0.42]; set xtics 0.01
set yrange [rows - 0.4:-0.6]  # row 0 is the header
set label 2 'printed: ≈0.3 to ≈0.35' at 0.325, 0 center front
set label 3 '≈0.37 to ≈0.4' at 0.385, 0 center front
set ytics scale 0
plot for [k = 1:2] '+' using (window_from[k]):(rows):(window_from[k]):(window_to[k]):(-0.6):(rows) every ::::0 \
    with boxxyerror fillcolor rgb '#d9d9d9' fillstyle solid noborder, \
  windows using 'from':'number':(column('from') - half_step):(column('to') + half_step): \
    (column('number') - 0.22):(column('number') + 0.22):ytic(1) \
    with boxxyerror lt 1 fillstyle solid noborder, \
  for [edge in 'from to'] windows using (column('number') == 1 ? column(edge) : NaN):(0.5):(0):(rows) \
    with vectors nohead lt 2 lw 0.7

unset label
set lmargin at screen 0.31; set tmargin at screen 0.33; set bmargin at screen 0.09
set label 1 '(b)' at screen 0.01, screen 0.315
set label 2 slanted('s_2').' of (a) and (c)' at 0.31, 0.12
set label 3 slanted('s_2').' of (b)' at 0.45, 0.12 center
set xlabel slanted('s_2')
set xrange [0:0.5]; set xtics 0.05
set yrange [-0.15:1.5]; set ytics 0.5 scale 0.6
set ylabel 'dual sticks a period'
array panel_name[3] = ['c', 'a', 'b']
array line[3] = [6, 1, 2]
array width[3] = [6, 2.5, 1.4]  # the lines lie upon each other
at_stop(name, s2) = abs(column('s2') - s2) < 1e-9 ? column(name) : NaN
plot '+' using (0.1):(1.5):(0.1):(0.3):(-0.15):(1.5) every ::::0 with boxxyerror fillcolor rgb '#d9d9d9' fillstyle solid noborder, \
  for [n = 1:3] dual using 's2':(column(panel_name[n])) with lines lt line[n] lw width[n] title 'Figure 5('.panel_name[n].')', \
  dual using 's2':(at_stop('a', 0.3)) with points pt 7 ps 1.5 lc rgb '#12355b', \
  '' using 's2':(at_stop('b', 0.45)) with points pt 7 ps 1.5 lc rgb '#c8442c', \
  '' using 's2':(at_stop('c', 0.3)) with points pt 6 ps 2.5 lc rgb '#6a4c93' lw 2
