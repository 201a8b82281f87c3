# Stability: error of the event times of every extreme case, in units of the rounding of a double. A
# case passes left of its limit: 1e-10, or 100 roundings times the sensitivity to the start. A touch has
# no limit here: a rounding of the stop shifts it by the root of that rounding.
load 'figures/style.gp'

table = data.'/stability.csv'
epsilon = 2.220446049250313e-16
stats table using (column('events')) nooutput
cases = int(STATS_records)

# Rows from the top; what is below 0.1 is drawn at 0.1, and the axis says so; opens() is true at the
# first case of a group.
row(n) = -n
shown(x) = x < 0.1 ? 0.1 : x
limit(sensitivity) = 100 * sensitivity > 1e-10 / epsilon ? 100 * sensitivity : 1e-10 / epsilon
opens(group) = group eq last ? 0 : (last = group, 1)
last = ''

eval canvas('stability', 0.042 * cases)
set lmargin at screen 0.31
set rmargin at screen 0.84
set tmargin at screen 0.937
set bmargin at screen 0.042
set yrange [-cases + 0.3 : 0.7]
set ytics scale 0 font ',18'
set logscale x
set xrange [0.05:4e9]
set xtics ('≤ 0.1' 0.1, '10^2' 1e2, '10^4' 1e4, '10^6' 1e6, '10^8' 1e8)
set grid x linetype 4
set xlabel 'error of event times / 2.2 × 10^{−16}'
set key autotitle columnhead maxrows 1 samplen 1 at screen 0.84, screen 0.955
set label 1 "Extreme cases: error of the event times. Sensitivity: the largest shift of an event\nby one rounding of the start. A case passes left of its limit." at screen 0.02, screen 0.987
plot table using (0.05):(opens(strcol('group')) ? row($0) + 0.5 : NaN):(4e9):(0) with vectors nohead linetype 4 notitle, \
  '' using (4e9):(opens(strcol('group')) ? row($0) : NaN):(strcol('group')) with labels left offset 1, 0 notitle, \
  '' using (strcol('truth') eq 'grazing' ? NaN : limit(column('time_sensitivity'))):(row($0) - 0.35):(0):(0.7) \
    with vectors nohead linewidth 1.4 dashtype solid linecolor rgb '#404040' title 'limit', \
  '' using (shown(column('time_sensitivity'))):(strcol('truth') eq 'grazing' ? NaN : row($0)) \
    with points pointtype 6 pointsize 1.1 linewidth 0.6 linecolor rgb '#808080' title 'sensitivity', \
  '' using (shown(column('time_error') / epsilon)):(row($0)):ytic(strcol('case')) \
    with points pointtype 7 pointsize 1 linetype 1 title 'error', \
  '' using (strcol('verdict') eq 'pass' ? NaN : shown(column('time_error') / epsilon)):(row($0)) \
    with points pointtype 2 pointsize 2 linetype 2 notitle  # a failed case is crossed out
unset output
