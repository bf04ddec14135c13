command_sensitivities <- function() {
  list(
    takes = "PLAN", does = "Report how much measures change with fields of the plan.",
    options = list(
      optparse::make_option("--of", metavar = "MEASURES", help = paste(
        "names of measures, such as \"total_drag_kN; door_spread_m\" [all]"
      )),
      optparse::make_option("--to", metavar = "FIELDS", help = paste(
        "fields of numbers, such as \"warps.length; towing.speed\" [those changed first]"
      )),
      optparse::make_option("--out", metavar = "FILE.csv", help = "where the table goes [-]"),
      set_option(), nodes_option(), netting_option()
    ),
    run = function(plan, options) {
      check_lattice_options(options)
      check_csv_out(options$out)
      found <- sensitivities(settle_changed(plan, options), parts_of(options$of),
        parts_of(options$to))
      give_csv(found, options$out)
    }
  )
}
