# The picture of a run. The program sends, before it loads this file:
#   $stop, $sticking, $displacement, $impact   a part (index) for each mass
#   masses, shown   the masses drawn, and the layers that any of them has, in words
#   from, to        the times between which the run is drawn
#   kind, file      the terminal, and where the picture goes
rows = words(masses)
height = 130 + 370 * rows
if (kind eq 'pdfcairo') {
  set terminal pdfcairo size 14in,(height / 100.0)in font 'Liberation Serif,22' linewidth 2
} else {
  set terminal @kind size 1400,height font 'Liberation Serif,22' linewidth 2
}
set output file
set encoding utf8
set border linewidth 0.7 linecolor rgb '#202020'
set tics nomirror out scale 0.6
set key outside top right horizontal reverse Left samplen 2.5 noautotitle
set style line 1 linecolor rgb '#12355b' linewidth 1.0
set style line 2 linecolor rgb '#c8442c' linewidth 0.7 pointtype 6 pointsize 0.7
set style line 3 linecolor rgb '#404040' linewidth 0.6 dashtype (4, 5)
set style line 4 linecolor rgb '#e0a030' linewidth 4
set lmargin 11
set rmargin 3
set offsets 0, 0, graph 0.06, graph 0.06
set xrange [from:to]
set multiplot layout rows,1
# What any panel shows stands in the key above the first.
key(k, layer) = k == 0 && strstrt(shown, layer) ? layer : ''
do for [k = 0:rows - 1] {
  set ylabel 'x_{'.word(masses, k + 1).'}'
  if (k == rows - 1) { set xlabel 'time' }
  plot $stop index k using (from):2:(to - from):(0) with vectors nohead linestyle 3, \
       $sticking index k with lines linestyle 4, \
       $displacement index k with lines linestyle 1, \
       $impact index k with points linestyle 2, \
       NaN with lines linestyle 3 title key(k, 'stop'), \
       NaN with lines linestyle 4 title key(k, 'sticking'), \
       NaN with lines linestyle 1 title key(k, 'displacement'), \
       NaN with points linestyle 2 title key(k, 'impact')
}
unset multiplot
set output
