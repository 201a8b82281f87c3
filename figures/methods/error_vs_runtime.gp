# Error against run time and against work, for this library and what one would otherwise pick. A cross
# at the upper edge is a run that failed; the table says where and why. Bars: fastest and slowest
# repeat. An error below 1e-15, the rounding of small times, is drawn at 1e-15.
load 'figures/style.gp'
table = data.'/error_vs_runtime.csv'
problems = 'figure2 figure4 flight chatter sticking'
titles = '"ten periods of Figure 2" "ten periods of Figure 4(a)" "one flight" "one chatter sequence" "one sticking phase"'

# Name in the table, colour (of that line type, one a family) and point type.
methods = '"this library" "this library (every impact)" "plain event-driven" "odeint runge_kutta_dopri5" "odeint runge_kutta_fehlberg78" "CVODE Adams" "Siconos Moreau-Jean" "stiff spring (dopri5)"'
colours = '1 1 3 2 2 5 6 3'
points = '7 6 3 5 9 4 8 12'
missing = system("for family in CVODE Siconos; do grep -q $family '".table."' || echo $family; done")

floor = 1e-15
top = 10.0
drawn(error) = error < floor ? floor : error
of(p, m) = strcol("problem") eq p && strcol("method") eq m
good(p, m) = of(p, m) && strlen(strcol("failure")) == 0 ? drawn(column('error_time')) : NaN
bad(p, m) = of(p, m) && strlen(strcol("failure")) > 0 ? top : NaN

set tmargin 2.2
set logscale xy
set format '10^{%T}'
set yrange [0.5 * floor:2 * top]
set ytics 1e3
set mytics 1
set xtics 10
set grid xtics ytics linetype 4 linewidth 0.2
set ylabel 'error of event times'
array name[words(methods)]
do for [k = 1:words(methods)] { name[k] = word(methods, k) }

rows = words(problems)
height = 0.92 / rows  # of a panel; the key has the rest
font = "font 'Liberation Serif,20'"
eval opened('error_vs_runtime', 1700, 2500)
set multiplot
set size 0.5, height
do for [n = 1:rows] {
  p = word(problems, n)
  set label 1 word(titles, n) at graph 0.0, graph 1.06
  do for [x in 'median_us_per_period rhs_or_expansions'] {
    timed = x eq 'median_us_per_period'
    set origin timed ? 0.0 : 0.5, 1.0 - height * n
    set xlabel timed ? 'microseconds of processor time / length of the run in periods' : 'work (evaluations, steps or expansions)'
    plot for [k = 1:words(methods)] table using x:(good(p, name[k])) with linespoints \
        linecolor int(word(colours, k)) pointtype int(word(points, k)) pointsize 0.9 linewidth 1.2 dashtype solid, \
      for [k = 1:words(methods)] table using x:(timed ? good(p, name[k]) : NaN):'low':'high' with xerrorbars \
        linecolor int(word(colours, k)) pointtype 0 linewidth 0.8 dashtype solid, \
      for [k = 1:words(methods)] table using x:(bad(p, name[k])) with points \
        linecolor int(word(colours, k)) pointtype 2 pointsize 1.2
  }
}
# The key has a panel of its own.
unset label 1; unset xlabel; unset ylabel; unset tics; unset border; unset grid
set key center center maxrows 5 spacing 1.2 samplen 2
set tmargin 0; set bmargin 0
set origin 0.0, 0.0
set size 1.0, 0.08
if (strlen(missing) > 0) { set label 2 "not installed (make peers):\n".missing at screen 0.005, 0.052 left textcolor linetype 2 noenhanced }
plot for [k = 1:words(methods)] NaN with linespoints \
    linecolor int(word(colours, k)) pointtype int(word(points, k)) pointsize 0.9 linewidth 1.2 dashtype solid \
    title (strstrt(missing, word(name[k], 1)) > 0 ? '' : name[k]) noenhanced, \
  NaN with points linetype 3 pointtype 2 pointsize 1.2 title 'failed (at the upper edge)'
unset multiplot
unset output
