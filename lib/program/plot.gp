# The picture of a run, to standard output. The program sends, before this file, below a row of NaN:
#   $stop           mass, position
#   $impact         time, mass, position
#   $displacement   time, and of every mass drawn its displacement, and that again where it sticks
# and
#   masses, layers  the masses drawn and what there is to be drawn, in words
#   from, to, kind  the times between which they are drawn, and the terminal
rows = words(masses)
height = 130 + 370 * rows
if (kind eq 'pdfcairo') {
  set terminal pdfcairo size 14in,(height / 100.0)in font 'Liberation Serif,22' linewidth 2
} else {
  set terminal @kind size 1400,height font 'Liberation Serif,22' linewidth 2
}
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
key(k, layer) = k == 1 && strstrt(layers, layer) ? layer : ''
do for [k = 1:rows] {
  of(mass, x) = mass == int(word(masses, k)) ? x : NaN
  set ylabel 'x_{'.word(masses, k).'}'
  if (k == rows) { set xlabel 'time' }
  plot $stop using (from):(of($1, $2)):(to - from):(0) with vectors nohead linestyle 3, \
       $displacement using 1:(column(2 * k + 1)) with lines linestyle 4, \
       $displacement using 1:(column(2 * k)) with lines linestyle 1, \
       $impact using 1:(of($2, $3)) with points linestyle 2, \
       NaN with lines linestyle 3 title key(k, 'stop'), \
       NaN with lines linestyle 4 title key(k, 'sticking'), \
       NaN with lines linestyle 1 title key(k, 'displacement'), \
       NaN with points linestyle 2 title key(k, 'impact')
}
unset multiplot
