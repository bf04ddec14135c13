# Dissipation of the time scheme, as fractions of the physical dissipation and of the energy that
# the gear exchanges, above which it counts.
greatest_scheme_loss <- 0.05
greatest_energy_loss <- 0.01

define_finding("numerical dissipation", function(gear, trajectory) {
  lost <- energy_lost(trajectory$energy)[, length(trajectory$time)]
  share <- lost[["scheme"]] / lost[["physical"]]
  if (lost[["scheme"]] <= greatest_energy_loss * lost[["exchanged"]] ||
    share <= greatest_scheme_loss) return(list())
  label <- paste(figures(lost[["scheme"]]), "J")
  list(finding("numerical dissipation", "tow", lost[["scheme"]], label, energy = label,
    part = percent_text(lost[["scheme"]] / lost[["exchanged"]])))
})

# Length of adaptive steps (s) below which a finding reports them.
short_time_step <- 1e-3

define_finding("short time steps", function(gear, trajectory) {
  shortest <- trajectory$report$shortest_step
  if (trajectory$method$accuracy == 0 || shortest >= short_time_step) return(list())
  label <- paste(figures(1000 * shortest), "ms")
  list(finding("short time steps", "tow", shortest, label, step = label))
})
