# The picture of a run, drawn from its tables to standard output. Called by the program, or by hand:
#   gnuplot -c plot.gp terminal samples.csv events.csv lower upper >picture
# where lower and upper are the positions of the stops of each mass, in words; NaN: no stop.
kind = ARG1
samples = ARG2
events = ARG3
lower = ARG4
upper = ARG5
rows = words(lower)
height = 130 + 370 * (rows < 80 ? rows : 80)  # in pixels, of which cairo takes 32767
if (kind eq 'pdfcairo') {
  set terminal pdfcairo size 14in,(height / 100.0)in font 'Liberation Serif,22' linewidth 2
} else {
  set terminal @kind size 1400,height font 'Liberation Serif,22' linewidth 2
}
set datafile separator ','
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
stats samples using 1 nooutput
set xrange [STATS_min:STATS_max]
# A mass sticks where it stands exactly on its stop; it hits the one that it moves towards.
position(stops, mass) = real(word(stops, mass))
stuck(mass, x) = x == position(lower, mass) || x == position(upper, mass) ? x : NaN
hit(mass, v) = position(v > 0 ? upper : lower, mass)
impact(k, mass, event, v) = mass == k && event eq 'impact' ? hit(mass, v) : NaN
# The key stands above the first panel.
key(k, name) = k == 1 ? name : ''
set multiplot layout rows,1
do for [k = 1:rows] {
  set ylabel sprintf('x_{%d}', k)
  if (k == rows) { set xlabel 'time' }
  plot position(lower, k) with lines linestyle 3 title key(k, 'stop'), \
       position(upper, k) with lines linestyle 3, \
       samples using 1:(stuck(k, column(k + 1))) with lines linestyle 4 title key(k, 'sticking'), \
       samples using 1:(column(k + 1)) with lines linestyle 1 title key(k, 'displacement'), \
       events using 1:(impact(k, int($2), strcol(3), $4)) \
         with points linestyle 2 title key(k, 'impact')
}
unset multiplot
