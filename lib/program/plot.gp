# The pictures of the program, drawn from its tables to standard output. Called by it, or by hand:
#   gnuplot -c plot.gp terminal motion samples.csv events.csv lower upper >picture
#   gnuplot -c plot.gp terminal portrait samples.csv masses lines|points >picture
#   gnuplot -c plot.gp terminal diagram impacts.csv masses parameter points|branches >picture
#   gnuplot -c plot.gp terminal map table.csv parameter parameter column >picture
# where lower and upper are the positions of the stops of each mass, in words (NaN: no stop), a
# diagram has two more arguments, from and to, and a map the two widths of a point.
kind = ARG2
data = ARG3
masses = int(kind eq 'motion' ? words(ARG5) : kind eq 'map' ? 1 : real(ARG4))
tall = kind eq 'portrait' ? 640 : kind eq 'map' ? 900 : kind eq 'diagram' ? 470 : 370
height = 130 + tall * (masses < 32000 / tall ? masses : 32000 / tall)  # cairo takes 32767 pixels
if (ARG1 eq 'pdfcairo') {
  set terminal pdfcairo size 14in,(height / 100.0)in font 'Liberation Serif,22' linewidth 2
} else {
  set terminal @ARG1 size 1400,height font 'Liberation Serif,22' linewidth 2
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
style = ARG5 eq 'points' ? 'points linestyle 1 pointtype 7 pointsize 0.3' : 'lines linestyle 1'
# The key stands above the first panel.
key(k, name) = k == 1 ? name : ''

if (kind eq 'motion') {
  events = ARG4
  lower = ARG5
  upper = ARG6
  stats data using 1 nooutput
  set xrange [STATS_min:STATS_max]
  # A mass sticks where it stands exactly on its stop; it hits the one that it moves towards.
  position(stops, mass) = real(word(stops, mass))
  stuck(mass, x) = x == position(lower, mass) || x == position(upper, mass) ? x : NaN
  hit(mass, v) = position(v > 0 ? upper : lower, mass)
  impact(k, mass, event, v) = mass == k && event eq 'impact' ? hit(mass, v) : NaN
  set multiplot layout masses,1
  do for [k = 1:masses] {
    set ylabel sprintf('x_{%d}', k)
    if (k == masses) { set xlabel 'time' }
    plot position(lower, k) with lines linestyle 3 title key(k, 'stop'), \
         position(upper, k) with lines linestyle 3, \
         data using 1:(stuck(k, column(k + 1))) with lines linestyle 4 title key(k, 'sticking'), \
         data using 1:(column(k + 1)) with lines linestyle 1 title key(k, 'displacement'), \
         events using 1:(impact(k, int($2), strcol(3), $4)) \
           with points linestyle 2 title key(k, 'impact')
  }
  unset multiplot
}
if (kind eq 'portrait') {
  set offsets graph 0.03, graph 0.03, graph 0.03, graph 0.03
  set multiplot layout masses,1
  do for [k = 1:masses] {
    set xlabel sprintf('x_{%d}', k)
    set ylabel sprintf('v_{%d}', k)
    plot data using (column(k + 1)):(column(masses + k + 1)) with @style
  }
  unset multiplot
}
if (kind eq 'diagram') {
  # A branch was followed from ARG7 to ARG8, and perhaps back.
  parameter = ARG5
  followed = ARG6 eq 'branches'
  from = real(ARG7)
  to = real(ARG8)
  # Whether the parameter falls, from one row to the next.
  fell(x) = (falls = x < latest ? 1 : x > latest ? 0 : falls, latest = x, falls)
  velocity(k, x, mass, v, side) = fell(x) == side && mass == k ? v : NaN
  size(side) = side ? 1.2 : followed ? 0.5 : 0.2
  side_name(side) = !followed ? '' : side ? 'falling ' : 'rising '
  set xrange [(from < to ? from : to):(from < to ? to : from)]
  set multiplot layout masses,1
  do for [k = 1:masses] {
    set ylabel sprintf('impact velocity of mass %d', k)
    if (k == masses) { set xlabel parameter noenhanced }
    plot for [side = 0:1] falls = (from > to), latest = NaN, \
         data using 1:(velocity(k, $1, int($2), $3, side)) with points linestyle (side + 1) \
           pointtype (7 - side) pointsize size(side) title key(k, side_name(side))
  }
  unset multiplot
}
if (kind eq 'map') {
  set autoscale fix
  set xlabel ARG4 noenhanced
  set ylabel ARG5 noenhanced
  set title ARG6 noenhanced
  set offsets 0, 0, 0, 0
  set palette defined (0 '#f4f1ea', 1 '#8fb3cf', 2 '#12355b')
  set rmargin 12
  half(x, width) = x + 0.51 * real(width)  # the boxes overlap
  plot data using ARG4:ARG5:(half(column(ARG4), '-'.ARG7)):(half(column(ARG4), ARG7)): \
         (half(column(ARG5), '-'.ARG8)):(half(column(ARG5), ARG8)):ARG6 \
         with boxxyerror fillstyle solid noborder fillcolor palette
}
