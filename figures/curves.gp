# Multi-sliding and border orbits as curves in the plane of frequency and restitution, over the map
# of who sticks (atlas_omega_r.csv of the atlas, where it has been drawn): whole, and around the
# range of Figure 3.
load 'figures/style.gp'

map = data.'/atlas_omega_r.csv'
map_drawn = system("test -e '".map."' && echo 1") eq '1'
curves = data.'/atlas_curves.csv'
below = map_drawn ? map : curves
two = data.'/atlas_codimension_two.csv'
ends = data.'/atlas_curve_ends.csv'
names = system("awk -F, 'NR > 1 && $1 != last {print $1; last = $1}' '".curves."'")

# As in the atlas, paler.
of_sticks(one, two) = one > 0 && two > 0 ? 4 : two > 0 ? 3 : one > 0 ? 2 : 1
set palette defined (1 '#f2f2f2', 2 '#f6d9a8', 3 '#c5e4f5', 4 '#b2e0d2') maxcolors 4
set cbrange [0.5:4.5]
unset colorbox

of(name, value) = strcol('curve') eq name ? value : NaN
dashes(name) = strstrt(name, 'multi_sliding') > 0 ? 2 : 1
mass(name) = strstrt(name, 'mass_1') > 0 ? 1 : 2

do for [kind in 'png pdf'] {
  eval canvas(kind, 'curves', 2)
  set multiplot layout 2,1
  set tmargin 3.4
  set xlabel 'Ω'; set ylabel '{/:Italic r}'
  set key above left samplen 2 width 1 maxrows 2 font kind eq 'png' ? ',18' : ',8'
  do for [part = 0:1] {
    set label 1 (part == 0 ? '(a)' : '(b)') at graph -0.1, graph 1.1
    if (part == 0) { set xrange [0.2:0.8]; set yrange [0:0.98] } else { set xrange [0.25:0.5]; set yrange [0.64:0.78] }
    plot below using 'omega':'restitution':(map_drawn ? of_sticks(column('sticks1'), column('sticks2')) : NaN) with image notitle, \
      for [n in names] curves using (of(n, column('omega'))):'restitution' with lines lc rgb (mass(n) == 1 ? '#12355b' : '#c8442c') dt dashes(n) lw 1.6 notitle, \
      ends using (strcol('end') eq 'lost' ? column('omega') : NaN):'restitution' with points pt 2 ps 1 lw 1.4 lc rgb '#606060' title 'end', \
      two using 'omega':'restitution' with points pt 7 ps 1 lc rgb '#202020' title 'codimension two', \
      NaN with lines lc rgb '#12355b' lw 1.6 title 'border orbit, mass 1', \
      NaN with lines lc rgb '#c8442c' lw 1.6 title 'mass 2', \
      NaN with lines lc rgb '#12355b' dt 2 lw 1.6 title 'multi-sliding, mass 1', \
      NaN with lines lc rgb '#c8442c' dt 2 lw 1.6 title 'mass 2'
  }
  unset multiplot
  unset output
}
