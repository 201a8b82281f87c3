# Bifurcations as curves over maps of who sticks (the tables of the atlas, where it has been drawn):
# in frequency and restitution, whole and around the range of Figure 3, in frequency and amplitude,
# in the positions of the stops at the frequencies of Figure 5, and in frequency and restitution at
# the stops of Figure 5(b).
load 'figures/style.gp'

ends = data.'/atlas_curve_ends.csv'

# As in the atlas, paler.
of_sticks(one, two, dual) = dual > 0 ? 5 : one > 0 && two > 0 ? 4 : two > 0 ? 3 : one > 0 ? 2 : 1
set palette defined (1 '#f2f2f2', 2 '#f6d9a8', 3 '#c5e4f5', 4 '#b2e0d2', 5 '#a9c3dd') maxcolors 5
set cbrange [0.5:5.5]
unset colorbox

# Colour: the mass. Dashes: the kind. The keys are drawn as wide as their dashes need.
colour(name) = strstrt(name, 'mass_1') ? '#12355b' : '#c8442c'
of_kind(name, kind, value) = strstrt(name, kind) && strcol('curve') eq name ? value : NaN
ended(plane, value) = strcol('plane') eq plane && strcol('end') ne 'leaves the box' ? value : NaN

panels = 7
array plane[panels] = ['omega_r', 'omega_r', 'omega_A1', '5a', '5b', '5c', '5b_omega_r']
array table[panels] = ['', '', '_omega_A1', '_5a', '_5b', '_5c', '_5b_omega_r']
array x_name[panels] = ['Ω', 'Ω', 'Ω', '{/:Italic s}_1 at the frequency of Figure 5(a)', '{/:Italic s}_1 at the frequency of Figure 5(b)', '{/:Italic s}_1 at the frequency of Figure 5(c)', 'Ω at the stops of Figure 5(b)']
array y_name[panels] = ['{/:Italic r}', '{/:Italic r}', '{/:Italic A}_1', '{/:Italic s}_2', '{/:Italic s}_2', '{/:Italic s}_2', '{/:Italic r}']
array x_column[panels] = ['omega', 'omega', 'omega', 'stop1', 'stop1', 'stop1', 'omega']
array y_column[panels] = ['restitution', 'restitution', 'amplitude1', 'stop2', 'stop2', 'stop2', 'restitution']
array x_from[panels] = [0.2, 0.25, 0.2, 0.02, 0.02, 0.02, 0.298]
array x_to[panels] = [0.8, 0.5, 0.8, 0.6, 0.6, 0.6, 0.308]
array y_from[panels] = [0.0, 0.64, 0.02, 0.02, 0.02, 0.02, 0.0]
array y_to[panels] = [0.98, 0.78, 1.2, 0.6, 0.6, 0.6, 0.98]
row = 0.188

eval page('curves', 5, 1)
set tmargin 1.2
do for [k = 1:panels] {
  set label 1 '('.substr('abcdefg', k, k).')' at graph (k > 3 ? -0.2 : -0.1), graph 1.08
  set xlabel x_name[k]; set ylabel y_name[k]
  set xrange [x_from[k]:x_to[k]]; set yrange [y_from[k]:y_to[k]]
  set origin k == 5 || k == 7 ? 0.5 : 0.0, k > 5 ? 0.0 : k > 3 ? row : 0.95 - row * k
  set size k > 3 ? 0.5 : 1.0, row
  set xtics autofreq; if (k == 7) { set xtics 0.004 }
  if (k == 1) { set key at screen 0.98, screen 0.995 right top samplen 6 width 0 maxrows 3 font ',18' } else { unset key }
  map = data.'/atlas_'.plane[k].'.csv'
  curves = data.'/atlas_curves'.table[k].'.csv'
  map_drawn = system("test -e '".map."' && echo 1") eq '1'
  below = map_drawn ? map : curves
  names = system("awk -F, 'NR > 1 && $1 != last {print $1; last = $1}' '".curves."'")
  plot below using x_column[k]:y_column[k]:(map_drawn ? of_sticks(column('sticks1'), column('sticks2'), column('dual_sticking')) : NaN) with image notitle, \
    for [n in names] curves using (of_kind(n, 'border', column(x_column[k]))):y_column[k] with lines lc rgb colour(n) dt solid lw 1.6 notitle, \
    for [n in names] curves using (of_kind(n, 'multi_sliding', column(x_column[k]))):y_column[k] with lines lc rgb colour(n) dt (6, 3) lw 1.6 notitle, \
    for [n in names] curves using (of_kind(n, 'grazing', column(x_column[k]))):y_column[k] with lines lc rgb colour(n) dt (1.5, 2) lw 1.6 notitle, \
    ends using (ended(plane[k], column('x'))):'y' with points pt 7 ps 0.7 lc rgb '#202020' notitle, \
    (k == 5 || k == 6 ? x : NaN) with lines lc rgb '#202020' dt (8, 3, 2, 3) lw 1.2 notitle, \
    NaN with lines lc rgb '#12355b' dt solid lw 1.6 title 'border orbit, mass 1', \
    NaN with lines lc rgb '#c8442c' dt solid lw 1.6 title 'border orbit, mass 2', \
    NaN with lines lc rgb '#12355b' dt (6, 3) lw 1.6 title 'multi-sliding, mass 1', \
    NaN with lines lc rgb '#c8442c' dt (6, 3) lw 1.6 title 'multi-sliding, mass 2', \
    NaN with lines lc rgb '#c8442c' dt (1.5, 2) lw 1.6 title 'grazing, mass 2', \
    NaN with lines lc rgb '#202020' dt (8, 3, 2, 3) lw 1.2 title '{/:Italic s}_1 = {/:Italic s}_2', \
    NaN with points pt 7 ps 0.7 lc rgb '#202020' title 'end inside the plane'
}
