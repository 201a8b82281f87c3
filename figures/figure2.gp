# Figure 2: displacement of both masses. Bars: a mass sticks.
load 'figures/style.gp'
set xlabel time
set ylabel 'Displacement'
set tmargin 2
set rmargin 5
eval key_beside_heading

eval scenes('figure2')
eval page('figure2', 2, 1)

eval panel('a')
eval scene(1, 'Ω')
eval axes('figure2a')
table = data.'/figure2a.csv'
plot s1[1] lt 3, s2[1] lt 3, \
  table using 't':(stuck(column('x1'), s1[1])) with lines lt 7 lw 6 title 'sticking', \
  '' using 't':(stuck(column('x2'), s2[1])) with lines lt 7 lw 6, \
  '' using 't':'x1' with lines lt 1 title 'mass 1', \
  '' using 't':'x2' with lines lt 2 title 'mass 2'

eval panel('b')
eval heading('close-up of (a): the chatter of mass 2,  '.known('Ω', omega[1], 'Ω').' (mass 1 is not drawn)')
unset label 2
eval axes('figure2b')
table = data.'/figure2b.csv'
plot s2[1] lt 3, table using 't':(stuck(column('x2'), s2[1])) with lines lt 7 lw 6, \
  '' using 't':'x2' with lines lt 2
