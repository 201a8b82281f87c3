# The atlas of settled motions from rest, in the plane of frequency and restitution: their period in
# forcing periods (a); which masses stick, and the borders of the regions in which a mass sticks (b).
# The line and the bars on it: Figure 3, and where the paper finds the chatter of mass 1 incomplete.
load 'figures/style.gp'

array colour[10] = ['#8c97a8', '#f0e442', '#1f78b4', '#e06000', '#009e73', '#f4f4f4', \
  '#f0f0f0', '#9db6d3', '#eeb3a5', '#6a4c93']
array meaning[10] = ['period 1', 'period 2', 'period 3', 'period 4', 'periods 5 to 8', 'none found', \
  'no mass', 'mass 1', 'mass 2', 'both masses']
colours = ''
do for [c = 1:10] { colours = colours.sprintf("%s %d '%s'", c > 1 ? ',' : '', c, colour[c]) }
eval 'set palette defined ('.colours.') maxcolors 10'
set cbrange [0.5:10.5]
unset colorbox
class(part) = part == 1 ? (column('period') == 0 ? 6 : column('period') > 4 ? 5 : column('period')) : \
  7 + (column('sticks1') > 0) + 2 * (column('sticks2') > 0)
first(part) = part == 1 ? 1 : 7
last(part) = part == 1 ? 6 : 10
of_mass(mass, value) = column('mass') == mass ? value : NaN

eval page('atlas', 2, 1)
set xlabel 'Ω'; set xtics 0.1
set ylabel '{/:Italic r}'; set ytics 0.2
set xrange [0.2:0.8]; set yrange [0:0.98]
set tmargin 4
do for [part = 1:2] {
  eval panel('ab'[part:part])
  eval heading(part == 1 ? 'Period of the motion from rest' : 'Which masses stick in it')
  set label 2 part == 1 ? 'line: Figure 3' : "line: Figure 3;  thick: there the paper finds\nthe chatter of mass 1 incomplete" \
    at 0.22, 0.3 tc rgb (part == 1 ? '#000000' : '#ffffff') front
  eval key_beside_heading
  set key samplen 0.7 maxrows 2 at graph 1, graph (part == 1 ? 1.22 : 1.125)
  plot data.'/atlas.csv' using 'omega':'restitution':(class(part)) with @image notitle, \
    for [mass = 1:2] data.'/atlas_borders.csv' using (of_mass(mass, column('omega'))):'restitution' \
      with points pt 7 ps (part == 2 ? 0.3 : 0) lt mass notitle, \
    '+' using (0.25):(0.7):(0.45):(0) every ::::0 with vectors nohead lc rgb '#000000' lw 0.8 dt solid notitle, \
    for [k = 1:2] '+' using (part == 2 ? window_from[k] : NaN):(0.7):(window_to[k] - window_from[k]):(0) every ::::0 \
      with vectors nohead lc rgb '#000000' lw 3.5 dt solid notitle, \
    for [c = first(part):last(part)] NaN with points pt 5 ps 2.4 lc rgb colour[c] title meaning[c]
}
