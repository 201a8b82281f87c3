# Stability: errors of the event times of the extreme cases, in units of the rounding of a double, by
# families. A case passes left of 1e-10, or of 100 roundings times its sensitivity to the start. A touch
# has no limit here: a rounding of the stop shifts it by the root of that rounding.
load 'figures/style.gp'

table = data.'/stability.csv'
epsilon = 2.220446049250313e-16
shown(x) = x < 0.1 ? 0.1 : x  # what is below 0.1 is drawn at 0.1, and the axis says so

# The families in their order, and of each the number of its cases, its range and its worst case.
families = 0
array family[99]
array cases[99]
array best[99]
array worst[99]
array name_of_worst[99]
begin(group) = (families = families + 1, family[families] = group, cases[families] = 0, best[families] = 1e99, \
                worst[families] = -1)
add(error, name) = (cases[families] = cases[families] + 1, \
                    best[families] = error < best[families] ? error : best[families], \
                    error > worst[families] ? (worst[families] = error, name_of_worst[families] = name) : 0, 1)
is_new(group) = families == 0 || family[families] ne group
row_of(group) = (is_new(group) ? begin(group) : 0, -families)
stats table using (row_of(strcol('group')), add(shown(column('time_error') / epsilon), strcol('case'))) nooutput

eval canvas('stability', 1.1)
set lmargin at screen 0.19
set rmargin at screen 0.76
set bmargin 4
set tmargin 3.2
set yrange [-families - 0.7 : -0.3]
set ytics scale 0
do for [k=1:families] {
  set ytics add (sprintf('%s (%d)', family[k], cases[k]) -k)
  set arrow from best[k], -k to worst[k], -k nohead linetype 4 linewidth 2
  set label sprintf('%s', name_of_worst[k]) at graph 1.02, first -k font ',18'
}
set logscale x
set xrange [0.05:1e9]
set xtics ('≤ 0.1' 0.1, '1' 1, '10^2' 1e2, '10^4' 1e4, '10^6' 1e6, '10^8' 1e8)
set xlabel 'error of event times / 2.2 × 10^{−16}'
set key at graph 1, screen 0.985 right top horizontal maxrows 1 samplen 1.5
set label 'worst case' at graph 1.02, screen 0.96
set arrow from 1e-10 / epsilon, graph 0 to 1e-10 / epsilon, graph 1 nohead linetype 3 linewidth 1.4
has_limit(word) = word ne 'grazing'
plot NaN with lines linetype 3 linewidth 1.4 title 'least limit 10^{−10}', \
  for [touch=0:1] families = 0, table using (shown(column('time_error') / epsilon)): \
    (has_limit(strcol('truth')) == touch ? (row_of(strcol('group')), NaN) : row_of(strcol('group'))) \
    with points pointtype (touch ? 6 : 7) pointsize 1 linetype 1 title (touch ? 'touch' : 'case'), \
  families = 0, table using (strcol('verdict') eq 'pass' ? NaN : shown(column('time_error') / epsilon)): \
    (row_of(strcol('group'))) with points pointtype 2 pointsize 2 linetype 2 notitle  # a failed case is crossed out
unset output
