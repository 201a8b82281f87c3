# Beyond the border orbits: the impacts of the chatter against the distance, and the derived slope.
load 'figures/style.gp'

counts = data.'/border_cascade.csv'
names = system("awk -F, 'NR > 1 && $1 != last {print $1; last = $1}' '".counts."'")
factor = real(system("awk -F, 'NR == 2 {print $2}' '".data."/border_cascade_factor.csv'"))

of(name, value) = strcol('orbit') eq name ? value : NaN
color(name) = strstrt(name, 'mass_1') > 0 ? '#12355b' : '#c8442c'
mark(k) = word('7 5 9 11 13 6 4 8 10 12 2', k) + 0
omega(name) = system("awk -F, '$1 == \"".name."\" {printf \"%.7f\", $2; exit}' '".counts."'")

eval page('border_cascade', 1.6, 1)
size = 0.8
set xlabel '-log_{10} |Ω - Ω_{border}|'
set xrange [2:10.1]; set xtics 1
set ylabel 'impacts of the chatter'
set yrange [0:66]; set ytics 10
set key left top reverse Left samplen 1.5 maxrows 6 font ',17'
plot for [k = 1:words(names)] counts using (of(word(names, k), -log10(column('distance')))):'impacts' \
  with points pt mark(k) ps size lw 0.5 lc rgb color(word(names, k)) \
  title omega(word(names, k)).(strstrt(word(names, k), 'mass_1') > 0 ? ', mass 1' : ', mass 2'), \
  (x - 5.2) / -log10(factor) with lines lw 1.6 lc rgb '#0f5f40' title sprintf('derived slope, %.2f a decade', -1 / log10(factor))
