# The pictures of the program, drawn from its tables to standard output. Called by it, or by hand:
#   gnuplot -c plot.gp terminal motion panels samples.csv events.csv lower upper >picture
#   gnuplot -c plot.gp terminal portrait panels curves.csv lines|points lower upper >picture
#   gnuplot -c plot.gp terminal diagram panels impacts.csv points|branches axis >picture
#   gnuplot -c plot.gp terminal columns columns table.csv points|branches axis >picture
#   gnuplot -c plot.gp terminal branch columns table.csv diagram.csv parameter masses >picture
#   gnuplot -c plot.gp terminal map column map.csv axis axis classes >picture
# where curves have a block x,v for each mass, with both ends of each jump of v; a map has the two parameters of
# a point and its value, or the word of its class, if there are classes; panels are the masses that are drawn, in words; lower and upper are the positions of the
# stops of each mass, in words (NaN: no stop). An axis is a parameter, the two ends of its range, half
# the distance of its points (or the root of their ratio) with an overlap, and linear or logarithmic.
kind = ARG2
data = ARG4
panels = kind eq 'map' ? 1 : words(ARG3)
tall = kind eq 'portrait' ? 640 : kind eq 'map' ? 900 : kind eq 'motion' ? 370 : 470
height = 130 + tall * (panels < 32000 / tall ? panels : 32000 / tall)  # cairo takes 32767 pixels
first = word(ARG3, 1)  # of the panels; the key stands above it
last = word(ARG3, panels)
if (ARG1 eq 'pdfcairo') {
  set terminal pdfcairo size 14in,(height / 100.0)in font 'Liberation Serif,22' linewidth 2
} else {
  set terminal @ARG1 size 1400,height font 'Liberation Serif,22' linewidth 2
}
set encoding utf8
set minussign
set datafile separator ','
set border linewidth 0.7 linecolor rgb '#202020'
set tics nomirror out scale 0.6
set key outside top right horizontal reverse Left samplen 2.5 noautotitle
set style line 1 linecolor rgb '#12355b' linewidth 1.0
set style line 2 linecolor rgb '#c8442c' linewidth 0.7 pointtype 6 pointsize 0.7
set style line 3 linecolor rgb '#404040' linewidth 0.6 dashtype (4, 5)
set style line 4 linecolor rgb '#e0a030' linewidth 4
set style line 5 linecolor rgb '#b8b8b8' linewidth 4
set lmargin 11
set rmargin 3
set offsets 0, 0, graph 0.06, graph 0.06
style = ARG5 eq 'points' ? 'points linestyle 1 pointtype 7 pointsize 0.3' : 'lines linestyle 1'
key(panel, name) = panel eq first ? name : ''
# A parameter or a column as it stands at an axis.
begins(name, word) = name[1:strlen(word)] eq word && name[strlen(word) + 1:*] ne ''
number(name, word) = name[strlen(word) + 1:*]
of_mass(name, word) = ' of mass '.number(name, word).' a period'
plain(name) = strstrt(name, '_') ? plain(name[1:strstrt(name, '_') - 1].' '.name[strstrt(name, '_') + 1:*]) : name
label(name) = name eq 'omega' ? 'Ω' : name eq 'beta' ? 'β' : name eq 'restitution' ? 'r' : \
  begins(name, 'displacement') ? 'initial x_{'.number(name, 'displacement').'}' : \
  begins(name, 'velocity') ? 'initial v_{'.number(name, 'velocity').'}' : \
  begins(name, 'stop') ? 's_{'.number(name, 'stop').'}' : \
  begins(name, 'amplitude') ? 'A_{'.number(name, 'amplitude').'}' : \
  begins(name, 'lowest') ? 'smallest x_{'.number(name, 'lowest').'}' : \
  begins(name, 'highest') ? 'largest x_{'.number(name, 'highest').'}' : \
  begins(name, 'rms') ? 'root mean square of x_{'.number(name, 'rms').'}' : \
  begins(name, 'impacts') ? 'impacts'.of_mass(name, 'impacts') : \
  begins(name, 'sticks') ? 'sticking phases'.of_mass(name, 'sticks') : \
  strlen(name) < 4 && name[1:1] eq 'x' ? 'x_{'.name[2:*].'}' : plain(name)
