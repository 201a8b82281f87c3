# The atlas of settled motions from rest, in the plane of frequency and restitution: their period in
# forcing periods (a); which masses stick, and the borders of the regions in which a mass sticks (b).
load 'figures/style.gp'

# Light to dark, so that a grey print has the same order.
array colour[10] = ['#f0f0f0', '#f0e442', '#56b4e9', '#e69f00', '#009e73', '#505050', \
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
  eval key_beside_heading
  set key samplen 0.7 maxrows 2 at graph 1, graph (part == 1 ? 1.22 : 1.125)
  plot data.'/atlas.csv' using 'omega':'restitution':(class(part)) with image notitle, \
    for [mass = 1:2] data.'/atlas_borders.csv' using (of_mass(mass, column('omega'))):'restitution' \
      with points pt 7 ps (part == 2 ? 0.3 : 0) lt mass notitle, \
    for [c = first(part):last(part)] NaN with points pt 5 ps 2.4 lc rgb colour[c] title meaning[c]
}
