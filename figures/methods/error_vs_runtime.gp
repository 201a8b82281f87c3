# Error against run time and against work: this library beside what one would otherwise pick. A
# cross at the upper edge is a run that failed; the table says where and why. Bars: fastest and
# slowest repeat. An error below 1e-15, the rounding of small times, is drawn at 1e-15.
load 'figures/style.gp'
table = data.'/error_vs_runtime.csv'
problems = 'figure2 figure4 flight chatter sticking'
titles = '"ten periods of Figure 2" "ten periods of Figure 4(a)" "one flight" "one chatter sequence" "one sticking phase"'

# Who could not take part.
missing = system("sed -n 's/^missing,\"\\(.*\\)\"$/\\1/p' '".data."/error_vs_runtime_conditions.csv'")

# Name in the table, point type, colour.
methods = '"this library" "this library (every impact)" "plain event-driven" "odeint runge_kutta_dopri5" "odeint runge_kutta_fehlberg78" "odeint bulirsch_stoer_dense_out" "odeint rosenbrock4" "CVODE Adams" "CVODE BDF" "Siconos Moreau-Jean" "Siconos LsodarOSI" "stiff spring (dopri5)"'
colours = '#12355b #56b4e9 #404040 #c8442c #e08a3c #b0305c #d9a0a0 #2a7f4f #7fb069 #6a4c93 #b39ddb #8d6e63'
points = '7 6 2 5 9 11 13 4 8 10 12 1'

floor = 1e-15
top = 10.0
drawn(error) = error < floor ? floor : error

set tmargin 2.2
set logscale xy
set format '10^{%T}'
set yrange [0.5 * floor:2 * top]
set ytics 1e3
set mytics 1
set xtics 10
set grid xtics ytics linecolor rgb '#e0e0e0' linewidth 0.6 dashtype solid

here(p, m) = strcol("problem") eq p && strcol("method") eq m
good(p, m, x, y) = here(p, m) && strlen(strcol("failure")) == 0 ? drawn(y) : NaN
bad(p, m) = here(p, m) && strlen(strcol("failure")) > 0 ? top : NaN

rows = words(problems)
height = 0.92 / rows  # of a panel; the key has the rest
font = "font 'Liberation Serif,20'"
eval opened('error_vs_runtime', 1700, 2500)
set multiplot
do for [n = 1:rows] {
  p = word(problems, n)
  do for [column in 'median_us_per_period rhs_or_expansions'] {
    set origin column eq 'rhs_or_expansions' ? 0.5 : 0.0, 1.0 - height * n
    set size 0.5, height
    set xlabel column eq 'rhs_or_expansions' ? 'work (evaluations, steps or expansions)' : 'microseconds of processor time / length of the run in periods'
    set ylabel 'error of event times'
    set label 1 word(titles, n) at graph 0.0, graph 1.06
    unset key
    plot for [k = 1:words(methods)] table \
        using (column(column)):(good(p, word(methods, k), column(column), column('error_time'))) \
        with linespoints pointtype int(word(points, k)) pointsize 0.9 linewidth 1.2 \
        dashtype solid linecolor rgb word(colours, k), \
      for [k = 1:words(methods)] table \
        using (column(column)):(good(p, word(methods, k), 0, column('error_time'))): \
          (column(column eq 'rhs_or_expansions' ? column : 'low')): \
          (column(column eq 'rhs_or_expansions' ? column : 'high')) \
        with xerrorbars pointtype 0 linewidth 0.8 dashtype solid linecolor rgb word(colours, k), \
      for [k = 1:words(methods)] table \
        using (column(column)):(bad(p, word(methods, k))) \
        with points pointtype 2 pointsize 1.2 linecolor rgb word(colours, k)
  }
}
# The key has a panel of its own.
unset label 1; unset xlabel; unset ylabel; unset tics; unset border; unset grid
set key center center maxrows 5 spacing 1.2 samplen 2
set tmargin 0; set bmargin 0
set origin 0.0, 0.0
set size 1.0, 0.08
if (strlen(missing) > 0) { set label 2 "not installed (make peers):\n".missing at screen 0.005, 0.052 left font 'Liberation Serif,17' textcolor rgb '#c8442c' noenhanced }
plot for [k = 1:words(methods)] NaN with linespoints pointtype int(word(points, k)) \
    pointsize 0.9 linewidth 1.2 dashtype solid linecolor rgb word(colours, k) \
    title (strstrt(missing, word(word(methods, k), 1)) > 0 ? '' : word(methods, k)) noenhanced, \
  NaN with points pointtype 2 pointsize 1.2 linecolor rgb '#202020' title 'failed (at the upper edge)'
unset multiplot
unset output