# The range of an axis, with half a distance at each end, and the ends of the box of a point.
from(axis) = real(word(axis, 2))
to(axis) = real(word(axis, 3))
half(axis) = real(word(axis, 4))
is_log(axis) = word(axis, 5) eq 'logarithmic'
before(x, axis) = is_log(axis) ? x / half(axis) : x - half(axis)
behind(x, axis) = is_log(axis) ? x * half(axis) : x + half(axis)
lower_end(axis) = before(from(axis) < to(axis) ? from(axis) : to(axis), axis)
base(axis) = abs(log10(to(axis) / from(axis))) < 2 ? 2 : 10  # of the labels, two or more
upper_end(axis) = behind(from(axis) < to(axis) ? to(axis) : from(axis), axis)
box = '(before($1, ARG5)):(behind($1, ARG5)):(before($2, ARG6)):(behind($2, ARG6))'

if (kind eq 'motion') {
  events = ARG5
  lower = ARG6
  upper = ARG7
  stats data using 1 nooutput
  set xrange [STATS_min:STATS_max]
  # A mass sticks where it stands exactly on its stop; it hits the one that it moves towards.
  position(stops, mass) = real(word(stops, mass))
  stuck(mass, x) = x == position(lower, mass) || x == position(upper, mass) ? x : NaN
  hit(mass, v) = position(v > 0 ? upper : lower, mass)
  impact(k, mass, event, v) = mass == k && event eq 'impact' ? hit(mass, v) : NaN
  set multiplot layout panels,1
  do for [panel in ARG3] {
    k = int(panel)
    set ylabel sprintf('x_{%d}', k)
    if (panel eq last) { set xlabel 'time' }
    plot position(lower, k) with lines linestyle 3 title key(panel, 'stop'), \
         position(upper, k) with lines linestyle 3, \
         data using 1:(stuck(k, column(k + 1))) with lines linestyle 4 title key(panel, 'sticking'), \
         data using 1:(column(k + 1)) with lines linestyle 1 title key(panel, 'displacement'), \
         events using 1:(impact(k, int($2), strcol(3), $4)) \
           with points linestyle 2 title key(panel, 'impact')
  }
  unset multiplot
}
if (kind eq 'portrait') {
  is_curve = ARG5 eq 'lines'  # not a section, from which stops may be far away
  position(stops, mass) = is_curve ? real(word(stops, mass)) : NaN
  # A mass sticks where it stands exactly on its stop.
  stuck(mass, x, v) = v == 0 && (x == position(ARG6, mass) || x == position(ARG7, mass)) ? x : NaN
  ends(row) = row == 0 ? STATS_min : row == 1 ? STATS_max : NaN
  name(panel, of_curve) = is_curve ? key(panel, of_curve) : ''
  set offsets graph 0.03, graph 0.03, graph 0.03, graph 0.03
  set multiplot layout panels,1
  do for [panel in ARG3] {
    k = int(panel)
    set xlabel sprintf('x_{%d}', k)
    set ylabel sprintf('v_{%d}', k)
    stats data index k-1 using 2 nooutput
    plot data index k-1 using (position(ARG6, k)):(ends($0)) with lines linestyle 5 title name(panel, 'stop'), \
         data index k-1 using (position(ARG7, k)):(ends($0)) with lines linestyle 5, \
         data index k-1 using 1:2 with @style title name(panel, 'motion'), \
         data index k-1 using (stuck(k, $1, $2)):2 with points pointtype 7 pointsize 1.2 \
           linecolor rgb '#e0a030' title name(panel, 'sticking')
  }
  unset multiplot
}
if (kind eq 'branch') {
  # Special points belong to the lines on both sides of them.
  special(name) = strstrt('|orbit|coincidence|closed|end of range|', '|'.name.'|') == 0
  # The names of special points stand above and below them in turn.
  side_of(kind) = special(kind) ? (found = found + 1, found % 2) : 2
  on_side(side, y) = special(strcol('kind')) || (strcol('stability') eq 'stable') == side ? y : NaN
  set multiplot layout panels,1
  do for [panel in ARG3] {
    impacts = begins(panel, 'fastest')  # which a diagram has in rows of all masses
    set ylabel (impacts ? 'impact velocity of mass '.number(panel, 'fastest') : label(panel))
    if (panel eq last) { set xlabel label(ARG6) }
    of_diagram(x) = !impacts ? column(panel) : column(2) == int(number(panel, 'fastest')) ? column(3) : NaN
    plot ARG5 using 1:(of_diagram(0)) with points pointtype 7 pointsize 0.25 linecolor rgb '#b0b0b0' \
           title (ARG5 eq '/dev/null' ? '' : key(panel, 'diagram')), \
         data using 1:(on_side(1, column(panel))) with lines linestyle 1 linewidth 1.6 title key(panel, 'stable'), \
         data using 1:(on_side(0, column(panel))) with lines linestyle 1 linewidth 1.6 dashtype (8, 6) \
           title key(panel, 'unstable'), \
         data using 1:(special(strcol('kind')) ? column(panel) : NaN) with points linestyle 2 pointtype 7, \
         for [side=0:1] found = 0, \
         data using 1:(side_of(strcol('kind')) == side ? column(panel) : NaN):(strcol('kind')) with labels \
           noenhanced left offset 0.6, (side ? 0.7 : -0.7) textcolor rgb '#c8442c' font ',18'
  }
  unset multiplot
}
if (kind eq 'diagram' || kind eq 'columns') {
  # A branch was followed from one end to the other, and perhaps back.
  followed = ARG5 eq 'branches'
  # Whether the parameter falls, from one row to the next.
  fell(x) = (falls = x < latest ? 1 : x > latest ? 0 : falls, latest = x, falls)
  of_panel(panel) = kind eq 'columns' ? column(panel) : column(2) == int(panel) ? column(3) : NaN
  height(panel, side) = fell(column(1)) == side ? of_panel(panel) : NaN
  size(side) = side ? 1.2 : followed ? 0.5 : kind eq 'columns' ? 0.35 : 0.2
  side_name(side) = !followed ? '' : side ? 'falling ' : 'rising '
  side = 0  # gnuplot 6 evaluates the title after the iteration where there are no points
  if (is_log(ARG6)) { set logscale x base(ARG6) }
  set xrange [lower_end(ARG6):upper_end(ARG6)]
  set multiplot layout panels,1
  do for [panel in ARG3] {
    set ylabel (kind eq 'columns' ? label(panel) : 'impact velocity of mass '.panel)
    if (panel eq last) { set xlabel label(word(ARG6, 1)) }
    # Without points there is no range, and `stats` leaves no records.
    stats data using (of_panel(panel)) nooutput
    found = exists('STATS_records') ? STATS_records : 0
    plot (found > 0 ? NaN : 0) with lines linestyle 3, \
         for [side = 0:1] falls = (from(ARG6) > to(ARG6)), latest = NaN, \
         data using 1:(height(panel, side)) with points linestyle (side + 1) \
           pointtype (7 - side) pointsize size(side) title key(panel, side_name(side))
  }
  unset multiplot
}
if (kind eq 'map') {
  across = word(ARG5, 1)
  up = word(ARG6, 1)
  set xlabel label(across)
  set ylabel label(up)
  set title label(ARG3)
  set offsets 0, 0, 0, 0
  if (is_log(ARG5)) { set logscale x base(ARG5) }
  if (is_log(ARG6)) { set logscale y base(ARG6) }
  set xrange [lower_end(ARG5):upper_end(ARG5)]
  set yrange [lower_end(ARG6):upper_end(ARG6)]
  classes = words(ARG7)
  if (classes == 0) {
    set palette defined (0 '#f4f1ea', 1 '#8fb3cf', 2 '#12355b')
    set rmargin 12
    plot data using 1:2:@box:3 with boxxyerror fillstyle solid noborder fillcolor palette
  } else {
    # Classes of numbers have colours in turn, and the others have their own.
    colours = '#4477aa #ee6677 #228833 #ccbb44 #66ccee #aa3377 #ee7733 #332288 #44aa99 #999933 #882255 #ddcc77'
    names = "other 'none found' irregular refused 'given up'"
    own = '#8a7f70 #c8c8c8 #202020 #ffffff #f0c8dc'
    place(name) = sum [i=1:words(names)] (word(names, i) eq name ? i : 0)
    colour(c) = place(word(ARG7, c)) > 0 ? word(own, place(word(ARG7, c))) : word(colours, c)
    class_of(name) = sum [i=1:classes] (word(ARG7, i) eq name ? i : 0)
    other = class_of('other')
    # What stands in no class is in the class of the others.
    in_class(c, name) = class_of(name) == c || (c == other && class_of(name) == 0)
    set key outside right top vertical width 1 samplen 1
    set rmargin 16
    plot for [c=1:classes] data using (in_class(c, strcol(3)) ? $1 : NaN):2:@box \
           with boxxyerror fillcolor rgb colour(c) fillstyle solid border linecolor rgb colour(c) linewidth 0.3, \
         for [c=1:classes] NaN with boxes fillstyle solid border linecolor rgb '#202020' \
           fillcolor rgb colour(c) title word(ARG7, c)
  }
}
