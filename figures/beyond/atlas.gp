# The atlas of settled motions from rest, in the plane of frequency and restitution: their period
# (a); who sticks, and the borders of the regions in which a mass sticks (b).
load 'figures/style.gp'

# The colours of Okabe and Ito, which the colour-blind tell apart, and greys.
array colour[10] = ['#e6e6e6', '#56b4e9', '#009e73', '#f0e442', '#e69f00', '#8c8c8c', \
  '#e6e6e6', '#e69f00', '#56b4e9', '#009e73']
array meaning[10] = ['period 1', '2', '3', '4', '5 to 8', 'none within 200', \
  'no mass sticks', 'mass 1', 'mass 2', 'both in turn']
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
set ylabel '{/:Italic r}'
set xrange [0.2:0.8]; set yrange [0:0.98]
set key above left samplen 1 maxrows 2
set tmargin 4
do for [part = 1:2] {
  eval panel('ab'[part:part])
  size = part == 2 ? 0.25 : 0
  plot data.'/atlas.csv' using 'omega':'restitution':(class(part)) with image notitle, \
    for [mass = 1:2] data.'/atlas_borders.csv' using (of_mass(mass, column('omega'))):'restitution' with points pt 7 ps size lt mass notitle, \
    for [c = first(part):last(part)] NaN with points pt 5 ps 2.4 lc rgb colour[c] title meaning[c]
}
