# The frequencies the paper's text does not give: what every value of four digits makes of the
# printed axis boxes, and the rule held against the figures whose parameters are printed.
load 'figures/style.gp'

scan(figure) = data.'/reconstruction_'.figure.'.csv'
axes = data.'/reconstruction_axes.csv'
band = '#e9f0ec'
# A frequency tried is drawn once in each of these classes that it is in.
array meaning[4] = ['tried', 'fills the printed axes', 'and does what the text says', 'chosen']
array colour[4] = ['#b9cfc4', '#3b7d5f', '#12355b', '#c8442c']
array mark[4] = [7, 7, 6, 7]
array size[4] = [0.6, 1.2, 2, 2]
is_in(class, value) = class == 1 || (class == 2 ? column('boxes') == 1 : class == 3 ? \
  column('boxes') == 1 && column('text') == 1 : column('chosen') == 1) ? value : NaN
stats axes using 'tick' nooutput name 'axes'
set datafile columnheaders
name_of(omega) = sprintf('{/*0.8 %.4f}', omega)

eval page('reconstruction', 4, 1)
set tmargin 4.5

eval panel('a')
set xlabel 'Ω of Figure 2'
set ylabel 'lowest {/:Italic x}_2 in 2(b)'
set xrange [0.1:0.5]; set xtics 0.05
set yrange [-0.25:0.2]; set ytics 0.05
set key at graph 1, graph 1.36 right top maxrows 3 samplen 1 spacing 1.05
set arrow 1 from 0.3, graph 0 to 0.3, graph 1 nohead lt 3
set label 2 "{/*0.75 the text:}\n{/*0.75 below 0.3}" at 0.303, 0.18 left
set object 1 rectangle from graph 0, first -0.06 to graph 1, first -0.04 fc rgb band fs solid noborder behind
plot for [k = 1:4] scan('2') using 'omega':(is_in(k, column('lowest_x2_in_b'))) \
    with points pt mark[k] ps size[k] lc rgb colour[k] title meaning[k], \
  '' using 'omega':(is_in(3, 0.105)):(name_of(column('omega'))) with labels rotate by 90 left, \
  '' using (column('omega') == 0.28 ? column('omega') : NaN):'lowest_x2_in_b' with points pt 2 ps 1.5 lc rgb '#202020' title '0.28'
unset arrow; unset label 2

set tmargin 1.5
eval panel('b')
set xlabel 'Ω of Figure 5(a)'
set ylabel 'lowest displacement'
set xrange [0.1:0.3]
set yrange [-0.45:0.2]; set ytics 0.1
unset key
set object 1 rectangle from graph 0, first -0.05 to graph 1, first 0 fc rgb band fs solid noborder behind
plot for [k = 1:4] scan('5a') using 'omega':(is_in(k, column('lowest'))) \
    with points pt mark[k] ps size[k] lc rgb colour[k], \
  '' using 'omega':(is_in(3, 0.02)):(name_of(column('omega'))) with labels rotate by 90 left

eval panel('c')
set xlabel 'time at which mass 2 of Figure 5(b) is nearest its stop, where it seems to touch it'
set ylabel 'lowest displacement'
set xrange [918:922]; set xtics 0.5
set yrange [-0.65:0]; set ytics 0.1
near(value) = column('gap') <= 0.0009 ? value : NaN
beside(value) = abs(column('nearest_time') - 920) < 0.8 && abs(column('lowest') + 0.35) < 0.2 ? near(value) : NaN
# These have a neighbour at their right.
crowded(omega) = abs(omega - 0.29965) < 1e-4 || abs(omega - 0.3064) < 5e-5
set object 1 rectangle from 919.5, -0.4 to 920.5, -0.3 fc rgb band fs solid noborder behind
plot for [k = 1:4] scan('5b') using 'nearest_time':(near(is_in(k, column('lowest')))) \
    with points pt mark[k] ps size[k] lc rgb colour[k], \
  '' using (column('nearest_time') - 0.04):(crowded(column('omega')) ? beside(column('lowest')) : NaN):(name_of(column('omega'))) with labels right, \
  '' using (column('nearest_time') + 0.04):(crowded(column('omega')) ? NaN : beside(column('lowest'))):(name_of(column('omega'))) with labels left

eval panel('d')
unset xlabel
set ylabel 'ticks from the end of the axis'
set xrange [-0.7:axes_records - 0.3]
set yrange [-0.45:4]; set ytics 1
set key at graph 0.6, graph 0.95 spacing 1.2
set xtics rotate by 30 right
named = "{/*0.85 %s}"
set object 1 rectangle from graph 0, first 0 to graph 1, first 1 fc rgb band fs solid noborder behind
plot axes using 0:'ticks_at_lowest':xtic(sprintf(named, strcol('panel').' '.strcol('quantity'))) with points pt 9 ps 1.6 lc rgb '#12355b' title 'lower end', \
  '' using 0:'ticks_at_highest' with points pt 11 ps 1.6 lc rgb '#c8442c' title 'upper end', \
  '' using 0:(-0.22):(sprintf('{/*0.65 %s}', strcol('kind'))) with labels
set xtics norotate
unset object
